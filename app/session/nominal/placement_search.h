// A nominal that lies elsewhere than the part: where it would agree, judged by the surfaces.
#pragma once

#include <optional>
#include <string>

#include "app/session/nominal/placement_hint.h"
#include "core/mesh/tri_mesh.h"

namespace proveout {

/// Where a nominal agrees with a part, and how well.
struct FoundPlacement {
  MeshPlacement change;
  double before = 0.0, after = 0.0;  ///< shares of the nominal's surface that lie on the part's, 0..1
};

/// Tries units, quarter turns, and moves that bring sides or middles of the bounds together. None where no
/// such change brings most of the nominal's surface (60 %, and more than half of what lay off) to within
/// `within_mm` of the part's. Of places that agree equally well, as those of symmetric parts do, the one with
/// the least change. Both meshes closed and not empty; the same for the same input.
std::optional<FoundPlacement> searchPlacement(const TriMesh& nominal, const TriMesh& part, double within_mm);

/// What a nominal is held against.
struct PartSpace {
  const TriMesh& part;
  std::optional<Box3> blank;   ///< in the part's frame; none: no blank is known
  double within_mm = 0.05;     ///< surfaces this near to each other agree, > 0
  bool clamped_again = false;  ///< the part was moved between clampings: by a wrong move it lies elsewhere
};

/// What is to be said of where a nominal lies; empty text: nothing.
struct PlacementFault {
  std::string text;        ///< a sentence: what is wrong, and what to enter
  bool comparable = true;  ///< the deviations are worth telling
  bool rescaled = false;   ///< another unit is what it lacks
};

/// Judges where a nominal lies. It is not comparable where it does not lie as the part does and no wrong part
/// explains that: of a nominal that would have to be moved alone the zero may be wrong, where it lies inside
/// of the blank, or the move into a clamping.
PlacementFault placementFault(const TriMesh& nominal, const MeshPlacement& given, MeshUnit unit,
                              const PartSpace& space);

}  // namespace proveout
