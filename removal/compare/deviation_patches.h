// Connected regions beyond tolerance, on both surfaces together.
#pragma once

#include <array>
#include <vector>

#include "removal/compare/measured_sides.h"

namespace proveout {

/// Which samples count as beyond the level: those whose deviation is, or those whose deviation may be.
enum class Beyond { kMeasured, kPossible };

/// The place of a region that is most surely beyond tolerance: its depth less its bound is the largest.
struct SurestPlace {
  double depth_mm = 0.0, bound_mm = 0.0, chord_mm = 0.0;  ///< as in DeviationPatch
  Vec3 where = Vec3::Zero(), normal = Vec3::Zero();
  double margin() const { return depth_mm - bound_mm; }
  /// Puts it into a patch in place of the deepest one.
  void tell(DeviationPatch& patch) const;
};

/// The deepest sample of the part's own surface: 0 deep where there is none. What a sample of the nominal
/// says of a deep deviation is as rough as the mesh.
struct MachinedSample {
  double depth_mm = 0.0;
  Vec3 where = Vec3::Zero();
  void deepen(const MachinedSample& by) {
    if (by.depth_mm > depth_mm) *this = by;
  }
};

/// A region with the samples that it is made of.
struct FoundPatch {
  DeviationPatch patch;
  SurestPlace surest;
  /// Depth times projected area, mm3, as either side has it: machined, nominal. They agree where the surfaces
  /// run side by side.
  std::array<double, 2> volumes{};
  std::vector<Vec3> places;  ///< some of its samples
  bool deepest_on_nominal = false;
  Vec3 opposite = Vec3::Zero();  ///< nearest point of the other surface to the deepest one
  MachinedSample machined;
};

/// Regions where the deviation of the kind exceeds `level_mm`, in a fixed order that depends on the input
/// alone. Volumes are those under the area: depth times projected area (see difference_volume.h). Asks
/// `part`, which may be null, who made what the mesh does not know.
std::vector<FoundPatch> findPatches(const BothSides& sides, DeviationKind kind, double level_mm,
                                    Beyond beyond, const ExactPart* part);

/// Puts a patch with makers of its own into another: sums, the deeper one's place, shares by area.
void joinPatch(const DeviationPatch& from, DeviationPatch& into);

}  // namespace proveout
