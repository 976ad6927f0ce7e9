// What a leaning wire leaves of a blank: sections at as many heights as it takes, joined by triangles.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/tri_mesh.h"
#include "removal/wire/lean/lean_stretch.h"
#include "removal/wire/lean/level_section.h"

namespace proveout {

/// A connected piece.
struct LeanBody {
  double volume_mm3 = 0.0;  ///< Simpson's rule over exact sections
  TriMesh mesh;             ///< closed, one shell
};

struct LeanSolid {
  std::vector<LeanBody> bodies;  ///< the largest first
  /// From below; body_of[level][region] counts as `bodies`.
  std::vector<LevelSection> levels;
  std::vector<std::vector<std::uint32_t>> body_of;
  bool runs_through_itself = false;  ///< meshes of the bodies intersect themselves or each other
};

/// The blank less the kerfs. Between two levels the triangles leave the section by no more than
/// `tolerance` mm, as the section half way says, but where walls meet or part within 0.001 mm of height. Does
/// not depend on the number of threads. Errors: cancelled; walls that meet or part so that no surface could
/// be made.
Result<LeanSolid> leanSolid(const std::vector<PlaneLoop>& blank, const HeightSpan& span,
                            const std::vector<LeanStretch>& stretches, double tolerance, Progress& progress);

/// The level nearest to a height.
std::size_t levelAt(const LeanSolid& solid, double z);
/// What a body covers there, as polygons; empty: nothing.
std::vector<std::vector<Vec2>> outlineOf(const LeanSolid& solid, std::size_t body, double z);

}  // namespace proveout
