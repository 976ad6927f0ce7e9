// Half sections of parts that turn about Z, and how far one profile is from another.
//
// The half plane is y = 0, x >= 0 of the workpiece frame; its points are (r, z) = (x, z). Lengths mm.
#pragma once

#include <array>
#include <vector>

#include "core/geometry/types.h"
#include "core/mesh/tri_mesh.h"
#include "removal/compare/compare.h"

namespace proveout {

using SectionSegment = std::array<Vec2, 2>;  ///< two points (r, z)

/// Where the mesh's triangles meet the half plane, in no order. Nothing lies on the axis: a solid that the
/// axis runs through is open there. A facetted wall between two of its vertices is inside of the true one.
std::vector<SectionSegment> halfSection(const TriMesh& mesh);

/// The same for a closed mesh as closed loops, closed along the axis too; every second region is material.
/// Chains that do not close (the mesh has holes) are closed by their chord.
std::vector<std::vector<Vec2>> halfSectionLoops(const TriMesh& mesh);

/// Distance of a point of the machined profile to the nominal.
struct SectionSample {
  Vec2 at = Vec2::Zero();       ///< (r, z)
  Vec2 nearest = Vec2::Zero();  ///< (r, z), of the nominal
  double deviation_mm = 0.0;    ///< > 0: material left over (outside of the nominal); < 0: gouge
  bool starts_stretch = false;  ///< the profile is broken off before it: a loop begins, or the axis
};

struct ProfileDeviations {
  std::vector<SectionSample> samples;                      ///< along the loops; at most kMaxProfileSamples
  double largest_gouge_mm = 0.0, largest_excess_mm = 0.0;  ///< >= 0, of the samples
  /// (r, z), the middle of the stretch that is as far off; zero where the figure is 0.
  Vec2 gouge_at = Vec2::Zero(), excess_at = Vec2::Zero();
};
inline constexpr std::size_t kMaxProfileSamples = 2000;

/// Samples the loops at their corners and evenly between, where they have
/// few enough corners, else evenly. Edges on the axis are no surface and left out. No samples without a
/// nominal, without a loop or with numbers that are not finite.
/// What lies in an ignored region gets no samples.
ProfileDeviations profileDeviations(const std::vector<std::vector<Vec2>>& machined,
                                    const std::vector<SectionSegment>& nominal,
                                    const std::vector<IgnoredRegion>& ignored = {});

}  // namespace proveout
