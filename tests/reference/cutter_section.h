// Cutters as a catalogue draws them: half sections of convex parts. All mm, tip at z = 0. Kept apart from the
// engine: nothing here uses its profiles.
#pragma once

#include <optional>
#include <vector>

#include "core/geometry/types.h"
#include "core/tool/tool.h"

namespace proveout::reference {

/// A convex part, from its lowest point up; it is closed flat at both ends.
struct Section {
  struct Piece {
    Vec2 to;                     ///< (r, z)
    std::optional<Vec2> center;  ///< of an arc that bulges outwards; none: a line
  };
  Vec2 start = Vec2::Zero();
  std::vector<Piece> pieces;

  Section& line(double r, double z);
  Section& arc(double center_r, double center_z, double r, double z);

  /// Signed distance of (r, z), r >= 0, to its boundary; below 0 inside. Exact.
  double distance(const Vec2& p) const;
  double widest() const;
};

/// What cuts is the union of these. Forms and corner radii of dovetails are not drawn.
std::vector<Section> sectionsOf(const Tool& tool);

/// Chords of a part of a circle that cut off and add as much of it as each other, each for itself: its ends
/// are on the circle, other points are farther from the center by `scale`.
struct TrueChords {
  std::vector<double> angle, scale;
  TrueChords(double from, double to, double step_rad);
  std::size_t size() const { return angle.size(); }
};

/// Heights with their radii (r, z), growing in z, r above 0. Arcs have chords of about `step_rad`.
std::vector<Vec2> levelsOf(const Section& section, double step_rad);

}  // namespace proveout::reference
