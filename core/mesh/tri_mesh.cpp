#include "core/mesh/tri_mesh.h"

#include <Eigen/Geometry>
#include <bit>
#include <limits>

#include "core/mesh/edge_table.h"

namespace proveout {

Box3 meshBounds(const TriMesh& mesh) {
  Box3 box;
  for (const auto& p : mesh.positions) {
    if (p.allFinite()) box.extend(p.cast<double>());
  }
  return box;
}

MeshExtent meshExtent(const TriMesh& mesh) {
  MeshExtent out{meshBounds(mesh)};
  if (out.bounds.empty()) return out;
  // Cones from the centre of the mesh: far from the origin the plain formula loses the volume in
  // cancellation.
  const Vec3 origin = out.bounds.center();
  double six_volumes = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!triangleIsProper(mesh.triangles[t], mesh.positions.size())) continue;
    const auto& v = mesh.triangles[t];
    const Vec3 a = mesh.positions[v[0]].cast<double>() - origin;
    const Vec3 b = mesh.positions[v[1]].cast<double>() - origin;
    const Vec3 c = mesh.positions[v[2]].cast<double>() - origin;
    six_volumes += a.dot(b.cross(c));
  }
  out.volume_mm3 = six_volumes / 6.0;
  return out;
}

double meshVolume(const TriMesh& mesh) { return meshExtent(mesh).volume_mm3; }

double meshArea(const TriMesh& mesh) {
  double two_areas = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!triangleIsProper(mesh.triangles[t], mesh.positions.size())) continue;
    const auto& v = mesh.triangles[t];
    const Vec3 a = mesh.positions[v[0]].cast<double>();
    const Vec3 b = mesh.positions[v[1]].cast<double>();
    const Vec3 c = mesh.positions[v[2]].cast<double>();
    two_areas += (b - a).cross(c - a).norm();
  }
  return 0.5 * two_areas;
}

namespace weld_detail {

using Bits = std::array<std::uint32_t, 3>;

Bits bitsOf(const Eigen::Vector3f& p) {
  Bits bits;
  for (int i = 0; i < 3; ++i) bits[i] = std::bit_cast<std::uint32_t>(p[i] + 0.0f);  // -0 + 0 = +0
  return bits;
}

std::size_t hashOf(const Bits& bits) {
  std::uint64_t h = (std::uint64_t{bits[0]} << 32 | bits[1]) * 0x9E3779B97F4A7C15u;
  h = (h ^ (h >> 29) ^ bits[2]) * 0xBF58476D1CE4E5B9u;
  return static_cast<std::size_t>(h ^ (h >> 32));
}

/// Appends every new position to `kept` and returns the number of each input position in it.
std::vector<std::uint32_t> uniquePositions(const std::vector<Eigen::Vector3f>& positions,
                                           std::vector<Eigen::Vector3f>& kept) {
  constexpr std::uint32_t kFree = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> slots(std::bit_ceil(2 * positions.size() + 1), kFree);
  const std::size_t mask = slots.size() - 1;
  std::vector<std::uint32_t> number(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Bits bits = bitsOf(positions[i]);
    std::size_t slot = hashOf(bits) & mask;
    while (slots[slot] != kFree && bitsOf(kept[slots[slot]]) != bits) slot = (slot + 1) & mask;
    if (slots[slot] == kFree) {
      slots[slot] = static_cast<std::uint32_t>(kept.size());
      kept.push_back(positions[i]);
    }
    number[i] = slots[slot];
  }
  return number;
}

}  // namespace weld_detail

TriMesh weldVertices(const TriMesh& mesh) {
  TriMesh out;
  const std::vector<std::uint32_t> number = weld_detail::uniquePositions(mesh.positions, out.positions);
  const bool has_motion = mesh.motion.size() == mesh.triangles.size();
  out.triangles.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    auto v = mesh.triangles[t];
    // An index out of range stays out of range, so that the topology check still finds it.
    constexpr std::uint32_t kOutside = std::numeric_limits<std::uint32_t>::max();
    for (auto& i : v) i = i < number.size() ? number[i] : kOutside;
    const bool in_range = v[0] != kOutside && v[1] != kOutside && v[2] != kOutside;
    if (in_range && (v[0] == v[1] || v[1] == v[2] || v[2] == v[0])) continue;
    out.triangles.push_back(v);
    if (has_motion) out.motion.push_back(mesh.motion[t]);
  }
  return out;
}

}  // namespace proveout
