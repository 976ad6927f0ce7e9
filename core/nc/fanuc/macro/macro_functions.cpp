#include "core/nc/fanuc/macro/macro_functions.h"

#include <cmath>
#include <cstdint>

namespace proveout::nc {
namespace {

constexpr int kBcdDigits = 8;
constexpr double kMostBcd = 99'999'999.0, kMostBcdBits = 2'576'980'377.0;  // 16#99999999
constexpr double kFullTurn = 360.0;

}  // namespace

Refusal fromBcd(double x, double& out) {
  const double whole = std::round(x);
  if (!(whole >= 0.0 && whole <= kMostBcdBits)) return SharedAlarm::kBits;
  out = 0.0;
  const auto bits = static_cast<std::uint64_t>(whole);
  for (int digit = kBcdDigits; digit-- > 0;) {
    const auto value = static_cast<double>(bits >> static_cast<unsigned>(4 * digit) & 0xFu);
    if (value > 9.0) return SharedAlarm::kBits;
    out = 10.0 * out + value;
  }
  return {};
}

Refusal toBcd(double x, double& out) {
  const double whole = std::round(x);
  if (!(whole >= 0.0 && whole <= kMostBcd)) return SharedAlarm::kBits;
  auto rest = static_cast<std::uint64_t>(whole);
  std::uint64_t bits = 0;
  for (unsigned digit = 0; digit < kBcdDigits; ++digit, rest /= 10) bits |= rest % 10 << 4 * digit;
  out = static_cast<double>(bits);
  return {};
}

Refusal powerOf(double x, double y, double& out) {
  out = std::pow(x, y);
  if (std::isnan(out) || (x == 0.0 && y < 0.0)) return SharedAlarm::kRoot;
  return {};
}

Refusal withPoint(double x, double& out) {
  out = x;
  return {};
}

Refusal arcSineOfTurn(double x, double& out) {
  const Refusal refused = arcSine(x, out);
  if (!refused && out < 0.0) out += kFullTurn;
  return refused;
}

Refusal arcTangentOfTurn(double y, double x, double& out) {
  const Refusal refused = arcTangentOf(y, x, out);
  if (!refused && out < 0.0) out += kFullTurn;
  return refused;
}

}  // namespace proveout::nc
