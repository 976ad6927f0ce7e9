// The finished profile of a template in the half plane (z, r), mm (digest flexnc, 5.3 and 6).
#pragma once

#include <optional>
#include <vector>

#include "core/nc/flexnc/cycles/cycle_call.h"
#include "core/nc/flexnc/template/template_table.h"

namespace proveout::nc {

/// What profile and passes need of a call whose letters are good.
struct TemplateInput {
  const TemplateRow& row;
  double side;        ///< +1 shaft, -1 hole
  bool convex;        ///< kPartArc, kQuarter
  double x, a;        ///< radii of the letters X and A, half their values
  double y, z, r, u;  ///< lengths of these letters
  double angle;       ///< of the letter G, radians
  double c, v;        ///< C, radial with its sign; V
};

/// From the start towards -z, and away from (shaft) or to (hole) the axis; neither turns back.
struct TemplateProfile {
  /// Not empty; pieces without length are left out. `source`: which element it is, from 0.
  PlaneContour elements;
  /// Radii where elements meet, from the end of the profile on.
  std::vector<double> junctions;
  bool before_face = false;  ///< it begins in front of the local face z = -V

  Vec2 start() const { return elements.front().from; }
  Vec2 end() const { return elements.back().to; }
};

/// The profile, or why there is none.
struct TemplateResult {
  std::optional<CycleNote> alarm;
  TemplateProfile profile;
};
TemplateResult templateProfile(const TemplateInput& input);

}  // namespace proveout::nc
