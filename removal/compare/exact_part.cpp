#include "removal/compare/exact_part.h"

#include <cmath>

namespace proveout {

namespace {

/// A point this near is on the surface, mm.
constexpr double kAtRest = 1e-7;
/// Between faces that meet sharply each round takes a part of the way only.
constexpr int kRounds = 40;

}  // namespace

SettledPoint settle(const ExactPart& part, const Vec3& p, double reach) {
  SettledPoint out;
  out.p = p;
  for (int round = 0; round < kRounds; ++round) {
    const ExactPart::Sample s = part.at(out.p, reach);
    if (std::abs(s.value) >= reach) return out;
    out.residual = std::abs(s.value);
    if (s.value != 0.0 || round == 0) out.maker = s.maker;
    if (out.residual <= kAtRest) break;
    out.p -= s.value * s.normal;
    if ((out.p - p).squaredNorm() > reach * reach) return out;
  }
  out.found = true;
  out.residual += part.accuracy();
  return out;
}

}  // namespace proveout
