#include "app/deviation/shaded_vertices.h"

#include <limits>

#include "render/shading_normals.h"

namespace proveout {
namespace {

constexpr std::uint32_t kNoVertex = std::numeric_limits<std::uint32_t>::max();
/// Cosine of the angle between normals that nobody tells apart: 0.8 degrees.
constexpr float kSameNormal = 0.9999F;

/// Unit, whatever a triangle without area gives.
Eigen::Vector3f properNormal(const Eigen::Vector3f& normal) {
  const float length = normal.norm();
  return length > 0.5F ? Eigen::Vector3f(normal / length) : Eigen::Vector3f(0.0F, 0.0F, 1.0F);
}

}  // namespace

ShadedVertices shadedVertices(const DeviationMesh& mesh) {
  const render_detail::MeshNormals normals(TriMesh{mesh.positions, mesh.triangles, {}});
  ShadedVertices out;
  out.triangles.reserve(mesh.triangles.size());
  std::vector<std::uint32_t> first(mesh.positions.size(), kNoVertex), next;
  const auto vertexFor = [&](std::uint32_t vertex, const Eigen::Vector3f& normal) {
    std::uint32_t* link = &first[vertex];
    while (*link != kNoVertex) {
      if (out.normals[*link].dot(normal) > kSameNormal) return *link;
      link = &next[*link];
    }
    const auto made = static_cast<std::uint32_t>(out.vertex.size());
    *link = made;  // before `next` grows
    next.push_back(kNoVertex);
    out.vertex.push_back(vertex);
    out.normals.push_back(normal);
    return made;
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = vertexFor(mesh.triangles[t][k], properNormal(normals.corners[t][k]));
    out.triangles.push_back(corners);
  }
  return out;
}

}  // namespace proveout
