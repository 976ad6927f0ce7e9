#include "removal/wire/section/prism_mesh.h"

#include <span>
#include <utility>

#include "core/base/assert.h"
#include "core/geometry/to_float.h"
#include "removal/wire/section/chord_rings.h"
#include "removal/wire/section/face_triangles.h"

namespace proveout {
namespace {

class PrismWriter {
 public:
  PrismWriter(double z_low, double z_high) : low_(toFloat(z_low)), high_(toFloat(z_high)) {}

  /// A body: its border and its hollows.
  void add(std::span<const ChordRing> loops) {
    std::vector<std::vector<Vec2>> faces;
    std::vector<const ChordRing*> rings;
    for (const ChordRing& ring : loops) {
      if (ring.points.size() < 3) {
        if (rings.empty()) return;
        continue;
      }
      faces.push_back(ring.points);
      rings.push_back(&ring);
    }
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    for (const ChordRing* ring : rings) addWalls(*ring);
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
  void addWalls(const ChordRing& ring) {
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    const auto n = static_cast<std::uint32_t>(ring.points.size());
    PROVEOUT_ASSERT(ring.motion.size() == ring.points.size());
    for (std::uint32_t i = 0; i < n; ++i) {
      const Eigen::Vector2f p = toFloat(ring.points[i]);
      mesh_.positions.emplace_back(p.x(), p.y(), low_);
      mesh_.positions.emplace_back(p.x(), p.y(), high_);
      const std::uint32_t a = first + 2 * i, b = first + 2 * ((i + 1) % n);
      triangle(a, b, b + 1, ring.motion[i]);
      triangle(a, b + 1, a + 1, ring.motion[i]);
    }
  }

  TriMesh mesh_;
  float low_, high_;
};

}  // namespace

TriMesh prismMesh(const std::vector<PlaneBody>& bodies, double z_low, double z_high, double tolerance) {
  std::vector<const PlaneLoop*> loops;
  for (const PlaneBody& body : bodies) {
    for (const PlaneLoop& loop : body.loops) loops.push_back(&loop);
  }
  const std::vector<ChordRing> rings = chordRings(loops, tolerance);
  PrismWriter writer(z_low, z_high);
  std::size_t first = 0;
  for (const PlaneBody& body : bodies) {
    writer.add(std::span(rings).subspan(first, body.loops.size()));
    first += body.loops.size();
  }
  PROVEOUT_ASSERT(first == rings.size());
  return writer.take();
}

}  // namespace proveout
