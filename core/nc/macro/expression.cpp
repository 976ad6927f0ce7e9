#include "core/nc/macro/expression.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "core/base/characters.h"
#include "core/nc/macro/functions.h"

namespace proveout::nc {
namespace {

constexpr int kMaxDepth = 64;

struct FunctionName {
  std::string_view text;
  MacroFunction function;
};
constexpr auto kFunctions = std::to_array<FunctionName>({
    {"SIN", MacroFunction::kSin},
    {"COS", MacroFunction::kCos},
    {"TAN", MacroFunction::kTan},
    {"SQRT", MacroFunction::kSqrt},
    {"ABS", MacroFunction::kAbs},
    {"FIX", MacroFunction::kFix},
    {"FUP", MacroFunction::kFup},
    {"ASIN", MacroFunction::kAsin},
    {"ACOS", MacroFunction::kAcos},
    {"ATAN", MacroFunction::kAtan},
    {"EXP", MacroFunction::kExp},
    {"LN", MacroFunction::kLn},
    {"NOT", MacroFunction::kNot},
});

enum class Relation { kEq, kNe, kGt, kLt, kGe, kLe };
struct RelationName {
  std::string_view text;
  Relation relation;
};
constexpr auto kRelations = std::to_array<RelationName>({
    {"EQ", Relation::kEq},
    {"NE", Relation::kNe},
    {"GT", Relation::kGt},
    {"LT", Relation::kLt},
    {"GE", Relation::kGe},
    {"LE", Relation::kLe},
});

bool related(Relation relation, const Value& left, const Value& right) {
  constexpr double kAbove = std::numeric_limits<double>::infinity();
  const double a = left.vacant ? kAbove : left.number, b = right.vacant ? kAbove : right.number;
  switch (relation) {
    case Relation::kEq:
      return a == b;
    case Relation::kNe:
      return a != b;
    case Relation::kGt:
      return a > b;
    case Relation::kLt:
      return a < b;
    case Relation::kGe:
      return a >= b;
    case Relation::kLe:
      return a <= b;
  }
  return false;
}

/// One formula on its way from text to value.
class Parser {
 public:
  Parser(std::string_view text, std::size_t pos, VariableStore& variables,
         const MacroEnvironment& environment, const AlarmTable& alarms, LexError& error,
         std::vector<std::uint32_t>& reads)
      : i(pos),
        text_(text),
        variables_(variables),
        environment_(environment),
        alarms_(alarms),
        error_(error),
        reads_(reads) {
    reads_.clear();
  }

  std::size_t i;                    ///< the next character
  bool in_assignment = false;       ///< PRM may stand here
  ValueOrigins* origins = nullptr;  ///< of what assignment() writes; null: not wanted

  bool sum(Value& out);
  bool signedOperand(Value& out);
  bool variableNumber(int& number);
  bool condition(bool& holds, double& distance);
  bool assignment();

 private:
  bool product(Value& out);
  bool unary(Value& out);
  bool primary(Value& out);
  bool number(double& out);
  bool bracket(Value& out);
  bool named(Value& out);
  bool apply(const FunctionName& name, Value& out);
  bool axisNumber(Value& out);
  bool parameter(Value& out);
  bool parameterArgument(int missing, int& out);
  bool symbol(int& number);
  bool wholeNumber(const Value& value, std::size_t begin, int& out);
  bool relation(Relation& out);
  bool logic(LogicOperator op, Value& left, const Value& right, std::size_t begin);
  bool finite(double value, std::size_t begin, Value& out);

  char peek() const { return i < text_.size() ? text_[i] : '\0'; }
  bool at(std::string_view word) const { return keywordAt(text_, i, word); }
  bool take(char c) {
    if (peek() != c) return false;
    ++i;
    return true;
  }
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
  bool accessed(VariableStatus status, int number, std::size_t begin);

