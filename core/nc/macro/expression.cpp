#include "core/nc/macro/expression.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "core/base/characters.h"
#include "core/nc/macro/formula.h"

namespace proveout::nc {
namespace {

/// A formula of a language whose variables are #n in a VariableStore.
class MacroFormula : public FormulaParser<MacroFormula> {
 public:
  MacroFormula(const FormulaLanguage& language, std::string_view text, std::size_t pos,
               VariableStore& variables, const MacroEnvironment& environment, const AlarmTable& alarms,
               LexError& error, std::vector<std::uint32_t>& reads)
      : FormulaParser(language, text, pos, reads),
        variables_(variables),
        environment_(environment),
        alarms_(alarms),
        error_(error) {
    reads_.clear();
  }

  bool in_assignment = false;       ///< PRM may stand here
  double steps = 1.0;               ///< of a unit, to which ROUND rounds
  double distance = 0.0;            ///< of the sides of the last relation; NaN where one was vacant
  ValueOrigins* origins = nullptr;  ///< of what assignment() writes; null: not wanted

  bool signedOperand(Value& out);
  bool variableNumber(int& number);
  bool assignment();

  // What the parser asks.
  bool fail(const FormulaFault& fault);
  bool variable(Value& out);
  bool special(int which, const FormulaFunction& name, Value& out) {
    if (which == kMacroRound) return rounded(name, out);
    return which == kMacroAxisNumber ? axisNumber(out) : parameter(out);
  }
  bool otherName(Value& out);
  void compared(const Value& left, const Value& right, bool holds);

 private:
  bool refused(const FormulaFault& fault);
  bool axisNumber(Value& out);
  bool parameter(Value& out);
  bool parameterArgument(int missing, int& out);
  bool symbol(int& number);
  bool namedVariable(int& number, bool& found);
  bool rounded(const FormulaFunction& name, Value& out);
  bool wholeNumber(const Value& value, std::size_t begin, int& out);
  bool accessed(VariableStatus status, int number, std::size_t begin);

  bool alarm(SharedAlarm what, std::string_view subject, std::string_view detail, std::size_t begin) {
    const std::size_t end = std::max(begin + 1, i);
    error_ = {alarms_.code(what),
              alarms_.message(what, subject, detail),
              {static_cast<int>(begin) + 1, static_cast<int>(end) + 1}};
    return false;
  }
  bool syntax(std::string_view detail, std::size_t begin) {
    return alarm(SharedAlarm::kSyntax, {}, detail, begin);
  }
  bool tooDeep(std::size_t begin) {
    return alarm(SharedAlarm::kFormulaDepth, {}, "the formula is nested too deep", begin);
  }
  /// A bracket that should stand at pos(); the text may end there.
  bool noBracket(std::string_view detail, std::size_t begin) {
    return i >= text_.size() ? alarm(SharedAlarm::kRightBracket, {}, {}, begin) : syntax(detail, i);
  }

