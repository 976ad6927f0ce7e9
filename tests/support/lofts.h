// Solids between offsets of a rectangle: what a tool of revolution leaves or leaves out on a rectangular
// path. Facets have a stated chord height, vertices lie on the true faces.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/mesh/tri_mesh.h"
#include "removal/compare/mesh_boolean.h"

namespace proveout::lofts {

/// Half section (rho, z) from below upwards: rho is the offset from the rectangle.
struct Profile {
  struct Piece {
    bool arc;
    Vec2 to;                                  ///< lines
    double cx, cz, radius, from_deg, to_deg;  ///< arcs, angles from +rho towards +z
  };
  std::vector<Piece> pieces;

  Profile& line(double rho, double z) {
    pieces.push_back({false, {rho, z}, 0, 0, 0, 0, 0});
    return *this;
  }
  Profile& arc(double cx, double cz, double radius, double from_deg, double to_deg) {
    pieces.push_back({true, {0, 0}, cx, cz, radius, from_deg, to_deg});
    return *this;
  }
  /// Chords of height `chord`, mm.
  std::vector<Vec2> points(double chord) const {
    std::vector<Vec2> out;
    for (const Piece& p : pieces) {
      if (!p.arc) {
        out.push_back(p.to);
        continue;
      }
      const double step = 2.0 * std::acos(std::max(0.3, 1.0 - chord / p.radius));
      const int n =
          std::max(1, static_cast<int>(std::ceil(degToRad(std::abs(p.to_deg - p.from_deg)) / step - 1e-9)));
      for (int i = 0; i <= n; ++i) {
        const double a = degToRad(p.from_deg + (p.to_deg - p.from_deg) * i / n);
        const Vec2 at(p.cx + p.radius * std::cos(a), p.cz + p.radius * std::sin(a));
        if (out.empty() || (out.back() - at).norm() > 1e-9) out.push_back(at);
      }
    }
    return out;
  }
};

/// Corners of the offset of a rectangle (half sizes, may be 0) by rho: as many for every rho.
inline std::vector<Vec2> ring(const Vec2& half, double rho, int per_quarter) {
  std::vector<Vec2> out;
  for (int q = 0; q < 4; ++q) {
    const Vec2 corner(q == 0 || q == 3 ? half.x() : -half.x(), q < 2 ? half.y() : -half.y());
    for (int i = 0; i <= per_quarter; ++i) {
      const double a = 0.5 * kPi * (q + static_cast<double>(i) / per_quarter);
      const auto snap = [](double v) { return std::abs(v) < 1e-12 ? 0.0 : v; };
      out.push_back(corner + rho * Vec2(snap(std::cos(a)), snap(std::sin(a))));
    }
  }
  return out;
}

/// Segments of a quarter turn so that chords of the largest radius keep `chord`.
inline int segments(const std::vector<Vec2>& profile, double chord) {
  double largest = 0.0;
  for (const Vec2& p : profile) largest = std::max(largest, p.x());
  if (largest <= 0.0) return 1;
  const double step = 2.0 * std::acos(std::max(0.3, 1.0 - chord / largest));
  return std::max(2, static_cast<int>(std::ceil(0.5 * kPi / step - 1e-9)));
}

/// Closed solid; `center` in the plane, turned inside out for `hole`. Welded.
inline TriMesh solid(const Profile& profile, const Vec2& half, double chord,
                     const Vec2& center = Vec2::Zero()) {
  const std::vector<Vec2> line = profile.points(chord);
  const int per_quarter = segments(line, chord);
  TriMesh soup;
  const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto n = static_cast<std::uint32_t>(soup.positions.size());
    for (const Vec3& p : {a, b, c}) soup.positions.push_back(p.cast<float>());
    soup.triangles.push_back({n, n + 1, n + 2});
  };
  const auto lift = [&](const Vec2& p, double z) { return Vec3(p.x() + center.x(), p.y() + center.y(), z); };
  std::vector<std::vector<Vec3>> rings;
  for (const Vec2& p : line) {
    std::vector<Vec3> out;
    for (const Vec2& q : ring(half, p.x(), per_quarter)) out.push_back(lift(q, p.y()));
    rings.push_back(out);
  }
  const std::size_t n = rings.front().size();
  for (std::size_t r = 0; r + 1 < rings.size(); ++r) {
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = (i + 1) % n;
      add(rings[r][i], rings[r][j], rings[r + 1][j]);
      add(rings[r][i], rings[r + 1][j], rings[r + 1][i]);
    }
  }
  for (std::size_t i = 1; i + 1 < n; ++i) {
    add(rings.front()[0], rings.front()[i + 1], rings.front()[i]);
    add(rings.back()[0], rings.back()[i], rings.back()[i + 1]);
  }
  return weldVertices(soup);
}

/// A prism of so many sides whose corners lie on a circle.
inline TriMesh prism(int sides, double radius, double height) {
  TriMesh mesh;
  for (int k = 0; k < 2; ++k) {
    for (int i = 0; i < sides; ++i) {
      const double a = 2 * kPi * i / sides;
      mesh.positions.push_back(Vec3(radius * std::cos(a), radius * std::sin(a), k * height).cast<float>());
    }
  }
  const auto n = static_cast<std::uint32_t>(sides);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    mesh.triangles.push_back({i, j, n + j});
    mesh.triangles.push_back({i, n + j, n + i});
    if (i >= 1 && i + 1 < n) {
      mesh.triangles.push_back({0, i + 1, i});
      mesh.triangles.push_back({n, n + i, n + i + 1});
    }
  }
  return mesh;
}

/// A hole through, or a pocket into, a plate.
struct Hole {
  Profile profile;
  Vec2 center;
  Vec2 half;
};

/// The box less the holes.
inline TriMesh plateWith(const TriMesh& plate, const std::vector<Hole>& holes, double chord) {
  TriMesh mesh = plate;
  for (const Hole& h : holes)
    mesh = booleanOf(mesh, solid(h.profile, h.half, chord, h.center), BooleanKind::kDifference).value();
  return mesh;
}

}  // namespace proveout::lofts
