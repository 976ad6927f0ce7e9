// What a leaning wire does between two heights: straight pieces of its way, and where they are at a height.
#pragma once

#include <vector>

#include "core/path/toolpath.h"
#include "removal/wire/section/wire_stretch.h"

namespace proveout {

/// A piece of a motion on which the middle of the wire goes along a straight line at every height, by equal
/// shares; mm, workpiece frame.
struct LeanStretch {
  Vec2 from_low = Vec2::Zero(), to_low = Vec2::Zero();    ///< at the lower height
  Vec2 from_high = Vec2::Zero(), to_high = Vec2::Zero();  ///< at the upper one
  double radius_mm = 0.0;  ///< what is nearer to the wire's middle line is taken: radius and spark gap, > 0
  MotionId motion = kNoMotion;
};

/// A piece at one height. The wire leans there by lean = (dx/dz, dy/dz).
struct LevelStretch {
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();
  Vec2 lean_from = Vec2::Zero(), lean_to = Vec2::Zero();
  double radius_mm = 0.0;
  MotionId motion = kNoMotion;

  double length() const { return (to - from).norm(); }
  /// Unit vector of travel; of a standstill +x.
  Vec2 direction() const;
  /// How far the kerf reaches across, at most: half of the long axis of its ellipse, mm.
  double reach() const;
};

/// The heights between which a workpiece is cut, z_low < z_high, mm.
struct HeightSpan {
  double low = 0.0, high = 0.0;
  double length() const { return high - low; }
};

/// Adds the pieces of a motion. Their chords lie on both sides of arcs, so that areas keep, and leave them by
/// no more than 0.0002 mm within the span; where the wire turns about its own way the pieces are so short
/// that 64 rows of triangles between them leave the ruled surface by no more than `twist_mm` (> 0).
void addLeanStretches(const WireSweep& wire, const HeightSpan& span, double radius_mm, double twist_mm,
                      MotionId motion, std::vector<LeanStretch>& out);

/// What of the pieces is cut until then.
std::vector<LeanStretch> cutUntil(const std::vector<LeanStretch>& cuts, const CutTime& time);

/// All pieces at height z, in their order.
std::vector<LevelStretch> atHeight(const std::vector<LeanStretch>& pieces, const HeightSpan& span, double z);

/// The point of the kerf's border at a height that lies farthest in the direction `normal` (unit), from the
/// middle of the wire: the wire is a cylinder, its section an ellipse, longer along its lean.
Vec2 kerfSupport(const Vec2& normal, const Vec2& lean, double radius_mm);

}  // namespace proveout
