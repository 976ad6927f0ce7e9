#include "core/nc/macro/functions.h"

#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/geometry/degrees.h"

namespace proveout::nc {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

Refusal tanDegrees(double x, double& out) {
  constexpr double kNear = 1e-12;
  const double r = std::remainder(x, 180.0);
  if (std::abs(std::abs(r) - 90.0) <= kNear) return SharedAlarm::kTangent;
  out = std::abs(r) == 45.0 ? std::copysign(1.0, r) : std::tan(r * kDegree);
  return {};
}

/// The low 32 bits of an operand.
bool bitsOf(double x, std::uint32_t& bits) {
  constexpr double kLimit = 4294967295.0;
  const double whole = std::round(x);
  if (!(std::abs(x) <= kLimit) || !(std::abs(whole) <= kLimit)) return false;
  bits = static_cast<std::uint32_t>(static_cast<std::int64_t>(whole));
  return true;
}

double asNumber(std::uint32_t bits) { return static_cast<double>(static_cast<std::int32_t>(bits)); }

Refusal complement(double x, double& out) {
  std::uint32_t bits = 0;
  if (!bitsOf(x, bits)) return SharedAlarm::kBits;
  out = asNumber(~bits);
  return {};
}

}  // namespace

Refusal applyFunction(MacroFunction function, double x, double& out) {
  switch (function) {
    case MacroFunction::kSqrt:
      if (x < 0.0) return SharedAlarm::kRoot;
      out = std::sqrt(x);
      return {};
    case MacroFunction::kSin:
      out = sinDegrees(x);
      return {};
    case MacroFunction::kCos:
      out = cosDegrees(x);
      return {};
    case MacroFunction::kTan:
      return tanDegrees(x, out);
    case MacroFunction::kAsin:
    case MacroFunction::kAcos:
      if (!(std::abs(x) <= 1.0)) return SharedAlarm::kArcFunction;
      out = (function == MacroFunction::kAsin ? std::asin(x) : std::acos(x)) / kDegree;
      return {};
    case MacroFunction::kAtan:
      out = std::atan(x) / kDegree;
      return {};
    case MacroFunction::kExp:
      out = std::exp(x);
      return {};
    case MacroFunction::kLn:
      if (!(x > 0.0)) return SharedAlarm::kLogarithm;
      out = std::log(x);
      return {};
    case MacroFunction::kAbs:
      out = std::abs(x);
      return {};
    case MacroFunction::kFix:
      out = std::trunc(x);
      return {};
    case MacroFunction::kFup:
      out = x < 0.0 ? std::floor(x) : std::ceil(x);
      return {};
    case MacroFunction::kNot:
      return complement(x, out);
  }
  return {};
}

Refusal applyLogic(LogicOperator op, double a, double b, double& out) {
  std::uint32_t x = 0, y = 0;
  if (!bitsOf(a, x) || !bitsOf(b, y)) return SharedAlarm::kBits;
  switch (op) {
    case LogicOperator::kOr:
      out = asNumber(x | y);
      break;
    case LogicOperator::kXor:
      out = asNumber(x ^ y);
      break;
    case LogicOperator::kAnd:
      out = asNumber(x & y);
      break;
  }
  return {};
}

}  // namespace proveout::nc