  VariableStore& variables_;
  const MacroEnvironment& environment_;
  const AlarmTable& alarms_;
  LexError& error_;
  int relations_ = 0;
};

bool MacroFormula::fail(const FormulaFault& fault) {
  switch (fault.kind) {
    case Kind::kNoOperand:
      return syntax(peek() == '\0' ? "the formula ends where a value is expected"
                                   : "a number, a variable, a function or '[' is expected",
                    fault.begin);
    case Kind::kTooDeep:
      return tooDeep(fault.begin);
    case Kind::kNoBracket:
      if (rules_.whole_conditions && peek() == '=')
        return alarm(SharedAlarm::kTerminator, "= (EQ compares)", {}, i);
      return noBracket("an operator or ']' is expected", fault.begin);
    case Kind::kSecondPoint:
      return syntax("second decimal point", fault.begin);
    case Kind::kNoDigits:
      return syntax("a number without digits", fault.begin);
    case Kind::kBeyondRange:
      return syntax("a number beyond 1.7E308", fault.begin);
    case Kind::kNoArgument:
    case Kind::kNoSecond:
      return syntax(fmt::format("{} without its argument in brackets", fault.name), fault.begin);
    case Kind::kNoCondition:
      return syntax("a condition in brackets is expected", fault.begin);
    case Kind::kConditionGoesOn:
      return noBracket("']' is expected: a condition has one relation", fault.begin);
    case Kind::kNoRelation:
      if (peek() == '=') return alarm(SharedAlarm::kTerminator, "= (EQ compares)", {}, i);
      if (i >= text_.size()) return alarm(SharedAlarm::kRightBracket, {}, {}, i);
      return syntax("a condition has the form [value EQ value]", i);
    case Kind::kOperation:
    case Kind::kFunction:
      return refused(fault);
  }
  return false;
}

/// Of an operator, or of a function and its argument.
bool MacroFormula::refused(const FormulaFault& fault) {
  // The columns of a sum begin where the formula does, those of a product with its first sign.
  const std::size_t begin = fault.rank == rules_.formula_rank ? fault.entry : fault.begin;
  if (fault.refusal == SharedAlarm::kValueLimit)
    return alarm(fault.refusal, {}, "the result is beyond 1.7E308", begin);
  if (fault.kind == Kind::kFunction)
    return alarm(fault.refusal, {}, fmt::format("{} of {}", fault.name, fault.argument), begin);
  const bool bits = fault.refusal == SharedAlarm::kBits;
  return alarm(fault.refusal, {}, bits ? "an operand is beyond 32 bits" : "", begin);
}

void MacroFormula::compared(const Value& left, const Value& right, bool /*holds*/) {
  // Of several joined relations it is not known which one ends a loop.
  const bool known = !left.vacant && !right.vacant && ++relations_ == 1;
  distance = known ? std::abs(left.number - right.number) : std::numeric_limits<double>::quiet_NaN();
}

bool MacroFormula::signedOperand(Value& out) {
  passBlanks();
  const bool minus = peek() == '-';
  if (minus || peek() == '+') {
    ++i;
    passBlanks();
  }
  ++depth_;
  const bool good = primary(out);
  --depth_;
  if (minus) out.number = -out.number;
  return good;
}

bool MacroFormula::variable(Value& out) {
  const std::size_t begin = i;
  int number = 0;
  if (!variableNumber(number) || !accessed(variables_.read(number, out), number, begin)) return false;
  if (out.origin != 0) reads_.push_back(out.origin);
  return true;
}

bool MacroFormula::otherName(Value& /*out*/) {
  const std::size_t begin = i;
  i = behindLetters();
  return syntax(fmt::format("a value is expected, and {} is no function", text_.substr(begin, i - begin)),
                begin);
}

bool MacroFormula::rounded(const FormulaFunction& name, Value& out) {
  const std::size_t begin = i;
  i += name.text.size();
  passBlanks();
  if (peek() != rules_.open)
    return syntax(fmt::format("{} without its argument in brackets", name.text), begin);
  if (!bracket(out)) return false;
  out = {std::round(out.number * steps) / steps, false};
  return std::isfinite(out.number) || alarm(SharedAlarm::kValueLimit, {}, "the result is too large", begin);
}

bool MacroFormula::axisNumber(Value& out) {
  const std::size_t begin = i;
  i = skipBlanks(text_, i + 5);
  if (!take('[')) return syntax("AXNUM is followed by [name of an axis]", begin);
  i = skipBlanks(text_, i);
  std::array<char, 4> name{};
  std::size_t length = 0;
  for (; length < name.size() && (isLetter(peek()) || isDigit(peek())); ++i) name[length++] = upper(peek());
  i = skipBlanks(text_, i);
  const std::string_view shown(name.data(), length);
  if (!take(']')) {
    return i >= text_.size() ? alarm(SharedAlarm::kRightBracket, {}, {}, begin)
                             : syntax("AXNUM is followed by [name of an axis]", begin);
  }
  const int number = environment_.axisNumber(shown);
  if (number < 0) return alarm(SharedAlarm::kIllegalAddress, shown, "the channel has no such axis", begin);
  out = {static_cast<double>(number), false};
  return true;
}

bool MacroFormula::parameterArgument(int missing, int& out) {
  const std::size_t begin = i;
  Value value;
  if (!formula(value)) return false;
  if (!value.vacant) return wholeNumber(value, begin, out);
  out = missing;
  return true;
}

bool MacroFormula::parameter(Value& out) {
  const std::size_t begin = i;
  if (!in_assignment) {
    i += 3;
    return alarm(SharedAlarm::kIllegalAddress, "PRM",
                 "parameters are read on the right of an assignment only", begin);
  }
  i = skipBlanks(text_, i + 3);
  int number = -1, bit = -1, index = 0;
  if (!take('[')) return syntax("PRM is followed by [number]", begin);
  i = skipBlanks(text_, i);
  if (peek() == ']' || peek() == ',') return syntax("PRM without a number", begin);
  if (!parameterArgument(-1, number)) return false;
  if (number < 0) return syntax("PRM without a number", begin);
  i = skipBlanks(text_, i);
  if (take(',') && !parameterArgument(-1, bit)) return false;
  i = skipBlanks(text_, i);
  if (!take(']')) return alarm(SharedAlarm::kRightBracket, {}, {}, begin);
  const std::size_t slash = skipBlanks(text_, i);
  if (slash < text_.size() && text_[slash] == '/') {
    const std::size_t open = skipBlanks(text_, slash + 1);
    if (open < text_.size() && text_[open] == '[') {  // else it divides
      i = open + 1;
      if (!parameterArgument(0, index)) return false;
      i = skipBlanks(text_, i);
      if (!take(']')) return alarm(SharedAlarm::kRightBracket, {}, {}, begin);
    }
  }
  const MacroEnvironment::ParameterAnswer answer = environment_.parameter(number, bit, index);
  if (answer.alarm) return alarm(*answer.alarm, answer.subject, fmt::format("N{}", number), begin);
  out = {answer.value, false};
  return true;
}

bool MacroFormula::wholeNumber(const Value& value, std::size_t begin, int& out) {
  constexpr double kNear = 1e-6;
  const double whole = std::round(value.number);
  if (!(std::abs(whole) <= 1e9) || std::abs(whole - value.number) > kNear) {
    return alarm(SharedAlarm::kOutOfRange, "#", fmt::format("{} is no whole number in range", value.number),
                 begin);
  }
  out = static_cast<int>(whole);
  return true;
}

bool MacroFormula::accessed(VariableStatus status, int number, std::size_t begin) {
  if (status == VariableStatus::kDone) return true;
  if (status == VariableStatus::kReported) {
    error_.code.clear();
    return false;
  }
  constexpr int kLastWritten = 999'999'999;  // beyond stand variables that have a name only
  const std::string_view written = text_.substr(begin, i - begin);
  const std::string name =
      number <= kLastWritten ? fmt::format("#{}", number) : std::string(written.substr(0, written.find('=')));
  if (status == VariableStatus::kUnknown) {
    return alarm(SharedAlarm::kVariable, fmt::format("the control has no variable {}", name), {}, begin);
  }
  const bool locked = status == VariableStatus::kReadOnly;
  return alarm(locked ? SharedAlarm::kReadOnly : SharedAlarm::kValueLimit, name, {}, begin);
}

bool MacroFormula::variableNumber(int& number) {
  const std::size_t begin = i++;
  const char c = peek();
  if (isDigit(c)) {
    constexpr std::size_t kMaxDigits = 9;
    number = 0;
    for (; isDigit(peek()); ++i) {
      if (i - begin > kMaxDigits)
        return alarm(SharedAlarm::kVariable, "the control has no such variable", {}, begin);
      number = number * 10 + (text_[i] - '0');
    }
    return true;
  }
  if (c == '_') return symbol(number);
  if (c != '[') return syntax("'#' is followed by a number, a name or '['", begin);
  Value value;
  bool found = false;
  if (!namedVariable(number, found)) return false;
  if (found) return true;
  // The recursion goes round by way of primary(), which counts no operand.
  const int levels = rules_.depth == FormulaDepth::kOperands ? 1 : 0;
  depth_ += levels;
  const bool good = depth_ < rules_.most_depth ? bracket(value) : tooDeep(begin);
  depth_ -= levels;
  return good && wholeNumber(value, begin, number);
}

/// `#[NAME]` of SETVN and `#[_NAME]` or `#[_NAME[index]]` of the control; the bracket is at pos(). `found`:
/// whether a name stands there. False: it is none, reported.
bool MacroFormula::namedVariable(int& number, bool& found) {
  const std::size_t inside = skipBlanks(text_, i + 1);
  std::size_t end = inside;
  while (end < text_.size() && (isLetter(text_[end]) || isDigit(text_[end]) || text_[end] == '_')) ++end;
  if (end == inside || isDigit(text_[inside])) return true;
  const std::string_view name = text_.substr(inside, end - inside);
  const bool closed = end < text_.size() && text_[end] == rules_.close;
  if (const int named = closed ? variables_.named(name) : -1; named >= 0) {
    number = named;
    found = true;
    i = end + 1;
    return true;
  }
  if (name[0] != '_' || !rules_.bracket_names) return true;
  found = true;
  i = inside;
  if (!symbol(number)) return false;
  passBlanks();
  return take(rules_.close) || noBracket("']' is expected", inside);
}

bool MacroFormula::symbol(int& number) {
  const std::size_t begin = i - 1;
  std::size_t length = 0;
  const VariableSymbol* found = variables_.symbolAt(text_.substr(++i), length);
  if (found == nullptr) {
    while (isLetter(peek()) || isDigit(peek()) || peek() == '_') ++i;
    return alarm(SharedAlarm::kVariable,
                 fmt::format("the control has no variable {}", text_.substr(begin, i - begin)), {}, begin);
  }
  i += length;
  number = found->number;
  if (found->count == 0) return true;
  Value index;
  int at_index = 0;
  if (peek() != '[') return syntax(fmt::format("#_{} needs an index", found->name), begin);
  if (!bracket(index) || !wholeNumber(index, begin, at_index)) return false;
  const int offset = at_index - found->first_index;
  if (offset < 0 || offset >= found->count) {
    return alarm(SharedAlarm::kVariable, fmt::format("#_{} has no index {}", found->name, at_index), {},
                 begin);
  }
  number += offset;
  return true;
}

bool MacroFormula::assignment() {
  const std::size_t begin = i;
  int number = 0;
  if (!variableNumber(number)) return false;
  reads_.clear();
  i = skipBlanks(text_, i);
  if (!take('=')) return syntax("'=' is expected", i);
  in_assignment = true;
  Value value = Value::none();
  const std::size_t first = text_.find_first_not_of(" \t", i);
  const bool text_only =
      first != std::string_view::npos && text_[first] == '(' && variables_.takesText(number);
  if (!text_only && !formula(value)) return false;
  if (origins != nullptr) {
    const Columns columns{static_cast<int>(begin) + 1, static_cast<int>(i) + 1};
    value.origin = origins->assigned(columns, value.number, origins->listOf(reads_));
  }
  variables_.setNote(text_.substr(i));
  const VariableStatus status = variables_.write(number, value);
  return accessed(status, number, begin);
}

}  // namespace

bool MacroEvaluator::evaluate(std::string_view text, std::size_t& pos, Value& value, LexError& error) {
  MacroFormula parser(language_, text, pos, variables_, environment_, alarms_, error, reads_);
  const bool good = parser.signedOperand(value);
  pos = parser.pos();
  value.origin = origins_ != nullptr ? origins_->listOf(reads_) : 0;
  return good;
}

bool MacroEvaluator::evaluateWord(Address address, std::string_view text, std::size_t& pos, Value& value,
                                  LexError& error) {
  MacroFormula parser(language_, text, pos, variables_, environment_, alarms_, error, reads_);
  parser.steps = environment_.stepsPerUnit(address);
  const bool good = parser.signedOperand(value);
  pos = parser.pos();
  value.origin = origins_ != nullptr ? origins_->listOf(reads_) : 0;
  return good;
}

bool MacroEvaluator::formula(std::string_view text, std::size_t& pos, Value& value, LexError& error) {
  MacroFormula parser(language_, text, pos, variables_, environment_, alarms_, error, reads_);
  const bool good = parser.formula(value);
  pos = parser.pos();
  return good;
}

bool MacroEvaluator::condition(std::string_view text, std::size_t& pos, bool& holds, LexError& error) {
  MacroFormula parser(language_, text, pos, variables_, environment_, alarms_, error, reads_);
  const bool good = parser.condition(holds);
  if (good) distance_ = parser.distance;
  pos = parser.pos();
  return good;
}

bool MacroEvaluator::assign(std::string_view text, std::size_t& pos, LexError& error) {
  MacroFormula parser(language_, text, pos, variables_, environment_, alarms_, error, reads_);
  parser.origins = origins_;
  const bool good = parser.assignment();
  pos = parser.pos();
  return good;
}

bool MacroEvaluator::variable(std::string_view text, std::size_t& pos, int& number, LexError& error) {
  MacroFormula parser(language_, text, pos, variables_, environment_, alarms_, error, reads_);
  const bool good = parser.variableNumber(number);
  pos = parser.pos();
  return good;
}

}  // namespace proveout::nc
