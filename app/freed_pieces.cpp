#include "app/freed_pieces.h"

#include <algorithm>

namespace proveout {

TriMesh withoutPieces(const TriMesh& mesh, const std::vector<TriMesh>& pieces) {
  std::vector<Box3> bounds;
  for (const TriMesh& piece : pieces) bounds.push_back(meshBounds(piece));
  std::uint32_t count = 0;
  const std::vector<std::uint32_t> shell = meshComponents(mesh, count);
  std::vector<Box3> shells(count);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t corner : mesh.triangles[t])
      shells[shell[t]].extend(mesh.positions[corner].cast<double>());
  }
  const auto isPiece = [&](const Box3& box) {
    return std::any_of(bounds.begin(), bounds.end(),
                       [&](const Box3& b) { return b.min == box.min && b.max == box.max; });
  };
  TriMesh out;
  out.positions = mesh.positions;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!isPiece(shells[shell[t]])) out.triangles.push_back(mesh.triangles[t]);
  }
  return out;
}

}  // namespace proveout
