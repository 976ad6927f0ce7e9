#include "removal/wire/prism_mesh.h"

#include <algorithm>

#include "removal/wire/face_triangles.h"

namespace proveout {
namespace {

bool same(const Vec2& p, const Vec2& q) { return (p - q).norm() <= meshStep(p); }

/// A loop as a mesh can hold it, without corners that are one there.
struct Ribbon {
  std::vector<Vec2> points;
  std::vector<MotionId> motion;  ///< of the edge to the next
};

Ribbon ribbonOf(const PlaneLoop& loop, double tolerance) {
  const ChordLoop chords = chordsOf(loop, tolerance);
  Ribbon ribbon;
  for (std::size_t i = 0; i < chords.points.size(); ++i) {
    const Vec2 p = asFloat(chords.points[i]);
    const MotionId motion = loop.edges[chords.edge[i]].motion;
    if (!ribbon.points.empty() && same(ribbon.points.back(), p)) {
      ribbon.motion.back() = motion;
      continue;
    }
    ribbon.points.push_back(p);
    ribbon.motion.push_back(motion);
  }
  while (ribbon.points.size() > 1 && same(ribbon.points.front(), ribbon.points.back())) {
    ribbon.points.pop_back();
    ribbon.motion.pop_back();
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
