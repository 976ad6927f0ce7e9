#include "core/nc/wl4/macro/wl4_expression.h"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "core/base/characters.h"
#include "core/geometry/types.h"
#include "core/nc/macro/formula.h"

namespace proveout::nc {

namespace {

double sinDeg(double x) {
  const double turn = std::fmod(x, 360.0);
  return std::fmod(turn, 180.0) == 0.0 ? 0.0 : std::sin(degToRad(turn));
}
double cosDeg(double x) { return sinDeg(x + 90.0); }
double tanDeg(double x) { return sinDeg(x) / sinDeg(x + 90.0); }
double asinDeg(double x) { return radToDeg(std::asin(x)); }
double acosDeg(double x) { return radToDeg(std::acos(x)); }

/// Refused where the function has no value. What has none already goes through.
template <double (*kFunction)(double)>
Refusal defined(double x, double& out) {
  out = kFunction(x);
  return std::isnan(out) && !std::isnan(x) ? Refusal(SharedAlarm::kOutOfRange) : Refusal();
}

Refusal logarithm(double x, double& out) {
  return std::isnan(x) ? absoluteValue(x, out) : naturalLogarithm(x, out);
}
Refusal atanDeg(double x, double& out) {
  out = radToDeg(std::atan(x));
  return {};
}
/// Of a quotient: all four quadrants.
Refusal atanOf(double x, double y, double& out) {
  out = radToDeg(std::atan2(x, y));
  return std::isnan(out) && !std::isnan(x) ? Refusal(SharedAlarm::kOutOfRange) : Refusal();
}

constexpr int kWl4LogicRank = 0, kWl4RelationRank = 1, kWl4SumRank = 2, kWl4ProductRank = 3;
constexpr auto kWl4Operators = std::to_array<FormulaOperator>({
    {"AND", kWl4LogicRank, Operation::kAnd},
    {"OR", kWl4LogicRank, Operation::kOr},
    {"XOR", kWl4LogicRank, Operation::kXor},
    {"==", kWl4RelationRank, Operation::kEqual},
    {"<>", kWl4RelationRank, Operation::kUnequal},
    {"<=", kWl4RelationRank, Operation::kLessEqual},
    {"<", kWl4RelationRank, Operation::kLess},
    {">=", kWl4RelationRank, Operation::kGreaterEqual},
    {">", kWl4RelationRank, Operation::kGreater},
    {"+", kWl4SumRank, Operation::kAdd},
    {"-", kWl4SumRank, Operation::kSubtract},
    {"**", kWl4ProductRank, Operation::kPower},
    {"*", kWl4ProductRank, Operation::kMultiply},
    {"/", kWl4ProductRank, Operation::kDivide},
    {"MOD", kWl4ProductRank, Operation::kModuloPositive},
});
constexpr auto kWl4Functions = std::to_array<FormulaFunction>({
    {"ABS", absoluteValue},
    {"ASIN", defined<asinDeg>},
    {"ACOS", defined<acosDeg>},
    {"ATAN", atanDeg, atanOf},
    {"SQRT", squareRoot},
    {"SIN", defined<sinDeg>},
    {"EXP", exponential},
    {"LN", logarithm},
    {"COS", defined<cosDeg>},
    {"TAN", defined<tanDeg>},
    {"FIX", downwards},
    {"FUP", upwards},
    {"ROUND", nearest},
});

constexpr FormulaRules wl4Rules() {
  FormulaRules out;
  out.open = '(';
  out.close = ')';
  out.either_case = false;
  out.comments = false;
  out.many_signs = false;
  out.prefix_names = false;
  out.point_ends = true;
  out.quotient_blanks = false;
  out.refuses_zero = false;
  out.refuses_infinite = false;
  out.most_depth = 100;
  out.argument = FormulaArgument::kBracket;
  return out;
}

constexpr FormulaLanguage kWl4Formulas{wl4Rules(), FormulaRows(kWl4Operators), FormulaRows(kWl4Functions)};

}  // namespace

/// One expression on its way from text to value.
class Wl4Evaluator::Formula : public FormulaParser<Formula> {
 public:
  Formula(Wl4Evaluator& evaluator, std::string_view text, std::size_t pos)
      : FormulaParser(kWl4Formulas, text, pos, evaluator.reads_), evaluator_(evaluator) {}

  bool reference(int& number);

  // What the parser asks.
  bool fail(const FormulaFault& fault);
  bool variable(Value& out);
  bool special(int /*which*/, const FormulaFunction& /*function*/, Value& /*out*/) { return false; }
  bool otherName(Value& out);
  void taken(const FormulaOperator& op, const FormulaOperator* before, int lowest);
  void compared(const Value& left, const Value& right, bool holds);
  bool isTrue(double value) const { return evaluator_.isTrue(value); }
  double tolerance() const { return evaluator_.tolerance_; }
  bool numberRead(std::size_t begin) {
    evaluator_.last_number_ = {begin, i};
    return true;
  }

 private:
  bool fail(std::string message, std::size_t from, std::size_t to) {
    return evaluator_.fail(std::move(message), from, to);
  }
  bool held(int number, std::size_t from, Value& out);

