#include "core/nc/flexnc/flexnc_expression.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/base/characters.h"
#include "core/geometry/types.h"
#include "core/nc/macro/formula.h"

namespace proveout::nc {

namespace {

char at(std::string_view text, std::size_t pos) { return pos < text.size() ? text[pos] : '\0'; }

double turnAngle(double degrees) { return degToRad(std::remainder(degrees, 360.0)); }

constexpr int kFlexEndRank = -1, kFlexSumRank = 0, kFlexProductRank = 1;
constexpr auto kFlexOperators = std::to_array<FormulaOperator>({
    {"+", kFlexSumRank, Operation::kAdd},
    {"-", kFlexSumRank, Operation::kSubtract},
    {"*", kFlexProductRank, Operation::kMultiply},
    {"//", kFlexEndRank, Operation::kEnd},  // a comment
    {"/", kFlexProductRank, Operation::kDivide},
});
constexpr auto kFlexFunctions = std::to_array<FormulaFunction>({
    {"SIN", [](double x, double& out) { return out = std::sin(turnAngle(x)), Refusal(); }},
    {"COS", [](double x, double& out) { return out = std::cos(turnAngle(x)), Refusal(); }},
    {"TAN", [](double x, double& out) { return out = std::tan(turnAngle(x)), Refusal(); }},
});

constexpr FormulaRules flexRules() {
  FormulaRules out;
  out.open = '(';
  out.close = ')';
  out.variable = '\0';
  out.comments = false;
  out.prefix_names = false;
  out.takes_blanks = true;
  out.refuses_zero = false;
  out.refuses_infinite = false;
  out.depth = FormulaDepth::kBrackets;
  out.argument = FormulaArgument::kBracketAtOnce;
  return out;
}

constexpr FormulaLanguage kFlexFormulas{flexRules(), FormulaRows(kFlexOperators),
                                        FormulaRows(kFlexFunctions)};

}  // namespace

Columns flexColumns(std::size_t from, std::size_t to) {
  return {static_cast<int>(from) + 1, static_cast<int>(std::max(to, from + 1)) + 1};
}

/// One expression on its way from text to value.
class FlexEvaluator::Formula : public FormulaParser<Formula> {
 public:
  Formula(FlexEvaluator& evaluator, std::string_view text, std::size_t pos)
      : FormulaParser(kFlexFormulas, text, pos, evaluator.reads_), evaluator_(evaluator) {}

  bool plainValue(Value& out) { return peek() == rules_.open ? bracket(out) : number(out.number); }

  // What the parser asks.
  bool fail(const FormulaFault& fault);
  bool variable(Value& out);
  bool special(int /*which*/, const FormulaFunction& /*function*/, Value& /*out*/) { return false; }
  bool otherName(Value& out);
  bool numberRead(std::size_t begin) { return peek() != ',' || noNumber(begin); }

 private:
  bool fail(const char* code, std::string message, std::size_t from, std::size_t to) {
    return evaluator_.fail(code, std::move(message), from, to);
  }
  bool noNumber(std::size_t begin);

  FlexEvaluator& evaluator_;
};

bool FlexEvaluator::fail(const char* code, std::string message, std::size_t from, std::size_t to) {
  error_ = {code, std::move(message), flexColumns(from, to)};
  return false;
}

bool FlexEvaluator::finite(double value, std::size_t from, std::size_t to) {
  return std::isfinite(value) ||
         fail("fnc-value", "the expression has no finite value: a division by 0 or a number too large", from,
              to);
}

bool FlexEvaluator::expression(std::string_view text, std::size_t& pos, double& out) {
  return read(text, pos, out, false);
}

bool FlexEvaluator::plainValue(std::string_view text, std::size_t& pos, double& out) {
  return read(text, pos, out, true);
}

bool FlexEvaluator::read(std::string_view text, std::size_t& pos, double& out, bool plain) {
  reads_.clear();
  odd_ = -1;
  const std::size_t from = pos;
  Formula formula(*this, text, pos);
  Value value;
  const bool good = plain ? formula.plainValue(value) : formula.formula(value);
  out = value.number;
  pos = formula.pos();
  return good && finite(out, from, pos);
}

bool FlexEvaluator::whole(std::string_view text, std::size_t& pos, int most, int& out) {
  const std::size_t from = pos;
  while (isDigit(at(text, pos))) ++pos;
  const auto parsed = std::from_chars(text.data() + from, text.data() + pos, out);
  if (pos > from && parsed.ec == std::errc() && out <= most) return true;
  return fail("fnc-syntax", fmt::format("a whole number of 0 to {} stands here", most), from, pos);
}

bool FlexEvaluator::Formula::fail(const FormulaFault& fault) {
  switch (fault.kind) {
    case Kind::kTooDeep:
      return fail("fnc-syntax", "the expression is nested too deep", fault.begin, fault.begin + 1);
    case Kind::kNoBracket:
      return fail("fnc-syntax", "')' is missing", fault.begin, i);
    case Kind::kNoArgument:
      return fail("fnc-syntax", fmt::format("{} takes its angle in parentheses, in degrees", fault.name),
                  fault.begin, fault.end);
    default:
      return noNumber(fault.begin);
  }
}

/// Whatever of digits and points stands at `begin`.
bool FlexEvaluator::Formula::noNumber(std::size_t begin) {
  i = begin;
  while (isDigit(peek()) || peek() == '.') ++i;
  if (peek() == ',')
    return fail("fnc-num", "numbers have a decimal point: write '.' in place of ','", begin, i + 1);
  return fail("fnc-num", "a number stands here, or an expression in parentheses", begin, i);
}

bool FlexEvaluator::Formula::otherName(Value& out) {
  const std::size_t from = i, end = behindLetters();
  std::string letters(text_.substr(from, end - from));
  std::transform(letters.begin(), letters.end(), letters.begin(), upper);
  if (letters == "P") return variable(out);
  i = end;
  return fail("fnc-unknown",
              fmt::format("unknown function {}: this control has SIN, COS, TAN and P variables", letters),
              from, end);
}

bool FlexEvaluator::Formula::variable(Value& out) {
  const std::size_t from = i++;
  int number = 0;
  if (!evaluator_.whole(text_, i, FlexVariables::kLast, number)) {
    return fail("fnc-syntax", fmt::format("P needs the number of a variable, 0 to {}", FlexVariables::kLast),
                from, i);
  }
  if (!FlexVariables::ofPrograms(number)) evaluator_.odd_ = number;
  const FlexVariables& variables = evaluator_.variables_;
  if (const std::uint32_t origin = variables.originOf(number); origin != 0) reads_.push_back(origin);
  out = {variables.value(number), false};
  return true;
}

}  // namespace proveout::nc
