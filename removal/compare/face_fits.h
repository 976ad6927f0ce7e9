// What the machined part has in place of each face of the CAD model: least-squares fits.
#pragma once

#include <vector>

#include "core/mesh/cad_faces.h"
#include "removal/compare/comparison.h"
#include "removal/compare/sample_mesh.h"

namespace proveout {

/// Fits the part to the exact faces of the model, one result for each that has samples, in their order.
/// Planes: height and tilt; cylinders: radius and place, with the model's direction; spheres: radius and
/// centre; other faces: distances alone. The places are `goal`'s triangles, at most some hundred a face; each
/// is put onto the part's surface no farther off than `reach_mm`. Points and results are exact to the part's
/// accuracy.
std::vector<FaceFit> fitFaces(const SampleMesh& goal, const CadFaces& faces, const ExactPart& part,
                              double reach_mm);

}  // namespace proveout
