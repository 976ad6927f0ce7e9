#include "core/nc/linuxcnc/macro/lcn_expression.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/nc/linuxcnc/macro/formulas.h"
#include "core/nc/linuxcnc/macro/lcn_variables.h"
#include "core/nc/macro/formula.h"

namespace proveout::nc {
namespace {

/// What gives the values of the machine that a program asks for.
std::string lcnWhereFrom(std::string_view name) {
  const std::size_t close = name.find(']');
  if (name.starts_with("_hal[") && close != std::string_view::npos)
    return fmt::format(": give it in the job, [control.linuxcnc.hal] \"{}\" = 0", name.substr(5, close - 5));
  return name.starts_with("_ini[") ? ": the file that `ini` of [control.linuxcnc] names has it not" : "";
}

/// What alarms of operators and functions are called; texts as the interpreter has them.
LcnFault lcnRefusal(SharedAlarm refusal, std::string_view function) {
  switch (refusal) {
    case SharedAlarm::kDivision:
      return {"divide-by-zero", "Attempt to divide by zero"};
    case SharedAlarm::kRoot:
      return {"negative-root", "Negative argument to sqrt"};
    case SharedAlarm::kLogarithm:
      return {"logarithm", "Zero or negative argument to ln"};
    case SharedAlarm::kArcFunction:
      return {"arc-function",
              fmt::format("Argument to {} out of range", function == "ASIN" ? "asin" : "acos")};
    default:
      return {"value", "Calculation resulted in 'infinity' or 'not a number'"};
  }
}

class LcnFormula : public FormulaParser<LcnFormula> {
 public:
  LcnFormula(std::string_view text, std::size_t pos, LcnNames& names, LcnFault& fault,
             std::vector<std::uint32_t>& reads)
      : FormulaParser(linuxCncFormulas(), text, pos, reads), names_(names), fault_(fault) {}

  double distance = std::numeric_limits<double>::quiet_NaN();

  bool parameter(LcnParameter& out);

  // What the parser asks.
  bool fail(const FormulaFault& fault);
  bool variable(Value& out);
  bool special(int which, const FormulaFunction& function, Value& out);
  bool otherName(Value& out);
  void compared(const Value& left, const Value& right, bool /*holds*/) {
    distance = std::abs(left.number - right.number);
  }
  double tolerance() const { return 1e-6; }

 private:
  bool say(const char* name, std::string message, std::size_t begin) {
    fault_ = {name, std::move(message), begin, std::max(i, begin + 1)};
    return false;
  }
  bool nameHere(std::string_view& out);