  std::string_view text_;
  VariableStore& variables_;
  const MacroEnvironment& environment_;
  const AlarmTable& alarms_;
  LexError& error_;
  std::vector<std::uint32_t>& reads_;
  int depth_ = 0;
};

bool Parser::finite(double value, std::size_t begin, Value& out) {
  if (!std::isfinite(value)) {
    return alarm(SharedAlarm::kValueLimit, {}, "the result is beyond 1.7E308", begin);
  }
  out = {value, false};
  return true;
}

bool Parser::logic(LogicOperator op, Value& left, const Value& right, std::size_t begin) {
  double out = 0.0;
  if (const auto refused = applyLogic(op, left.number, right.number, out)) {
    return alarm(*refused, {}, "an operand is beyond 32 bits", begin);
  }
  left = {out, false};
  return true;
}

bool Parser::sum(Value& out) {
  const std::size_t begin = i;
  if (!product(out)) return false;
  while (true) {
    const std::size_t behind = i;
    i = skipBlanks(text_, i);
    const char c = upper(peek());
    Value right;
    if (c == '+' || c == '-') {
      ++i;
      if (!product(right)) return false;
      if (!finite(c == '+' ? out.number + right.number : out.number - right.number, begin, out)) return false;
    } else if (c == 'O' && at("OR")) {
      i += 2;
      if (!product(right) || !logic(LogicOperator::kOr, out, right, begin)) return false;
    } else if (c == 'X' && at("XOR")) {
      i += 3;
      if (!product(right) || !logic(LogicOperator::kXor, out, right, begin)) return false;
    } else {
      i = behind;
      return true;
    }
  }
}

bool Parser::product(Value& out) {
  i = skipBlanks(text_, i);
  const std::size_t begin = i;
  if (!unary(out)) return false;
  while (true) {
    const std::size_t behind = i;
    i = skipBlanks(text_, i);
    const char c = upper(peek());
    Value right;
    if (c == '*') {
      ++i;
      if (!unary(right) || !finite(out.number * right.number, begin, out)) return false;
    } else if (c == '/' || (c == 'M' && at("MOD"))) {
      i += c == '/' ? 1 : 3;
      if (!unary(right)) return false;
      if (right.number == 0.0) return alarm(SharedAlarm::kDivision, {}, {}, begin);
      const double value = c == '/' ? out.number / right.number : std::fmod(out.number, right.number);
      if (!finite(value, begin, out)) return false;
    } else if (c == 'A' && at("AND")) {
      i += 3;
      if (!unary(right) || !logic(LogicOperator::kAnd, out, right, begin)) return false;
    } else {
      i = behind;
      return true;
    }
  }
}

bool Parser::unary(Value& out) {
  i = skipBlanks(text_, i);
  bool minus = false, any = false;
  const std::size_t begin = i;
  for (char c = peek(); c == '+' || c == '-'; c = peek()) {
    minus = minus != (c == '-');
    any = true;
    i = skipBlanks(text_, i + 1);
  }
  if (depth_ == kMaxDepth) return syntax("the formula is nested too deep", begin);
  ++depth_;
  const bool good = primary(out);
  --depth_;
  if (!good) return false;
  if (any) out = {minus ? -out.number : out.number, false};
  return true;
}

bool Parser::signedOperand(Value& out) {
  i = skipBlanks(text_, i);
  const bool minus = peek() == '-';
  if (minus || peek() == '+') i = skipBlanks(text_, i + 1);
  ++depth_;
  const bool good = primary(out);
  --depth_;
  if (minus) out.number = -out.number;
  return good;
}

bool Parser::primary(Value& out) {
  const char c = peek();
  if (c == '#') {
    const std::size_t begin = i;
    int number = 0;
    if (!variableNumber(number) || !accessed(variables_.read(number, out), number, begin)) return false;
    if (out.origin != 0) reads_.push_back(out.origin);
    return true;
  }
  if (isDigit(c) || c == '.') {
    out.vacant = false;
    return number(out.number);
  }
  if (c == '[') return bracket(out);
  if (isLetter(c)) return named(out);
  if (c == '\0') return syntax("the formula ends where a value is expected", i);
  return syntax("a number, a variable, a function or '[' is expected", i);
}

bool Parser::number(double& out) {
  constexpr std::array<double, 16> kTens{1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                         1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  const std::size_t begin = i;
  std::uint64_t mantissa = 0;
  std::size_t digits = 0, fraction = 0;
  bool point = false;
  for (; i < text_.size(); ++i) {
    const char c = text_[i];
    if (c == '.') {
      if (point) return syntax("second decimal point", begin);
      point = true;
    } else if (isDigit(c)) {
      if (digits < kTens.size()) mantissa = mantissa * 10 + static_cast<unsigned>(c - '0');
      ++digits;
      fraction += point;
    } else {
      break;
    }
  }
  if (digits == 0) return syntax("a number without digits", begin);
  if (digits < kTens.size()) {
    out = static_cast<double>(mantissa) / kTens[fraction];
    return true;
  }
  const auto read = std::from_chars(text_.data() + begin, text_.data() + i, out, std::chars_format::fixed);
  if (read.ec != std::errc()) return syntax("a number beyond 1.7E308", begin);
  return true;
}

bool Parser::bracket(Value& out) {
  const std::size_t begin = i++;
  if (!sum(out)) return false;
  i = skipBlanks(text_, i);
  if (take(']')) return true;
  if (i >= text_.size()) return alarm(SharedAlarm::kRightBracket, {}, {}, begin);
  return syntax("an operator or ']' is expected", i);
}

bool Parser::named(Value& out) {
  for (const FunctionName& name : kFunctions) {
    if (at(name.text)) return apply(name, out);
  }
  if (at("AXNUM")) return axisNumber(out);
  if (at("PRM")) return parameter(out);
  const std::size_t begin = i;
  while (isLetter(peek())) ++i;
  return syntax(fmt::format("a value is expected, and {} is no function", text_.substr(begin, i - begin)),
                begin);
}

bool Parser::apply(const FunctionName& name, Value& out) {
  const std::size_t begin = i;
  i += name.text.size();
  Value argument;
  if (!unary(argument)) return false;
  double value = 0.0;
  if (const auto refused = applyFunction(name.function, argument.number, value)) {
    return alarm(*refused, {}, fmt::format("{} of {}", name.text, argument.number), begin);
  }
  return finite(value, begin, out);
}

bool Parser::axisNumber(Value& out) {
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

bool Parser::parameterArgument(int missing, int& out) {
  const std::size_t begin = i;
  Value value;
  if (!sum(value)) return false;
  if (!value.vacant) return wholeNumber(value, begin, out);
  out = missing;
  return true;
}

bool Parser::parameter(Value& out) {
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

bool Parser::wholeNumber(const Value& value, std::size_t begin, int& out) {
  constexpr double kNear = 1e-6;
  const double whole = std::round(value.number);
  if (!(std::abs(whole) <= 1e9) || std::abs(whole - value.number) > kNear) {
    return alarm(SharedAlarm::kOutOfRange, "#", fmt::format("{} is no whole number in range", value.number),
                 begin);
  }
  out = static_cast<int>(whole);
  return true;
}

bool Parser::accessed(VariableStatus status, int number, std::size_t begin) {
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

bool Parser::variableNumber(int& number) {
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
  ++depth_;  // the recursion goes round by way of primary()
  const bool good = depth_ < kMaxDepth ? bracket(value) : syntax("the formula is nested too deep", begin);
  --depth_;
  return good && wholeNumber(value, begin, number);
}

bool Parser::symbol(int& number) {
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

bool Parser::relation(Relation& out) {
  i = skipBlanks(text_, i);
  for (const RelationName& name : kRelations) {
    if (!at(name.text)) continue;
    i += name.text.size();
    out = name.relation;
    return true;
  }
  if (peek() == '=') return alarm(SharedAlarm::kTerminator, "= (EQ compares)", {}, i);
  if (i >= text_.size()) return alarm(SharedAlarm::kRightBracket, {}, {}, i);
  return syntax("a condition has the form [value EQ value]", i);
}

bool Parser::condition(bool& holds, double& distance) {
  i = skipBlanks(text_, i);
  const std::size_t begin = i;
  if (!take('[')) return syntax("a condition in brackets is expected", begin);
  Value left, right;
  Relation relation_between = Relation::kEq;
  if (!sum(left) || !relation(relation_between) || !sum(right)) return false;
  i = skipBlanks(text_, i);
  if (!take(']')) {
    return i >= text_.size() ? alarm(SharedAlarm::kRightBracket, {}, {}, begin)
                             : syntax("']' is expected: a condition has one relation", i);
  }
  holds = related(relation_between, left, right);
  const bool known = !left.vacant && !right.vacant;
  distance = known ? std::abs(left.number - right.number) : std::numeric_limits<double>::quiet_NaN();
  return true;
}

bool Parser::assignment() {
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
  if (!text_only && !sum(value)) return false;
  if (origins != nullptr) {
    const Columns columns{static_cast<int>(begin) + 1, static_cast<int>(i) + 1};
    value.origin = origins->assigned(columns, value.number, origins->listOf(reads_));
  }
  variables_.setNote(text_.substr(i));
  const VariableStatus status = variables_.write(number, value);
  return accessed(status, number, begin);
}

}  // namespace

std::size_t skipBlanks(std::string_view text, std::size_t pos) {
  while (pos < text.size()) {
    const char c = text[pos];
    if (c == ' ' || c == '\t') {
      ++pos;
    } else if (c == '(') {
      const std::size_t close = text.find(')', pos);
      if (close == std::string_view::npos) return pos;
      pos = close + 1;
    } else {
      return pos;
    }
  }
  return pos;
}

bool keywordAt(std::string_view text, std::size_t pos, std::string_view word) {
  if (pos + word.size() > text.size()) return false;
  for (std::size_t k = 0; k < word.size(); ++k) {
    if (upper(text[pos + k]) != word[k]) return false;
  }
  return true;
}

bool MacroEvaluator::evaluate(std::string_view text, std::size_t& pos, Value& value, LexError& error) {
  Parser parser(text, pos, variables_, environment_, alarms_, error, reads_);
  const bool good = parser.signedOperand(value);
  pos = parser.i;
  value.origin = origins_ != nullptr ? origins_->listOf(reads_) : 0;
  return good;
}

bool MacroEvaluator::formula(std::string_view text, std::size_t& pos, Value& value, LexError& error) {
  Parser parser(text, pos, variables_, environment_, alarms_, error, reads_);
  const bool good = parser.sum(value);
  pos = parser.i;
  return good;
}

bool MacroEvaluator::condition(std::string_view text, std::size_t& pos, bool& holds, LexError& error) {
  Parser parser(text, pos, variables_, environment_, alarms_, error, reads_);
  const bool good = parser.condition(holds, distance_);
  pos = parser.i;
  return good;
}

bool MacroEvaluator::assign(std::string_view text, std::size_t& pos, LexError& error) {
  Parser parser(text, pos, variables_, environment_, alarms_, error, reads_);
  parser.origins = origins_;
  const bool good = parser.assignment();
  pos = parser.i;
  return good;
}

bool MacroEvaluator::variable(std::string_view text, std::size_t& pos, int& number, LexError& error) {
  Parser parser(text, pos, variables_, environment_, alarms_, error, reads_);
  const bool good = parser.variableNumber(number);
  pos = parser.i;
  return good;
}

}  // namespace proveout::nc
