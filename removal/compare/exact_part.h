// The machined part without a grid: what a comparison asks where a mesh is not exact enough.
#pragma once

#include <compare>
#include <cstdint>
#include <limits>

#include "core/geometry/types.h"
#include "core/path/toolpath.h"

namespace proveout {

/// What made a surface.
struct SurfaceMaker {
  static constexpr std::uint32_t kLastSetup = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t setup = kLastSetup;  ///< number of the clamping, from 0; or the last one
  MotionId motion = kNoMotion;       ///< kNoMotion: the blank's own surface
  auto operator<=>(const SurfaceMaker&) const = default;
};

/// A part as a function of space: material where its value is below 0. Thread-safe.
class ExactPart {
 public:
  virtual ~ExactPart() = default;

  struct Sample {
    /// Signed distance to the surface, mm: in the material exact; outside never more than the distance to the
    /// material (how deep one tool covers the point). No farther than `reach` to either side.
    double value = 0.0;
    Vec3 normal = Vec3::UnitZ();  ///< unit, out of the material; where the value grows
    SurfaceMaker maker;           ///< of the surface that the value is the distance of; none beyond `reach`
  };
  /// In the frame of the last clamping.
  virtual Sample at(const Vec3& p, double reach) const = 0;
  /// How far the surface that it tells may lie off the true one, mm.
  virtual double accuracy() const = 0;
};

/// A point of the surface.
struct SettledPoint {
  Vec3 p = Vec3::Zero();
  double residual = 0.0;  ///< how far it may be off the surface, mm
  SurfaceMaker maker;
  bool found = false;  ///< false: there is no surface within `reach`
};
/// The surface near `p`: from body to body until none covers the point. On an edge where `p` is beyond one.
SettledPoint settle(const ExactPart& part, const Vec3& p, double reach);

}  // namespace proveout
