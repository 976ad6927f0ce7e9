// The closed shells that a mesh of solids is made of, also where they share edges or vertices.
#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace proveout {

inline constexpr std::uint32_t kNoPartner = 0xFFFFFFFFu;
/// For each half-edge, 3 * triangle + corner, that of the triangle which goes on behind its edge; kNoPartner:
/// there is none. At edges of more than two triangles those go with each other that have material between
/// them; where solids overlap there, those that hang together at other edges.
std::vector<std::uint32_t> edgePartners(const TriMesh& mesh);

/// A mesh taken apart.
struct Shells {
  TriMesh mesh;                         ///< 2-manifold: vertices stand once for each fan of triangles
  std::vector<std::uint32_t> shell_of;  ///< per triangle
  std::uint32_t count = 0;
};

/// Requires that every edge is used as often one way as the other. At edges of more than two triangles those
/// belong together as edgePartners has it, so that solids which share a face, an edge or a vertex come apart,
/// also where they overlap. Order of triangles and `motion` stay.
Shells splitShells(const TriMesh& mesh);

/// Each shell as a mesh of its own.
std::vector<TriMesh> shellMeshes(const Shells& shells);

/// Appends a mesh; motions go along where both have them.
void append(TriMesh& mesh, const TriMesh& more);

}  // namespace proveout
