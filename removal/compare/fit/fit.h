// Brings a nominal to where the part lies: least squares over the surface.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/cad_faces.h"
#include "core/mesh/tri_mesh.h"
#include "removal/compare/comparison.h"
#include "removal/compare/fit/alignment.h"

namespace proveout {

/// Points of the part that a nominal is fitted to, mm, in the part's frame.
struct FitPoints {
  std::vector<Vec3> points;  ///< finite
  /// They lie on facets, which leave a curved face as far as those of the nominal do. False: on the surface
  /// itself.
  bool of_facets = false;
};

/// Points of a closed mesh, spread over its area, without what lies in ignored regions: at most `most`. Each
/// is put onto the exact part, where there is one, if that has surface within `reach_mm`. The same for the
/// same input, whatever the number of threads.
FitPoints fitPointsOf(const TriMesh& machined, const ExactPart* part, double reach_mm,
                      const std::vector<IgnoredRegion>& ignored, std::size_t most);

/// Looks for the motion of the nominal after which the part's points lie off its surface by the least sum of
/// squares (Gauss and Newton on the signed distances). Points that lie off by much more than most do count
/// less and then nothing (Tukey's biweight, at 4.7 times the standard deviation that the median of the
/// distances tells, not below 0.02 mm); those farther than twice `limit_mm` from the nominal never count.
/// Where many points crowd, each counts less: the fit is over the area. What the surface does not settle is
/// left as it was.
///
/// The motion may be larger than `limit_mm`: that is for the caller to judge by Alignment::moved_mm.
/// `nominal` closed; `faces`, which may be null, of its triangles. Errors, kInput: too few points are near
/// the nominal; kInterrupted.
Result<Alignment> fitNominal(const TriMesh& nominal, const CadFaces* faces, const FitPoints& part,
                             double limit_mm, Progress& progress);

/// The farthest that the motion takes a point of the mesh, mm.
double farthestMove(const RigidTransform& motion, const TriMesh& mesh);

/// By how much it turns, radians; exact for small turns, too.
double turnOf(const RigidTransform& motion);

/// The motion as a placement without scale, which says the same to rounding.
MeshPlacement placementOf(const RigidTransform& motion);

}  // namespace proveout
