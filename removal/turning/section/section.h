// The half section of a part that turns about Z: closed loops in the plane (r, z), r >= 0. Lengths mm.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/geometry/types.h"
#include "core/path/toolpath.h"
#include "core/tool/insert.h"

namespace proveout {

/// Arcs of a section are chords that leave them by no more than this, mm.
inline constexpr double kSectionChordMm = 1e-4;

/// A closed polygon; material on its left, so outer borders go counter-clockwise and hollows clockwise.
struct SectionLoop {
  std::vector<Vec2> points;  ///< (r, z), r >= 0
  /// Of the edge from points[i] to the next: the motion that made it, kNoMotion where it is the blank's own
  /// or lies on the axis.
  std::vector<MotionId> motion;
};

/// A connected piece of material: a solid of revolution.
struct SectionBody {
  std::vector<SectionLoop> loops;  ///< the outer border first
  double volume_mm3 = 0.0;         ///< by Pappus' rule
  MotionId parted_by = kNoMotion;  ///< motion that cut it off; kNoMotion: it is held by the chuck
  bool by_parting = false;         ///< a programmed parting did
};

/// A thread tool on its helix: the outline goes from `from` to `to` in the plane while the part turns. A
/// point of the outline at (r, z) is, when the part of `u` of the way in 0..1 is done, at the angle
/// angleAt(u) about Z.
struct ThreadSweep {
  const ConvexOutline* outline = nullptr;       ///< control point at (0, 0)
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();  ///< control point, (r, z)
  double start_rad = 0.0;                       ///< angle about Z at the start, from +X towards +Y
  double turns = 0.0;  ///< signed: above 0 the tool goes round from +X towards +Y; of all the way
  /// Of the way s and the turns t, both counted from the start and in parts of the whole: s = t + bend * (t^2
  /// - t). 0 for constant lead; above 0 the lead grows.
  double bend = 0.0;
  MotionId motion = kNoMotion;

  /// The control point when the part `t` of the turns is done, 0..1.
  Vec2 at(double t) const { return from + (t + bend * (t * t - t)) * (to - from); }
  /// What reaches over the axis stands on the other side of it, half a turn on: there the sweep of the
  /// outline mirrored in r, which is for the caller to set.
  ThreadSweep acrossAxis() const {
    ThreadSweep across = *this;
    across.from.x() = -from.x();
    across.to.x() = -to.x();
    across.start_rad += kPi;
    return across;
  }
};

/// What turning made of a blank: the section, and threads that are cut into it.
struct TurnedShape {
  std::vector<SectionBody> bodies;
  std::vector<ThreadSweep> threads;  ///< outlines belong to `outlines`
  std::vector<std::shared_ptr<const ConvexOutline>> outlines;
};

/// Volume of the solid of revolution of a loop, mm3; negative for hollows.
double revolvedVolume(const std::vector<Vec2>& points);

}  // namespace proveout
