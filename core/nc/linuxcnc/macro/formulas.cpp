#include "core/nc/linuxcnc/macro/formulas.h"

#include <array>
#include <cmath>
#include <numbers>

namespace proveout::nc {
namespace {

/// At 90 degrees too the interpreter gives what the machine's tangent is there: a very large number.
Refusal lcnTangent(double x, double& out) {
  out = std::tan(x * std::numbers::pi / 180.0);
  return {};
}

constexpr int kLcnLogic = 1, kLcnRelation = 2, kLcnSum = 3, kLcnProduct = 4, kLcnPower = 5;
constexpr auto kLcnOperators = std::to_array<FormulaOperator>({
    {"+", kLcnSum, Operation::kAdd},
    {"-", kLcnSum, Operation::kSubtract},
    {"OR", kLcnLogic, Operation::kOr},
    {"XOR", kLcnLogic, Operation::kXor},
    {"**", kLcnPower, Operation::kPower},
    {"*", kLcnProduct, Operation::kMultiply},
    {"/", kLcnProduct, Operation::kDivide},
    {"MOD", kLcnProduct, Operation::kModuloPositive},
    {"AND", kLcnLogic, Operation::kAnd},
    {"EQ", kLcnRelation, Operation::kEqual},
    {"NE", kLcnRelation, Operation::kUnequal},
    {"GT", kLcnRelation, Operation::kGreater},
    {"GE", kLcnRelation, Operation::kGreaterEqual},
    {"LT", kLcnRelation, Operation::kLess},
    {"LE", kLcnRelation, Operation::kLessEqual},
});
constexpr auto kLcnFunctions = std::to_array<FormulaFunction>({
    {"SIN", sine},
    {"SQRT", squareRoot},
    {"COS", cosine},
    {"TAN", lcnTangent},
    {"ABS", absoluteValue},
    {"ASIN", arcSine},
    {"ACOS", arcCosine},
    {"ATAN", nullptr, arcTangentOf, "/"},
    {"FIX", downwards},
    {"FUP", upwards},
    {"EXP", exponential},
    {"EXISTS", nullptr, nullptr, "", 1},
    {"LN", naturalLogarithm},
    {"ROUND", nearest},
});

constexpr FormulaRules linuxCncRules() {
  FormulaRules out;
  out.whole_conditions = true;
  out.comments = false;  // formulas are read without them
  out.argument = FormulaArgument::kBracketAtOnce;
  out.exact_order = true;
  return out;
}

constexpr FormulaLanguage kLinuxCncFormulas{linuxCncRules(), FormulaRows(kLcnOperators),
                                            FormulaRows(kLcnFunctions)};

}  // namespace

const FormulaLanguage& linuxCncFormulas() { return kLinuxCncFormulas; }

}  // namespace proveout::nc
