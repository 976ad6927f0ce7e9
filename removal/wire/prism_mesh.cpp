#include "removal/wire/prism_mesh.h"

#include <algorithm>

#include "removal/wire/face_triangles.h"

namespace proveout {
namespace {

/// A loop as a mesh can hold it.
struct Ribbon {
  std::vector<Vec2> points;
  std::vector<MotionId> motion;  ///< of the edge to the next
};

Ribbon ribbonOf(const PlaneLoop& loop, double tolerance) {
  const ChordLoop chords = chordsOf(loop, tolerance);
  Ribbon ribbon;
  for (const auto& [point, edge] : meshCorners(chords.points)) {
    ribbon.points.push_back(asFloat(chords.points[point]));
    ribbon.motion.push_back(loop.edges[chords.edge[edge]].motion);
  }
  return ribbon;
}

class PrismWriter {
 public:
  PrismWriter(double z_low, double z_high)
      : low_(static_cast<float>(z_low)), high_(static_cast<float>(z_high)) {}

  void add(const PlaneBody& body, double tolerance) {
    std::vector<std::vector<Vec2>> faces;
    std::vector<Ribbon> ribbons;
    for (const PlaneLoop& loop : body.loops) {
      Ribbon ribbon = ribbonOf(loop, tolerance);
      if (ribbon.points.size() < 3) {
        if (ribbons.empty()) return;
        continue;
      }
      faces.push_back(ribbon.points);
      ribbons.push_back(std::move(ribbon));
    }
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    for (const Ribbon& ribbon : ribbons) addWalls(ribbon);
    for (const auto& [a, b, c] : faceTriangles(faces)) {
      // Corner k has its lower vertex at 2 k, the upper one behind it.
      triangle(first + 2 * a + 1, first + 2 * b + 1, first + 2 * c + 1, kNoMotion);
      triangle(first + 2 * a, first + 2 * c, first + 2 * b, kNoMotion);
    }
  }
  TriMesh take() { return std::move(mesh_); }

 private:
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, MotionId motion) {
    mesh_.triangles.push_back({a, b, c});
    mesh_.motion.push_back(motion);
  }
  void addWalls(const Ribbon& ribbon) {
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    const auto n = static_cast<std::uint32_t>(ribbon.points.size());
    for (std::uint32_t i = 0; i < n; ++i) {
      const Eigen::Vector2f p = ribbon.points[i].cast<float>();
      mesh_.positions.emplace_back(p.x(), p.y(), low_);
      mesh_.positions.emplace_back(p.x(), p.y(), high_);
      const std::uint32_t a = first + 2 * i, b = first + 2 * ((i + 1) % n);
      triangle(a, b, b + 1, ribbon.motion[i]);
      triangle(a, b + 1, a + 1, ribbon.motion[i]);
    }
  }

  TriMesh mesh_;
  float low_, high_;
};

}  // namespace

TriMesh prismMesh(const std::vector<PlaneBody>& bodies, double z_low, double z_high, double tolerance) {
  PrismWriter writer(z_low, z_high);
  for (const PlaneBody& body : bodies) writer.add(body, tolerance);
  return writer.take();
}

}  // namespace proveout
