#include "core/nc/flexnc/flexnc_expression.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/base/characters.h"
#include "core/geometry/types.h"

namespace proveout::nc {

namespace {

char at(std::string_view text, std::size_t pos) { return pos < text.size() ? text[pos] : '\0'; }

void passBlanks(std::string_view text, std::size_t& pos) {
  while (isBlank(at(text, pos))) ++pos;
}

/// The letters at `pos`, upper case.
std::string lettersAt(std::string_view text, std::size_t pos) {
  std::string letters;
  for (; isLetter(at(text, pos)); ++pos) letters += upper(text[pos]);
  return letters;
}

}  // namespace

Columns flexColumns(std::size_t from, std::size_t to) {
  return {static_cast<int>(from) + 1, static_cast<int>(std::max(to, from + 1)) + 1};
}

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
  reads_.clear();
  odd_ = -1;
  nested_ = 0;
  const std::size_t from = pos;
  return sum(text, pos, out) && finite(out, from, pos);
}

bool FlexEvaluator::plainValue(std::string_view text, std::size_t& pos, double& out) {
  reads_.clear();
  odd_ = -1;
  nested_ = 0;
  const std::size_t from = pos;
  return (at(text, pos) == '(' ? parenthesis(text, pos, out) : number(text, pos, out)) &&
         finite(out, from, pos);
}

bool FlexEvaluator::whole(std::string_view text, std::size_t& pos, int most, int& out) {
  const std::size_t from = pos;
  while (isDigit(at(text, pos))) ++pos;
  const auto parsed = std::from_chars(text.data() + from, text.data() + pos, out);
  if (pos > from && parsed.ec == std::errc() && out <= most) return true;
  return fail("fnc-syntax", fmt::format("a whole number of 0 to {} stands here", most), from, pos);
}

bool FlexEvaluator::sum(std::string_view text, std::size_t& pos, double& out) {
  if (!product(text, pos, out)) return false;
  for (;;) {
    passBlanks(text, pos);
    const char sign = at(text, pos);
    if (sign != '+' && sign != '-') return true;
    ++pos;
    double next = 0.0;
    if (!product(text, pos, next)) return false;
    out += sign == '+' ? next : -next;
  }
}

bool FlexEvaluator::product(std::string_view text, std::size_t& pos, double& out) {
  if (!operand(text, pos, out)) return false;
  for (;;) {
    passBlanks(text, pos);
    const char sign = at(text, pos);
    if (sign == '/' && at(text, pos + 1) == '/') return true;  // a comment
    if (sign != '*' && sign != '/') return true;
    ++pos;
    double next = 0.0;
    if (!operand(text, pos, next)) return false;
    out = sign == '*' ? out * next : out / next;
  }
}

bool FlexEvaluator::operand(std::string_view text, std::size_t& pos, double& out) {
  passBlanks(text, pos);
  const char c = at(text, pos);
  if (c == '(') return parenthesis(text, pos, out);
  if (isLetter(c)) return name(text, pos, out);
  if (c != '-' && c != '+') return number(text, pos, out);
  if (++nested_ > kMostNested) return fail("fnc-syntax", "the expression is nested too deep", pos, pos + 1);
  ++pos;
  const bool good = operand(text, pos, out);
  if (c == '-') out = -out;
  --nested_;
  return good;
}

bool FlexEvaluator::name(std::string_view text, std::size_t& pos, double& out) {
  const std::size_t from = pos;
  const std::string letters = lettersAt(text, pos);
  if (letters == "P") return variable(text, pos, out);
  pos += letters.size();
  const bool known = letters == "SIN" || letters == "COS" || letters == "TAN";
  if (!known) {
    return fail("fnc-unknown",
                fmt::format("unknown function {}: this control has SIN, COS, TAN and P variables", letters),
                from, pos);
  }
  if (at(text, pos) != '(')
    return fail("fnc-syntax", letters + " takes its angle in parentheses, in degrees", from, pos);
  if (!parenthesis(text, pos, out)) return false;
  const double angle = degToRad(std::remainder(out, 360.0));
  out = letters == "SIN" ? std::sin(angle) : letters == "COS" ? std::cos(angle) : std::tan(angle);
  return true;
}

bool FlexEvaluator::variable(std::string_view text, std::size_t& pos, double& out) {
  const std::size_t from = pos++;
  int number = 0;
  if (!whole(text, pos, FlexVariables::kLast, number)) {
    return fail("fnc-syntax", fmt::format("P needs the number of a variable, 0 to {}", FlexVariables::kLast),
                from, pos);
  }
  if (!FlexVariables::ofPrograms(number)) odd_ = number;
  if (const std::uint32_t origin = variables_.originOf(number); origin != 0) reads_.push_back(origin);
  out = variables_.value(number);
  return true;
}

bool FlexEvaluator::parenthesis(std::string_view text, std::size_t& pos, double& out) {
  const std::size_t from = pos++;
  if (++nested_ > kMostNested) return fail("fnc-syntax", "the expression is nested too deep", from, pos);
  if (!sum(text, pos, out)) return false;
  passBlanks(text, pos);
  if (at(text, pos) != ')') return fail("fnc-syntax", "')' is missing", from, pos);
  ++pos;
  --nested_;
  return true;
}

bool FlexEvaluator::number(std::string_view text, std::size_t& pos, double& out) {
  const std::size_t from = pos;
  int points = 0;
  while (isDigit(at(text, pos)) || at(text, pos) == '.') points += text[pos++] == '.' ? 1 : 0;
  if (at(text, pos) == ',')
    return fail("fnc-num", "numbers have a decimal point: write '.' in place of ','", from, pos + 1);
  const auto parsed = std::from_chars(text.data() + from, text.data() + pos, out);
  const bool digits = pos - from > static_cast<std::size_t>(points);
  if (digits && points <= 1 && parsed.ec == std::errc() && parsed.ptr == text.data() + pos) return true;
  return fail("fnc-num", "a number stands here, or an expression in parentheses", from, pos);
}

}  // namespace proveout::nc
