#include "core/nc/nct/formulas.h"

#include <array>

#include "core/nc/macro/expression.h"

namespace proveout::nc {
namespace {

constexpr int kNctSumRank = 1, kNctProductRank = 2;
constexpr auto kNctOperators = std::to_array<FormulaOperator>({
    {"+", kNctSumRank, Operation::kAdd},
    {"-", kNctSumRank, Operation::kSubtract},
    {"OR", kNctSumRank, Operation::kBitOr},
    {"XOR", kNctSumRank, Operation::kBitXor},
    {"*", kNctProductRank, Operation::kMultiply},
    {"/", kNctProductRank, Operation::kDivide},
    {"MOD", kNctProductRank, Operation::kModulo},
    {"AND", kNctProductRank, Operation::kBitAnd},
    {"EQ", 0, Operation::kEqual},
    {"NE", 0, Operation::kUnequal},
    {"GT", 0, Operation::kGreater},
    {"GE", 0, Operation::kGreaterEqual},
    {"LT", 0, Operation::kLess},
    {"LE", 0, Operation::kLessEqual},
});
constexpr auto kNctFunctions = std::to_array<FormulaFunction>({
    {"SIN", sine},
    {"SQRT", squareRoot},
    {"COS", cosine},
    {"TAN", tangent},
    {"ABS", absoluteValue},
    {"ASIN", arcSine},
    {"ACOS", arcCosine},
    {"ATAN", arcTangent},
    {"AXNUM", nullptr, nullptr, {}, kMacroAxisNumber},
    {"FIX", towardsZero},
    {"FUP", fromZero},
    {"EXP", exponential},
    {"LN", naturalLogarithm},
    {"NOT", bitComplement},
    {"PRM", nullptr, nullptr, {}, kMacroParameter},
});

constexpr FormulaRules nctRules() {
  FormulaRules out;
  out.formula_rank = kNctSumRank;
  out.vacant = VacantRelation::kAboveAll;
  return out;
}

constexpr FormulaLanguage kNctFormulas{nctRules(), FormulaRows(kNctOperators), FormulaRows(kNctFunctions)};

}  // namespace

const FormulaLanguage& nctFormulas() { return kNctFormulas; }

}  // namespace proveout::nc
