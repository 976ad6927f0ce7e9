#include "core/nc/wl4/macro/wl4_expression.h"

#include <fmt/core.h>

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "core/base/characters.h"
#include "core/geometry/types.h"

namespace proveout::nc {

namespace {

bool isCapital(char c) { return c >= 'A' && c <= 'Z'; }

/// Whether `word` stands at `pos`; if so, `pos` goes behind it.
bool take(std::string_view text, std::size_t& pos, std::string_view word) {
  const std::size_t at = behindBlanks(text, pos);
  if (text.substr(at, word.size()) != word) return false;
  pos = at + word.size();
  return true;
}

double sinDeg(double x) {
  const double turn = std::fmod(x, 360.0);
  return std::fmod(turn, 180.0) == 0.0 ? 0.0 : std::sin(degToRad(turn));
}

double modulo(double x, double y) {
  const double rest = std::fmod(x, y);
  return rest < 0.0 ? rest + std::abs(y) : rest;
}

struct Function {
  std::string_view name;
  double (*value)(double);
};
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<Function, 13> kFunctions = {{
    {"ABS", [](double x) { return std::abs(x); }},
    {"SQRT", [](double x) { return x < 0.0 ? kNan : std::sqrt(x); }},
    {"EXP", [](double x) { return std::exp(x); }},
    {"LN", [](double x) { return x > 0.0 ? std::log(x) : kNan; }},
    {"SIN", [](double x) { return sinDeg(x); }},
    {"COS", [](double x) { return sinDeg(x + 90.0); }},
    {"TAN", [](double x) { return sinDeg(x) / sinDeg(x + 90.0); }},
    {"ASIN", [](double x) { return radToDeg(std::asin(x)); }},
    {"ACOS", [](double x) { return radToDeg(std::acos(x)); }},
    {"ATAN", [](double x) { return radToDeg(std::atan(x)); }},
    {"FIX", [](double x) { return std::floor(x); }},
    {"FUP", [](double x) { return std::ceil(x); }},
    {"ROUND", [](double x) { return std::round(x); }},
}};

}  // namespace

std::size_t behindBlanks(std::string_view text, std::size_t pos) {
  while (pos < text.size() && (text[pos] == ' ' || text[pos] == '\t')) ++pos;
  return pos;
}

bool Wl4Evaluator::fail(std::string message, std::size_t from, std::size_t to) {
  error_ = {std::move(message), {static_cast<int>(from) + 1, static_cast<int>(to) + 1}};
  return false;
}

void Wl4Evaluator::setDecimals(int decimals) { tolerance_ = 0.5 * std::pow(10.0, -decimals); }

bool Wl4Evaluator::evaluate(std::string_view text, std::size_t& pos, double& out) {
  depth_ = 0;
  last_number_ = {};
  reads_.clear();
  return logical(text, pos, out);
}

bool Wl4Evaluator::logical(std::string_view text, std::size_t& pos, double& out) {
  bool first = false;
  if (!comparison(text, pos, out, first)) return false;
  while (true) {
    const bool conjunction = take(text, pos, "AND");
    const bool exclusive = !conjunction && take(text, pos, "XOR");
    if (!conjunction && !exclusive && !take(text, pos, "OR")) return true;
    double right = 0.0;
    if (!comparison(text, pos, right, mixed_classes_)) return false;
    const bool a = isTrue(out), b = isTrue(right);
    const bool value = conjunction ? a && b : exclusive ? a != b : a || b;
    out = value ? 1.0 : 0.0;
  }
}

bool Wl4Evaluator::comparison(std::string_view text, std::size_t& pos, double& out, bool& used) {
  if (!sum(text, pos, out, used)) return false;
  while (true) {
    enum { kEqual, kUnequal, kLessEqual, kLess, kGreaterEqual, kGreater } what;
    if (take(text, pos, "==")) {
      what = kEqual;
    } else if (take(text, pos, "<>")) {
      what = kUnequal;
    } else if (take(text, pos, "<=")) {
      what = kLessEqual;
    } else if (take(text, pos, "<")) {
      what = kLess;
    } else if (take(text, pos, ">=")) {
      what = kGreaterEqual;
    } else if (take(text, pos, ">")) {
      what = kGreater;
    } else {
      return true;
    }
    used = true;
    double right = 0.0;
    if (!sum(text, pos, right, mixed_classes_)) return false;
    const bool equal = out == right || std::abs(out - right) < tolerance_, less = out < right;
    bool value = equal;
    if (what == kUnequal) value = !equal;
    if (what == kLess) value = less && !equal;
    if (what == kLessEqual) value = less || equal;
    if (what == kGreater) value = out > right && !equal;
    if (what == kGreaterEqual) value = out > right || equal;
    if (loops_ != nullptr) loops_->asked(conditionAt(text.data() + pos), std::abs(out - right), value);
    out = value ? 1.0 : 0.0;
  }
}

bool Wl4Evaluator::sum(std::string_view text, std::size_t& pos, double& out, bool& used) {
  if (!product(text, pos, out)) return false;
  while (true) {
    const bool minus = take(text, pos, "-");
    if (!minus && !take(text, pos, "+")) return true;
    used = true;
    double right = 0.0;
    if (!product(text, pos, right)) return false;
    out += minus ? -right : right;
  }
}

bool Wl4Evaluator::product(std::string_view text, std::size_t& pos, double& out) {
  if (!operand(text, pos, out)) return false;
  int powers = 0, others = 0;
  while (true) {
    enum { kPower, kTimes, kOver, kModulo } what;
    if (take(text, pos, "**")) {
      what = kPower;
    } else if (take(text, pos, "*")) {
      what = kTimes;
    } else if (take(text, pos, "/")) {
      what = kOver;
    } else if (take(text, pos, "MOD")) {
      what = kModulo;
    } else {
      return true;
    }
    ++(what == kPower ? powers : others);
    mixed_power_ = mixed_power_ || (powers > 0 && others > 0);
    double right = 0.0;
    if (!operand(text, pos, right)) return false;
    if (what == kPower) out = std::pow(out, right);
    if (what == kTimes) out *= right;
    if (what == kOver) out /= right;
    if (what == kModulo) out = modulo(out, right);
  }
}

bool Wl4Evaluator::operand(std::string_view text, std::size_t& pos, double& out) {
  if (++depth_ > kMaxDepth) return fail("the expression is nested too deep", pos, pos + 1);
  const bool minus = take(text, pos, "-");
  if (!minus) take(text, pos, "+");
  if (!unsignedOperand(text, pos, out)) return false;
  if (minus) out = -out;
  --depth_;
  return true;
}

bool Wl4Evaluator::unsignedOperand(std::string_view text, std::size_t& pos, double& out) {
  pos = behindBlanks(text, pos);
  const char c = pos < text.size() ? text[pos] : '\0';
  if (c == '#') return variable(text, pos, out);
  if (c == '(') return parenthesis(text, pos, out);
  if (isDigit(c) || c == '.') return number(text, pos, out);
  if (isCapital(c)) return function(text, pos, out);
  return fail("a number, a variable, a function or a parenthesis is missing here", pos, pos + 1);
}

bool Wl4Evaluator::number(std::string_view text, std::size_t& pos, double& out) {
  std::size_t end = pos;
  int points = 0, digits = 0;
  for (; end < text.size() && (isDigit(text[end]) || (text[end] == '.' && points == 0)); ++end) {
    ++(text[end] == '.' ? points : digits);
  }
  if (digits == 0) return fail("a number without digits", pos, end);
  std::from_chars(text.data() + pos, text.data() + end, out, std::chars_format::fixed);
  last_number_ = {pos, end};
  pos = end;
  return true;
}

bool Wl4Evaluator::parenthesis(std::string_view text, std::size_t& pos, double& out) {
  const std::size_t from = pos++;
  if (!logical(text, pos, out)) return false;
  if (!take(text, pos, ")")) return fail("')' is missing", from, pos + 1);
  return true;
}

bool Wl4Evaluator::reference(std::string_view text, std::size_t& pos, int& number) {
  const std::size_t from = pos;
  double value = 0.0;
  const char c = pos < text.size() ? text[pos] : '\0';
  if (isDigit(c)) {
    while (pos < text.size() && isDigit(text[pos]) && value < 1e6) value = 10.0 * value + (text[pos++] - '0');
  } else if (c == '(') {
    if (!parenthesis(text, pos, value)) return false;
  } else if (c == '#') {
    if (++depth_ > kMaxDepth) return fail("the expression is nested too deep", pos, pos + 1);
    int inner = 0;
    if (!reference(text, ++pos, inner)) return false;
    --depth_;
    const auto held = variables_.read(inner);
    if (!held) return fail(fmt::format("there is no variable #{}", inner), from, pos);
    value = *held;
  } else {
    return fail("the number of the variable is missing behind '#'", from, from + 1);
  }
  if (!(value > -0.5 && value < 1e6)) return fail("there is no variable of that number", from, pos);
  number = static_cast<int>(std::lround(value));
  return true;
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

bool Wl4Evaluator::variable(std::string_view text, std::size_t& pos, double& out) {
  const std::size_t from = pos++;
  int number = 0;
  if (!reference(text, pos, number)) return false;
  const std::size_t next = behindBlanks(text, pos);
  if (text.substr(next, 1) == "=" && text.substr(next, 2) != "==") {
    pos = next + 1;
    const std::size_t first = reads_.size();
    return operand(text, pos, out) && assignBehind(first, number, out, from, pos);
  }
  const auto held = variables_.read(number);
  if (!held) return fail(fmt::format("there is no variable #{}", number), from, pos);
  out = *held;
  if (const std::uint32_t origin = variables_.originOf(number); origin != 0) reads_.push_back(origin);
  return true;
}

bool Wl4Evaluator::function(std::string_view text, std::size_t& pos, double& out) {
  std::size_t end = pos;
  while (end < text.size() && isCapital(text[end])) ++end;
  const std::string_view name = text.substr(pos, end - pos);
  for (const Function& f : kFunctions) {
    if (f.name != name) continue;
    const std::size_t from = pos;
    pos = behindBlanks(text, end);
    if (text.substr(pos, 1) != "(") return fail("'(' is missing behind the function", from, end);
    double x = 0.0;
    if (!parenthesis(text, pos, x)) return false;
    out = f.value(x);
    if (name == "ATAN" && text.substr(pos, 2) == "/(") {  // of a quotient: all four quadrants
      double y = 0.0;
      if (!parenthesis(text, ++pos, y)) return false;
      out = radToDeg(std::atan2(x, y));
    }
    if (std::isnan(out) && !std::isnan(x)) {
      return fail(fmt::format("{} is not defined for {}", name, x), from, pos);
    }
    return true;
  }
  return fail(fmt::format("there is no function {}", name), pos, end);
}

}  // namespace proveout::nc
