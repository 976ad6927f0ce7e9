// What the machined part has in place of each face of the CAD model: least-squares fits.
#pragma once

#include <vector>

#include "removal/compare/exact_part.h"
#include "removal/compare/features/face_fit.h"
#include "removal/compare/sample_mesh.h"

namespace proveout {

/// Fits the part to the exact faces of the model, one result for each that has samples, in their order.
/// Planes: height and tilt; cylinders: radius, place and direction; cones: radius, angle and place; spheres:
/// radius and centre; tori: both radii and centre. Faces that go little round keep the model's place. The
/// places are `goal`'s triangles, at most some hundred a face; the part's surface is looked for along the
/// face's normal, some millimetres far, and has to look about the same way. Points far off what
/// most others fit are of another face and count as missed. Points and results are exact to the part's
/// accuracy.
std::vector<FaceFit> fitFaces(const SampleMesh& goal, const CadFaces& faces, const ExactPart& part);

}  // namespace proveout
