#include "app/freed_pieces.h"

#include <algorithm>

#include "core/base/assert.h"
#include "core/mesh/shells.h"

namespace proveout {
namespace {

/// By how much of their height pieces are moved.
constexpr float kLift = 1.3f;

bool leavesUpwards(const std::string& leaves, double piece_mm3, double part_mm3) {
  if (leaves == "up" || leaves == "down") return leaves == "up";
  return piece_mm3 <= part_mm3;
}

}  // namespace

TriMesh withoutPieces(const TriMesh& mesh, const std::vector<TriMesh>& pieces) {
  std::vector<Box3> bounds;
  for (const TriMesh& piece : pieces) bounds.push_back(meshBounds(piece));
  std::uint32_t count = 0;
  const std::vector<std::uint32_t> shell = meshComponents(mesh, count);
  PROVEOUT_ASSERT(shell.size() == mesh.triangles.size());
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

TriMesh takenApart(const TriMesh& mesh, const std::vector<TriMesh>& pieces,
                   const std::vector<StockBody>& bodies) {
  TriMesh out = withoutPieces(mesh, pieces);
  const double part_mm3 = meshVolume(out);
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    TriMesh piece = pieces[k];
    const std::string leaves = k + 1 < bodies.size() ? bodies[k + 1].leaves : std::string();
    const float lift = leavesUpwards(leaves, meshVolume(piece), part_mm3) ? kLift : -kLift;
    const Eigen::Vector3f way(0.0f, 0.0f, lift * static_cast<float>(meshBounds(piece).size().z()));
    for (Eigen::Vector3f& p : piece.positions) p += way;
    append(out, piece);
  }
  return out;
}

}  // namespace proveout
