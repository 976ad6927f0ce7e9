// A mesh made ready to be compared, and the checks that both meshes of a comparison pass.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/mesh/cad_faces.h"
#include "core/mesh/tri_mesh.h"

namespace proveout {

/// A mesh that bounds a solid: closed, outward, welded.
struct PreparedMesh {
  TriMesh mesh;
  std::vector<std::string> notes;  ///< what was repaired or looks wrong, one sentence each; for a warning
  std::shared_ptr<const CadFaces> faces = {};  ///< where the file tells them
};

/// Makes a solid of a mesh as files bring it: nominal, blank or fixture. Repairs what is safe: equal vertices
/// are merged, collapsed and doubled triangles and strays without area dropped, cracks up to 1 micrometre
/// closed; facets with mixed orientation are made consistent; shells that are inside out are turned; bodies
/// that touch, overlap, lie in each other or stand no more than 5 micrometres apart are made one. Otherwise
/// refuses with kInput, and names the place: empty, not finite, an index out of range, a hole or a wider
/// crack, a shell that may be a body or a void, a surface that crosses itself, bodies that cannot be joined.
/// `name` stands in front of messages ("bracket.stl").
Result<PreparedMesh> prepareNominal(const TriMesh& mesh, const std::string& name);

/// An edge that does not bound a solid: not used as often one way as the other.
struct OpenEdges {
  std::size_t odd = 0;        ///< used an odd number of times: a hole, or a wall without thickness
  std::size_t opposed = 0;    ///< used an even number of times, but with mixed orientation
  Vec3 first = Vec3::Zero();  ///< the middle of the first of them, odd ones first
  bool closed() const { return odd + opposed == 0; }
};
OpenEdges findOpenEdges(const TriMesh& mesh);

/// What makes a mesh unusable before its edges are looked at: empty, not finite, beyond 1 km, bad index, two
/// equal indices.
std::optional<Error> findBadElements(const TriMesh& mesh, const std::string& name);

}  // namespace proveout
