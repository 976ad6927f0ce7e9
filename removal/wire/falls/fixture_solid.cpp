#include "removal/wire/falls/fixture_solid.h"

#include <array>
#include <cmath>

#include "removal/wire/section/plane_region.h"

namespace proveout {
namespace {

/// Of the chords of cylinders, mm.
constexpr double kFixtureChordMm = 1e-3;

SurfaceMesh boxSolid(const Vec3& min, const Vec3& max) {
  SurfaceMesh out;
  for (int k = 0; k < 8; ++k)
    out.points.emplace_back((k & 1) != 0 ? max.x() : min.x(), (k & 2) != 0 ? max.y() : min.y(),
                            (k & 4) != 0 ? max.z() : min.z());
  constexpr std::array<std::array<std::uint32_t, 4>, 6> kFaces{
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (const auto& [a, b, c, d] : kFaces) {
    out.triangles.push_back({a, b, c});
    out.triangles.push_back({a, c, d});
  }
  return out;
}

/// Rings of points about the axis, each joined to the next by a band of triangles; the last one to the first.
class RingSolid {
 public:
  explicit RingSolid(const CylinderShape& shape)
      : shape_(shape), sides_(std::max(8, chordCount(shape.radius, 2.0 * kPi, kFixtureChordMm))) {}

  SurfaceMesh make() {
    const double outer = shape_.radius / std::cos(kPi / sides_);
    addRing(outer, 0.0);
    addRing(outer, shape_.length);
    if (shape_.inner_radius > 0.0) {
      addRing(shape_.inner_radius, shape_.length);
      addRing(shape_.inner_radius, 0.0);
      for (std::uint32_t ring = 0; ring < 4; ++ring) addBand(ring, (ring + 1) % 4);
    } else {
      addBand(0, 1);
      addCap(0, false);
      addCap(1, true);
    }
    return std::move(out_);
  }

 private:
  std::uint32_t point(std::uint32_t ring, int k) const {
    return ring * static_cast<std::uint32_t>(sides_) + static_cast<std::uint32_t>(k % sides_);
  }

  void addRing(double radius, double height) {
    const int u = (shape_.axis + 1) % 3, v = (shape_.axis + 2) % 3;
    for (int k = 0; k < sides_; ++k) {
      const double angle = 2.0 * kPi * k / sides_;
      Vec3 p = shape_.base;
      p[shape_.axis] += height;
      p[u] += radius * std::cos(angle);
      p[v] += radius * std::sin(angle);
      out_.points.push_back(p);
    }
  }

  void addBand(std::uint32_t from, std::uint32_t to) {
    for (int k = 0; k < sides_; ++k) {
      out_.triangles.push_back({point(from, k), point(from, k + 1), point(to, k + 1)});
      out_.triangles.push_back({point(from, k), point(to, k + 1), point(to, k)});
    }
  }

  void addCap(std::uint32_t ring, bool up) {
    for (int k = 1; k + 1 < sides_; ++k) {
      if (up)
        out_.triangles.push_back({point(ring, 0), point(ring, k), point(ring, k + 1)});
      else
        out_.triangles.push_back({point(ring, 0), point(ring, k + 1), point(ring, k)});
    }
  }

  const CylinderShape& shape_;
  int sides_;
  SurfaceMesh out_;
};

/// The part of a convex polygon on one side of a height.
std::vector<Vec3> clipped(const std::vector<Vec3>& polygon, double z, bool above) {
  std::vector<Vec3> out;
  const auto inside = [&](const Vec3& p) { return above ? p.z() >= z : p.z() <= z; };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if (inside(a)) out.push_back(a);
    if (inside(a) != inside(b)) out.push_back(a + (z - a.z()) / (b.z() - a.z()) * (b - a));
  }
  return out;
}

}  // namespace

SurfaceMesh solidOf(const StockShape& shape) {
  if (const auto* box = std::get_if<BoxShape>(&shape)) return boxSolid(box->min, box->max);
  if (const auto* cylinder = std::get_if<CylinderShape>(&shape)) return RingSolid(*cylinder).make();
  const auto* mesh = std::get_if<MeshShape>(&shape);
  return mesh != nullptr ? toSurface(mesh->mesh) : SurfaceMesh{};
}

std::vector<std::vector<Vec2>> footprintOf(const SurfaceMesh& solid, double z_low, double z_high) {
  std::vector<std::vector<Vec2>> out;
  for (const auto& [a, b, c] : solid.triangles) {
    const std::vector<Vec3> between =
        clipped(clipped({solid.points[a], solid.points[b], solid.points[c]}, z_low, true), z_high, false);
    if (between.empty()) continue;
    out.emplace_back();
    for (const Vec3& p : between) out.back().push_back(p.head<2>());
  }
  return out;
}

}  // namespace proveout
