// What one motion of an upright wire covers of a level plane, by its middle line: straight lines and arcs of
// circles.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "core/base/result.h"
#include "core/geometry/types.h"
#include "core/path/toolpath.h"

namespace proveout {

/// The middle of the wire on its way, or on a part of it; mm, workpiece frame.
struct WireStretch {
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();
  Vec2 center = Vec2::Zero();  ///< of arcs
  double sweep_rad = 0.0;      ///< signed, counter-clockwise seen from +z; 0: a straight line
  double kerf_mm = 0.0;        ///< what is nearer to it is taken: radius of the wire and spark gap, > 0
  MotionId motion = kNoMotion;

  bool isArc() const { return sweep_rad != 0.0; }
  double radius() const { return (from - center).norm(); }  ///< of arcs
  /// Unit vector of travel; of a standstill +x.
  Vec2 directionAtStart() const;
  Vec2 directionAtEnd() const;
  Vec2 at(double t) const;  ///< 0..1
  double length() const;    ///< mm
};

/// A point of the front half of the kerf's circle, where the wire cuts: `across` of the half width to the
/// left, -1..1. Behind the front also a stretch that is shorter than the kerf is wide finds nothing left.
Vec2 onFront(const WireStretch& stretch, double t, double across);

/// The beginning of a stretch, up to a part of it; 0..1.
WireStretch beginningOf(const WireStretch& stretch, double part);

/// How far a list of stretches is cut.
struct CutTime {
  std::uint32_t cuts = 0;  ///< how many of them are cut whole
  double share = 0.0;      ///< and how much of the next one, 0 <= share < 1

  auto operator<=>(const CutTime&) const = default;
  /// The stretch that is cut last. Requires that something is cut.
  std::uint32_t last() const { return share > 0.0 ? cuts : cuts - 1; }
};
/// What is cut until then.
std::vector<WireStretch> cutUntil(const std::vector<WireStretch>& cuts, const CutTime& time);

/// Accuracy of what is searched for along stretches, mm of way.
inline constexpr double kWayMm = 1e-6;
/// The time between two at which `done` turns from false to true, to about kWayMm: it is true then. Requires
/// done(later) and earlier < later.
template <typename Done>
CutTime firstTime(const std::vector<WireStretch>& cuts, const CutTime& earlier, const CutTime& later,
                  const Done& done);

/// The part of a stretch that is nearest to a point.
enum class StretchPart : std::uint8_t { kFrom, kMiddle, kTo };
struct StretchDistance {
  double mm = 0.0;
  StretchPart part = StretchPart::kMiddle;
};
StretchDistance distanceTo(const WireStretch& stretch, const Vec2& p);

/// Bounds of the middle line at z = 0, exact for arcs.
Box3 boundsOf(const WireStretch& stretch);

/// Tracks of a wire that stands upright differ by no more, mm.
inline constexpr double kUprightMm = 1e-6;
/// Whether the wire stands upright all along the motion.
bool isUpright(const WireSweep& wire);

/// A point of a track, 0 <= t <= 1.
Vec2 pointOnTrack(const WireTrack& track, double t);

/// Adds the stretches of an upright motion. Arcs whose radius changes become arcs of circles that leave it by
/// no more than 0.00001 mm.
void addStretches(const WireTrack& track, double kerf_mm, MotionId motion, std::vector<WireStretch>& out);

template <typename Done>
CutTime firstTime(const std::vector<WireStretch>& cuts, const CutTime& earlier, const CutTime& later,
                  const Done& done) {
  // Whole stretches first, then the one on which it turns.
  std::uint32_t low = earlier.cuts, high = later.last() + 1;
  while (high - low > 1) {
    const std::uint32_t middle = low + (high - low) / 2;
    (done(CutTime{middle, 0.0}) ? high : low) = middle;
  }
  double before = low == earlier.cuts ? earlier.share : 0.0, behind = low == later.cuts ? later.share : 1.0;
  while ((behind - before) * cuts[low].length() > kWayMm) {
    const double middle = 0.5 * (before + behind);
    (done(CutTime{low, middle}) ? behind : before) = middle;
  }
  return behind < 1.0 ? CutTime{low, behind} : CutTime{low + 1, 0.0};
}

}  // namespace proveout
