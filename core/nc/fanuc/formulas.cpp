#include "core/nc/fanuc/formulas.h"

#include <array>

namespace proveout::nc {
namespace {

constexpr int kFanucRelation = 0, kFanucSum = 1, kFanucProduct = 2;
constexpr auto kFanucOperators = std::to_array<FormulaOperator>({
    {"+", kFanucSum, Operation::kAdd},
    {"-", kFanucSum, Operation::kSubtract},
    {"OR", kFanucSum, Operation::kBitOr},
    {"XOR", kFanucSum, Operation::kBitXor},
    {"*", kFanucProduct, Operation::kMultiply},
    {"/", kFanucProduct, Operation::kDivide},
    {"MOD", kFanucProduct, Operation::kModulo},
    {"AND", kFanucProduct, Operation::kBitAnd},
    {"EQ", kFanucRelation, Operation::kEqual},
    {"NE", kFanucRelation, Operation::kUnequal},
    {"GT", kFanucRelation, Operation::kGreater},
    {"GE", kFanucRelation, Operation::kGreaterEqual},
    {"LT", kFanucRelation, Operation::kLess},
    {"LE", kFanucRelation, Operation::kLessEqual},
});
constexpr auto kFanucFunctions = std::to_array<FormulaFunction>({
    {"SIN", sine},
    {"SQRT", squareRoot},
    {"SQR", squareRoot},
    {"COS", cosine},
    {"TAN", tangent},
    {"ABS", absoluteValue},
    {"ASIN", arcSine},
    {"ACOS", arcCosine},
    {"ATAN", arcTangent, arcTangentOf, "/,"},
    {"FIX", towardsZero},
    {"FUP", fromZero},
    {"EXP", exponential},
    {"LN", naturalLogarithm},
    {"ROUND", nearest},
    {"RND", nearest},
});

constexpr FormulaRules fanucRules() {
  FormulaRules out;
  out.formula_rank = kFanucSum;
  out.vacant = VacantRelation::kOnlyEqual;
  return out;
}

constexpr FormulaLanguage kFanucFormulas{fanucRules(), FormulaRows(kFanucOperators),
                                         FormulaRows(kFanucFunctions)};

}  // namespace

const FormulaLanguage& fanucFormulas() { return kFanucFormulas; }

}  // namespace proveout::nc
