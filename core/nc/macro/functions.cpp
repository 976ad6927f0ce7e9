#include "core/nc/macro/functions.h"

#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/geometry/degrees.h"

namespace proveout::nc {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// The low 32 bits of an operand.
bool bitsOf(double x, std::uint32_t& bits) {
  constexpr double kLimit = 4294967295.0;
  const double whole = std::round(x);
  if (!(std::abs(x) <= kLimit) || !(std::abs(whole) <= kLimit)) return false;
  bits = static_cast<std::uint32_t>(static_cast<std::int64_t>(whole));
  return true;
}

double asNumber(std::uint32_t bits) { return static_cast<double>(static_cast<std::int32_t>(bits)); }

}  // namespace

Refusal squareRoot(double x, double& out) {
  if (x < 0.0) return SharedAlarm::kRoot;
  out = std::sqrt(x);
  return {};
}

Refusal sine(double x, double& out) {
  out = sinDegrees(x);
  return {};
}

Refusal cosine(double x, double& out) {
  out = cosDegrees(x);
  return {};
}

Refusal tangent(double x, double& out) {
  constexpr double kNear = 1e-12;
  const double r = std::remainder(x, 180.0);
  if (std::abs(std::abs(r) - 90.0) <= kNear) return SharedAlarm::kTangent;
  out = std::abs(r) == 45.0 ? std::copysign(1.0, r) : std::tan(r * kDegree);
  return {};
}

Refusal arcSine(double x, double& out) {
  if (!(std::abs(x) <= 1.0)) return SharedAlarm::kArcFunction;
  out = std::asin(x) / kDegree;
  return {};
}

Refusal arcCosine(double x, double& out) {
  if (!(std::abs(x) <= 1.0)) return SharedAlarm::kArcFunction;
  out = std::acos(x) / kDegree;
  return {};
}

Refusal arcTangent(double x, double& out) {
  out = std::atan(x) / kDegree;
  return {};
}

Refusal exponential(double x, double& out) {
  out = std::exp(x);
  return {};
}

Refusal naturalLogarithm(double x, double& out) {
  if (!(x > 0.0)) return SharedAlarm::kLogarithm;
  out = std::log(x);
  return {};
}

Refusal absoluteValue(double x, double& out) {
  out = std::abs(x);
  return {};
}

Refusal towardsZero(double x, double& out) {
  out = std::trunc(x);
  return {};
}

Refusal fromZero(double x, double& out) {
  out = x < 0.0 ? std::floor(x) : std::ceil(x);
  return {};
}

Refusal downwards(double x, double& out) {
  out = std::floor(x);
  return {};
}

Refusal upwards(double x, double& out) {
  out = std::ceil(x);
  return {};
}

Refusal nearest(double x, double& out) {
  out = std::round(x);
  return {};
}

Refusal bitComplement(double x, double& out) {
  std::uint32_t bits = 0;
  if (!bitsOf(x, bits)) return SharedAlarm::kBits;
  out = asNumber(~bits);
  return {};
}

Refusal arcTangentOf(double x, double y, double& out) {
  out = std::atan2(x, y) / kDegree;
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
