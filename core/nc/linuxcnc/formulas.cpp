#include "core/nc/linuxcnc/formulas.h"

#include <array>

namespace proveout::nc {
namespace {

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
    {"TAN", tangent},
    {"ABS", absoluteValue},
    {"ASIN", arcSine},
    {"ACOS", arcCosine},
    {"ATAN", nullptr, arcTangentOf, "/"},
    {"FIX", downwards},
    {"FUP", upwards},
    {"EXP", exponential},
    {"LN", naturalLogarithm},
    {"ROUND", nearest},
});

constexpr FormulaRules linuxCncRules() {
  FormulaRules out;
  out.whole_conditions = true;
  out.argument = FormulaArgument::kBracket;
  return out;
}

constexpr FormulaLanguage kLinuxCncFormulas{linuxCncRules(), FormulaRows(kLcnOperators),
                                            FormulaRows(kLcnFunctions)};

}  // namespace

const FormulaLanguage& linuxCncFormulas() { return kLinuxCncFormulas; }

}  // namespace proveout::nc
