// Brings a nominal to where the part lies by datum features.
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/mesh/cad_faces.h"
#include "core/mesh/tri_mesh.h"
#include "removal/compare/exact_part.h"
#include "removal/compare/fit/alignment.h"

namespace proveout {

/// The 3-2-1 of a plane and two holes, each fitted to the part by least squares: the plane settles two tilts
/// and the height, where the first hole's axis meets it the place in it, the second hole the turn.
/// `datums`: three points on the features, in this order, in the frame of `nominal`; the face that is nearest
/// to each is taken, no farther off than 1 mm. `faces` of the nominal's triangles. The part is asked within
/// some millimetres of the faces. Alignment::rms_mm is by how much the distance of the two holes differs from
/// the model's, which no motion takes away. Errors, kInput: not three points, a point on another kind of
/// face or on none whose surface is known, holes that are not across the plane or lie on one axis, a feature
/// that the part lacks.
Result<Alignment> alignByDatums(const TriMesh& nominal, const CadFaces& faces,
                                const std::vector<Vec3>& datums, const ExactPart& part);

}  // namespace proveout