  LcnNames& names_;
  LcnFault& fault_;
};

bool LcnFormula::fail(const FormulaFault& fault) {
  switch (fault.kind) {
    case Kind::kTooDeep:
      return say("nesting", "the expression is nested too deep", fault.begin);
    case Kind::kNoBracket: {
      if (peek() == '\0') return say("unclosed", "Unclosed expression", fault.begin);
      const std::size_t at = i++;
      return say("operation", "Unknown operation", at);
    }
    case Kind::kNoArgument:
      return say("left-bracket", "Left bracket missing after unary operation name", fault.begin);
    case Kind::kNoSecond:
      return say("slash",
                 peek() == '/' ? "Left bracket missing after slash with atan"
                               : "Slash missing after first atan argument",
                 fault.begin);
    case Kind::kOperation:
    case Kind::kFunction: {
      LcnFault refused = lcnRefusal(fault.refusal, fault.name);
      return say(refused.name, std::move(refused.message), fault.begin);
    }
    case Kind::kSecondPoint:
      return say("number", "bad number format: a second decimal point", fault.begin);
    default:
      return say("number",
                 peek() == '\0' ? "No characters found in reading real value"
                                : "bad number format: a value is expected",
                 fault.begin);
  }
}

bool LcnFormula::nameHere(std::string_view& out) {
  const std::size_t begin = i;
  const std::size_t close = text_.find('>', i);
  if (close == std::string_view::npos || close == i + 1) {
    i = close == std::string_view::npos ? text_.size() : close + 1;
    return say("parameter-name", "Named parameter not terminated: #<name>", begin);
  }
  out = text_.substr(i + 1, close - i - 1);
  i = close + 1;
  return true;
}

bool LcnFormula::parameter(LcnParameter& out) {
  const std::size_t begin = i++;  // the #
  out = {};
  if (peek() == '<') return nameHere(out.name);
  Value value;
  ++depth_;  // the recursion goes round by way of primary()
  const bool good = depth_ < rules_.most_depth ? primary(value)
                                               : say("nesting", "the expression is nested too deep", begin);
  --depth_;
  if (!good) return false;
  std::int64_t number = 0;
  if (!lcnInteger(value.number, number)) return say("integer", "Non integer value for integer", begin);
  if (!names_.hasParameter(static_cast<int>(number)))
    return say("parameter-number", "Parameter number out of range", begin);
  out.number = static_cast<int>(number);
  return true;
}

bool LcnFormula::variable(Value& out) {
  const std::size_t begin = i;
  LcnParameter asked;
  if (!parameter(asked)) return false;
  if (asked.number >= 0) {
    out = names_.parameter(asked.number);
  } else if (!names_.named(asked.name, out)) {
    return say("not-defined",
               fmt::format("Named parameter #<{}> not defined{}", asked.name, lcnWhereFrom(asked.name)),
               begin);
  }
  if (out.origin != 0) reads_.push_back(out.origin);
  return true;
}

/// EXISTS[#<name>]; numbered ones are there up to the last number.
bool LcnFormula::special(int /*which*/, const FormulaFunction& function, Value& out) {
  const std::size_t begin = i;
  i += function.text.size();
  LcnParameter asked;
  if (!take('[') || peek() != '#')
    return say("exists", "Missing a named parameter in brackets behind EXISTS: EXISTS[#<name>]", begin);
  const bool known = parameter(asked);
  if (!known && std::string_view(fault_.name) != "parameter-number") return false;
  if (!take(']')) return say("unclosed", "Unclosed expression", begin);
  Value value;
  const bool there = known && (asked.number >= 0 || names_.named(asked.name, value));
  out = {there ? 1.0 : 0.0, false};
  return true;
}

bool LcnFormula::otherName(Value& /*out*/) {
  const std::size_t begin = i;
  const char first = peek();
  i = behindLetters();
  return say("unknown-word", fmt::format("Unknown word starting with {}", first), begin);
}

}  // namespace

bool lcnInteger(double value, std::int64_t& out) {
  constexpr double kTolerance = 1e-4, kMost = 1e9;
  const double whole = std::round(value);
  if (!(std::abs(whole) <= kMost) || std::abs(value - whole) > kTolerance) return false;
  out = static_cast<std::int64_t>(whole);
  return true;
}

void LcnEvaluator::forget() {
  reads_.clear();
  distance_ = std::numeric_limits<double>::quiet_NaN();
}

bool LcnEvaluator::value(std::size_t& pos, Value& out) {
  LcnFormula parser(text_, pos, names_, fault_, reads_);
  const bool good = parser.operand(out);
  pos = parser.pos();
  return good;
}

bool LcnEvaluator::bracket(std::size_t& pos, Value& out) {
  if (pos >= text_.size() || text_[pos] != '[') {
    fault_ = {"left-bracket", "Left bracket missing: [expression] is expected here", pos, pos + 1};
    return false;
  }
  LcnFormula parser(text_, pos, names_, fault_, reads_);
  const bool good = parser.bracket(out);
  if (!std::isnan(parser.distance)) distance_ = parser.distance;
  pos = parser.pos();
  return good;
}

bool LcnEvaluator::parameter(std::size_t& pos, LcnParameter& out) {
  LcnFormula parser(text_, pos, names_, fault_, reads_);
  const bool good = parser.parameter(out);
  pos = parser.pos();
  return good;
}

}  // namespace proveout::nc
