// What an outline covers on its way through the plane of the section.
#pragma once

#include <functional>
#include <vector>

#include "core/tool/convex_outline.h"
#include "removal/turning/section/section_area.h"

namespace proveout {

/// The control point's way in the plane (r, z), mm.
struct PlaneWay {
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();
  bool arc = false;
  Vec2 center = Vec2::Zero();
  double sweep_rad = 0.0;  ///< signed, from +r towards +z

  /// Direction of travel at 0..1, radians, from +r towards +z; of a standstill 0.
  double direction(double t) const;
  Vec2 at(double t) const;
  double length() const;  ///< mm; of an arc whose radius changes at least as long as it is
  /// From one part of it to another, 0..1.
  PlaneWay between(double from, double to) const;
  /// The same way on the other side of the axis.
  PlaneWay mirrored() const;
};

/// Polygons whose union (non-zero winding) is what `outline` sweeps, chords within kSectionChordMm of it. All
/// wind counter-clockwise, or over themselves in that sense.
std::vector<SectionPath> sweptPaths(const ConvexOutline& outline, const PlaneWay& way);

/// What those sides sweep that move into the material and for which `counts` says so: parallelograms, along
/// arcs one for each chord. `counts` gets the side and the direction of travel.
using SideFilter = std::function<bool(const OutlineSide& side, const Vec2& direction)>;
std::vector<SectionPath> sweptSides(const ConvexOutline& outline, const PlaneWay& way,
                                    const SideFilter& counts);

/// The paths mirrored at the axis, for parts of a sweep beyond it; only paths that reach there.
std::vector<SectionPath> mirroredPaths(const std::vector<SectionPath>& paths);

}  // namespace proveout