  Wl4Evaluator& evaluator_;
};

bool Wl4Evaluator::fail(std::string message, std::size_t from, std::size_t to) {
  error_ = {std::move(message), {static_cast<int>(from) + 1, static_cast<int>(to) + 1}};
  return false;
}

void Wl4Evaluator::setDecimals(int decimals) { tolerance_ = 0.5 * std::pow(10.0, -decimals); }

bool Wl4Evaluator::evaluate(std::string_view text, std::size_t& pos, double& out) {
  last_number_ = {};
  reads_.clear();
  Formula formula(*this, text, pos);
  Value value;
  const bool good = formula.formula(value);
  out = value.number;
  pos = formula.pos();
  return good;
}

bool Wl4Evaluator::reference(std::string_view text, std::size_t& pos, int& number) {
  Formula formula(*this, text, pos);
  const bool good = formula.reference(number);
  pos = formula.pos();
  return good;
}

bool Wl4Evaluator::assignBehind(std::size_t first, int number, double value, std::size_t from,
                                std::size_t to) {
  std::uint32_t origin = 0;
  if (origins_ != nullptr) {
    const Columns columns{static_cast<int>(from) + 1, static_cast<int>(to) + 1};
    origin = origins_->assigned(columns, value, origins_->listOf(std::span(reads_).subspan(first)));
    reads_.resize(first);
    reads_.push_back(origin);
  }
  if (variables_.write(number, value, origin)) return true;
  return fail(number > Wl4Variables::kGlobals
                  ? fmt::format("#{} is a system variable: it can only be read", number)
                  : fmt::format("there is no variable #{}", number),
              from, to);
}

bool Wl4Evaluator::Formula::fail(const FormulaFault& fault) {
  const std::size_t from = fault.begin;
  switch (fault.kind) {
    case Kind::kTooDeep:
      return fail("the expression is nested too deep", fault.entry, fault.entry + 1);
    case Kind::kNoBracket:
      return fail("')' is missing", from, fault.end + 1);
    case Kind::kNoDigits:
      return fail("a number without digits", from, i);
    case Kind::kBeyondRange:
      return numberRead(from);  // counts as 0
    case Kind::kNoArgument:
      return fail("'(' is missing behind the function", from, fault.end);
    case Kind::kFunction:
      return fail(fmt::format("{} is not defined for {}", fault.name, fault.argument), from, i);
    default:
      return fail("a number, a variable, a function or a parenthesis is missing here", from, from + 1);
  }
}

/// Behind a comparison, AND, OR or XOR stands what binds closer; a power beside another operator of its rank.
void Wl4Evaluator::Formula::taken(const FormulaOperator& op, const FormulaOperator* before, int lowest) {
  if (op.rank < kWl4ProductRank) {
    evaluator_.mixed_classes_ = evaluator_.mixed_classes_ || lowest > kWl4LogicRank;
  } else if (before != nullptr && before->rank == kWl4ProductRank) {
    const bool mixed = (op.operation == Operation::kPower) != (before->operation == Operation::kPower);
    evaluator_.mixed_power_ = evaluator_.mixed_power_ || mixed;
  }
}

void Wl4Evaluator::Formula::compared(const Value& left, const Value& right, bool holds) {
  if (evaluator_.loops_ == nullptr) return;
  evaluator_.loops_->asked(conditionAt(text_.data() + i), std::abs(left.number - right.number), holds);
}

bool Wl4Evaluator::Formula::held(int number, std::size_t from, Value& out) {
  const auto value = evaluator_.variables_.read(number);
  if (!value) return fail(fmt::format("there is no variable #{}", number), from, i);
  out = {*value, false};
  return true;
}

bool Wl4Evaluator::Formula::reference(int& number) {
  const std::size_t from = i;
  Value value;
  const char c = peek();
  if (isDigit(c)) {
    while (isDigit(peek()) && value.number < 1e6) value.number = 10.0 * value.number + (text_[i++] - '0');
  } else if (c == rules_.open) {
    if (!bracket(value)) return false;
  } else if (c == rules_.variable) {
    if (depth_ >= rules_.most_depth) return failAt(Kind::kTooDeep, i);
    ++depth_;
    ++i;
    int inner = 0;
    if (!reference(inner)) return false;
    --depth_;
    if (!held(inner, from, value)) return false;
  } else {
    return fail("the number of the variable is missing behind '#'", from, from + 1);
  }
  if (!(value.number > -0.5 && value.number < 1e6))
    return fail("there is no variable of that number", from, i);
  number = static_cast<int>(std::lround(value.number));
  return true;
}

bool Wl4Evaluator::Formula::variable(Value& out) {
  const std::size_t from = i++;
  int number = 0;
  if (!reference(number)) return false;
  const std::size_t next = behindBlanks(text_, i);
  if (text_.substr(next, 1) == "=" && text_.substr(next, 2) != "==") {
    i = next + 1;
    const std::size_t first = reads_.size();
    return operand(out) && evaluator_.assignBehind(first, number, out.number, from, i);
  }
  if (!held(number, from, out)) return false;
  if (const std::uint32_t origin = evaluator_.variables_.originOf(number); origin != 0)
    reads_.push_back(origin);
  return true;
}

bool Wl4Evaluator::Formula::otherName(Value& /*out*/) {
  const std::size_t end = behindLetters();
  return fail(fmt::format("there is no function {}", text_.substr(i, end - i)), i, end);
}

}  // namespace proveout::nc
