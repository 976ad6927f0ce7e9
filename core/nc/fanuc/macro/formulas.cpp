#include "core/nc/fanuc/macro/formulas.h"

#include <array>

#include "core/nc/fanuc/macro/macro_functions.h"
#include "core/nc/macro/expression.h"

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

using UnaryFunction = Refusal (*)(double, double&);
using BinaryFunction = Refusal (*)(double, double, double&);
constexpr std::array<FormulaFunction, 20> functionsWith(UnaryFunction arc_sine, BinaryFunction arc_tangent) {
  return {{
      {"SIN", sine},
      {"SQRT", squareRoot},
      {"SQR", squareRoot},
      {"COS", cosine},
      {"TAN", tangent},
      {"ABS", absoluteValue},
      {"ADP", withPoint},
      {"ASIN", arc_sine},
      {"ACOS", arcCosine},
      {"ATAN", arcTangent, arc_tangent, "/,"},
      {"BIN", fromBcd},
      {"BCD", toBcd},
      {"FIX", towardsZero},
      {"FUP", fromZero},
      {"EXP", exponential},
      {"LN", naturalLogarithm},
      {"POW", nullptr, powerOf, ","},
      {"PRM", nullptr, nullptr, {}, kMacroParameter},
      {"ROUND", nullptr, nullptr, {}, kMacroRound},
      {"RND", nullptr, nullptr, {}, kMacroRound},
  }};
}
constexpr auto kFanucTurnFunctions = functionsWith(arcSineOfTurn, arcTangentOfTurn);
constexpr auto kFanucSignedFunctions = functionsWith(arcSine, arcTangentOf);

constexpr FormulaRules fanucRules() {
  FormulaRules out;
  out.many_signs = false;
  out.formula_rank = kFanucSum;
  out.vacant = VacantRelation::kOnlyEqual;
  out.whole_conditions = out.joins_relations = out.refuses_vacant_condition = true;
  out.bracket_names = true;
  out.argument = FormulaArgument::kBracket;
  // Controls take 5 brackets; deeper formulas mean the same.
  out.depth = FormulaDepth::kBrackets;
  out.most_depth = 20;
  return out;
}

constexpr FormulaLanguage kFanucTurn{fanucRules(), FormulaRows(kFanucOperators),
                                     FormulaRows(kFanucTurnFunctions)};
constexpr FormulaLanguage kFanucSigned{fanucRules(), FormulaRows(kFanucOperators),
                                       FormulaRows(kFanucSignedFunctions)};

}  // namespace

const FormulaLanguage& fanucFormulas(bool signed_angles) { return signed_angles ? kFanucSigned : kFanucTurn; }

}  // namespace proveout::nc
