// Measures the characteristics of a part as a whole: on the exact part where there is one, else on its mesh.
#pragma once

#include <functional>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/tri_mesh.h"
#include "removal/compare/part/part_feature.h"

namespace proveout {

/// How a motion leaves its surface.
struct Pass {
  int tool = 0;
  double diameter_mm = 0.0;  ///< of the tool; 0: not known, or it is no solid of revolution
  /// Height of the marks that the feed of a lathe leaves (feed per turn and nose radius), which the part does
  /// not show; 0: none.
  double feed_mark_mm = 0.0;
};

struct MeasuredPart {
  const TriMesh& mesh;         ///< closed; with the motion of each triangle
  const ExactPart* exact;      ///< null: the mesh is all there is
  double mesh_error_mm = 0.0;  ///< how far the mesh may lie off the part
  double spacing_mm = 0.2;     ///< of samples, > 0
  bool clamped_again = false;  ///< what the mesh tells as the blank's may have been cut in another clamping
  std::function<Pass(const SurfaceMaker&)> pass;
};

/// What crests, radii and roughness of a part without an exact form are told as: they are not measured.
bool needsExactPart(Quantity quantity);

/// One result for each rule, in their order. The same for any number of threads. kInterrupted where
/// `progress` was cancelled.
///
/// Wall: the way through the material along the inward normal to a face that looks the other way to 45
/// degrees, at its least: found on samples and refined. Inner radius: of concave places across
/// their edge; corners sharper than 2 micrometres have 0. Skin: area that the blank's surface has. Crest:
/// between passes of one tool, above the line through the valleys to both sides, which are within a diameter.
/// Roughness: Ra over such a crest from valley to valley, of the passes and not of what tools leave beside;
/// of lathes by feed and nose radius.
Result<std::vector<PartFeature>> measurePart(const MeasuredPart& part, const std::vector<PartRule>& rules,
                                             Progress& progress);

}  // namespace proveout
