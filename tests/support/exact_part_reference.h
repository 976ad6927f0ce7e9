// What the part without a grid must be, for tests: the blank less many places of tools of radius 3.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/path/posed_way.h"
#include "removal/exact/swept_part.h"

namespace proveout::test {

inline constexpr double kReferenceRadius = 3.0;

inline const BoxShape kReferenceBlank{{0, 0, -10}, {40, 30, 0}};

/// Depth below the blank's surface, mm; below 0 outside.
inline double insideBlank(const Vec3& p) {
  return std::min((p - kReferenceBlank.min).minCoeff(), (kReferenceBlank.max - p).minCoeff());
}

/// Distance from tool 1, a flat end, or 2, a ball, at a pose, mm; below 0 inside.
inline double fromTool(int number, const Vec3& p, const ToolPose& pose) {
  constexpr double r = kReferenceRadius;
  const Vec3 q = p - pose.tip;
  const double z = q.dot(pose.axis), rho = (q - z * pose.axis).norm();
  if (number == 2) return z >= r ? rho - r : std::hypot(rho, z - r) - r;
  const Vec2 out(rho - r, -z);
  return out.cwiseMax(Vec2::Zero()).norm() + std::min(out.maxCoeff(), 0.0);
}

/// Settles a place that is near the surface, and asks where it came to. `Cuts` has a path, and
/// `nearest(p)`: the distance to the nearest of many places of the tools, and how far they are apart. True: a
/// motion made the surface there.
template <typename Cuts>
bool settles(const ExactPart& part, const Cuts& cuts, const Vec3& from) {
  if (std::abs(part.at(from, 1.0).value) > 0.3) return false;
  const SettledPoint at = settle(part, from, 1.0);
  if (!at.found) return false;
  const auto [tool, gap] = cuts.nearest(at.p);
  EXPECT_NEAR(std::min(insideBlank(at.p), tool), 0.0, at.residual + gap + 1e-5) << at.p.transpose();
  if (at.maker.motion == kNoMotion) return false;
  Cuts alone = cuts;
  alone.path.motions = {cuts.path.motions[at.maker.motion]};
  const auto [own, own_gap] = alone.nearest(at.p);
  EXPECT_NEAR(own, 0.0, at.residual + own_gap + 1e-5) << at.p.transpose();
  return true;
}

}  // namespace proveout::test
