// Faces of a part found in the facets of its mesh.
#pragma once

#include <vector>

#include "core/mesh/cad_faces.h"
#include "core/mesh/tri_mesh.h"

namespace proveout {

struct FoundFaces {
  /// Planes, cylinders, cones, spheres and tori; what is none of these, but smooth, is of kOther. In the
  /// order of their first triangles, with their residuals.
  CadFaces faces;
  /// How far the facets of round faces leave these, mm.
  double chord_mm = 0.0;
  /// How exactly faces are known: what corners were allowed to be off, mm. From how the coordinates are
  /// rounded.
  double near_mm = 0.0;
};

/// Looks for faces in a closed, welded mesh: triangles in one plane become facets, regions of facets are
/// grown as long as their corners lie on one round face, which is fitted to them by least squares, and the
/// other facets are planes, or free-form where they go on smoothly into each other. Corners have to be as
/// exact as they are written: noise of a scan leaves no faces. A round face has three facets or more that
/// turn by no more than 42 degrees against each other and lie within 0.25 mm of it (0.12 mm where they turn
/// by more than 20): with chords of 0.02 mm radii from 0.3 mm on. Flats of coarser polygons stay planes.
/// Places, directions and sizes are round figures and those of other faces where the corners allow it.
/// Deterministic; time goes about with the number of triangles.
FoundFaces findFaces(const TriMesh& mesh);

}  // namespace proveout
