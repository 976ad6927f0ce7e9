#include "render/shading_normals.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"

namespace proveout::render_detail {
namespace {

/// For each vertex the triangle corners (3 * triangle + corner) that use it, in ascending order.
struct Fans {
  std::vector<std::uint32_t> first;  ///< vertices + 1
  std::vector<std::uint32_t> corners;
};

Fans buildFans(const TriMesh& mesh) {
  Fans fans;
  fans.first.assign(mesh.positions.size() + 1, 0);
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t v : triangle) ++fans.first[v + 1];
  }
  for (std::size_t v = 1; v < fans.first.size(); ++v) fans.first[v] += fans.first[v - 1];
  fans.corners.resize(mesh.triangles.size() * 3);
  PROVEOUT_ASSERT(fans.first.back() == fans.corners.size());
  std::vector<std::uint32_t> next(fans.first.begin(), fans.first.end() - 1);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::uint32_t c = 0; c < 3; ++c) fans.corners[next[mesh.triangles[t][c]]++] = 3 * t + c;
  }
  return fans;
}

float cornerAngle(const TriMesh& mesh, std::uint32_t corner) {
  const auto& triangle = mesh.triangles[corner / 3];
  const std::uint32_t c = corner % 3;
  const Eigen::Vector3f& p = mesh.positions[triangle[c]];
  const Eigen::Vector3f a = mesh.positions[triangle[(c + 1) % 3]] - p;
  const Eigen::Vector3f b = mesh.positions[triangle[(c + 2) % 3]] - p;
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

std::vector<Eigen::Vector3f> faceNormals(const TriMesh& mesh) {
  std::vector<Eigen::Vector3f> normals(mesh.triangles.size());
  parallelFor(std::size_t{0}, mesh.triangles.size(), [&](std::size_t t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const Vec3 p = mesh.positions[a].cast<double>();
    const Vec3 n = (mesh.positions[b].cast<double>() - p).cross(mesh.positions[c].cast<double>() - p);
    const double length = n.norm();
    normals[t] = length > 0 ? Eigen::Vector3f((n / length).cast<float>()) : Eigen::Vector3f::Zero().eval();
  });
  return normals;
}

std::vector<std::array<Eigen::Vector3f, 3>> cornerNormals(const TriMesh& mesh,
                                                          const std::vector<Eigen::Vector3f>& faces) {
  PROVEOUT_ASSERT(faces.size() == mesh.triangles.size());
  const Fans fans = buildFans(mesh);
  const float limit = static_cast<float>(std::cos(degToRad(kCreaseAngleDeg)));
  std::vector<float> angles(fans.corners.size());
  parallelFor(std::size_t{0}, angles.size(),
              [&](std::size_t c) { angles[c] = cornerAngle(mesh, static_cast<std::uint32_t>(c)); });
  std::vector<std::array<Eigen::Vector3f, 3>> normals(mesh.triangles.size());
  parallelFor(std::size_t{0}, mesh.triangles.size(), [&](std::size_t t) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t vertex = mesh.triangles[t][c];
      Eigen::Vector3f sum = Eigen::Vector3f::Zero();
      for (std::uint32_t k = fans.first[vertex]; k < fans.first[vertex + 1]; ++k) {
        const Eigen::Vector3f& other = faces[fans.corners[k] / 3];
        if (other.dot(faces[t]) >= limit) sum += other * angles[fans.corners[k]];
      }
      const float length = sum.norm();
      normals[t][c] = length > 0 ? Eigen::Vector3f(sum / length) : faces[t];
    }
  });
  return normals;
}

}  // namespace proveout::render_detail
