// Features of a nominal that was brought onto the part, told as the model has them.
#pragma once

#include "core/geometry/rigid_transform.h"
#include "core/mesh/cad_faces.h"
#include "core/mesh/tri_mesh.h"
#include "removal/compare/comparison.h"

namespace proveout {

/// Measures the features in the frame of the model before the alignment: there its holes lie at the numbers
/// of the drawing and its faces along the axes, so that x, y and z can be told. Fills `face_fits` and
/// `features`, and `nominal_faces` with the faces in that frame. `nominal`, `faces`: as they were aligned;
/// `motion`: that took them there; `spacing_mm` of the places, > 0. `part` in its own frame.
void measureInModelFrame(const TriMesh& nominal, const CadFaces& faces, const RigidTransform& motion,
                         const ExactPart& part, double spacing_mm, Comparison& comparison);

}  // namespace proveout
