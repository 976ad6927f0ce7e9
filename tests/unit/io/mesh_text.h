// Small meshes and the files that describe them.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace proveout::io_test {

/// Tetrahedron of volume 1/6 with a right angle at the origin, outward.
inline TriMesh tetrahedron() {
  TriMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

inline void append32(std::string& bytes, std::uint32_t word) {
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(word >> shift & 0xFF);
}

inline std::string binaryStl(const TriMesh& mesh, std::string header = "made by a test") {
  header.resize(80, ' ');
  append32(header, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& t : mesh.triangles) {
    header += std::string(12, '\0');
    for (const std::uint32_t corner : t) {
      for (int i = 0; i < 3; ++i) append32(header, std::bit_cast<std::uint32_t>(mesh.positions[corner][i]));
    }
    header += std::string(2, '\0');
  }
  return header;
}

inline const std::string kAsciiStl =
    "solid tet\n"
    "facet normal 0 0 -1\n outer loop\n  vertex 0 0 0\n  vertex 0 1 0\n  vertex 1 0 0\n endloop\nendfacet\n"
    "facet normal 0 -1 0\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 0 1\n endloop\nendfacet\n"
    "facet normal -1 0 0\n outer loop\n  vertex 0 0 0\n  vertex 0 0 1\n  vertex 0 1 0\n endloop\nendfacet\n"
    "facet normal 1 1 1\n outer loop\n  vertex 1 0 0\n  vertex 0 1 0\n  vertex 0 0 1\n endloop\nendfacet\n"
    "endsolid tet\n";

inline const std::string kObj =
    "# tetrahedron\nmtllib none.mtl\no tet\nv 0 0 0\nv 1 0 0\nv 0 1 0 1.0\nv 0 0 1\nvn 0 0 -1\nvt 0 0\ng a\n"
    "usemtl m\ns off\nf 1/1/1 3/1/1 2/1/1\nf 1//1 2//1 4//1\nf -4 -1 -2\nf 2 3 \\\n 4\n";

inline const std::string kPlyHeader =
    "ply\nformat ascii 1.0\ncomment x\nobj_info y\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property double z\nproperty uchar red\nelement face 4\nproperty list uchar int "
    "vertex_indices\nend_header\n";
inline const std::string kAsciiPly =
    kPlyHeader + "0 0 0 9\n1 0 0 9\n0 1 0 9\n0 0 1 9\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) return "nothing to replace";
  return text.replace(at, from.size(), to);
}

}  // namespace proveout::io_test
