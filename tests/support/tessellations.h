// Solids as CAD exporters tessellate them, with the true surface in closed form: vertices lie on it, facets
// are its chords.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace proveout::tessellations {

/// How an exporter spreads vertices over a face.
enum class Manner {
  kFan,        ///< rows of equal counts one above the other: constructive modellers, by number of fragments
  kStrips,     ///< as kFan, but a straight direction is not divided: boundary modellers, by deflection
  kIrregular,  ///< rows shifted against each other, vertices moved at random, shorter diagonals: Delaunay's
};

struct Facets {
  std::string name;
  TriMesh mesh;                               ///< closed, outward, welded
  std::function<double(const Vec3&)> beyond;  ///< how far the true surface lies beyond a point of a facet, mm
};

/// A point of a half section: distance from the Z axis and height, mm.
using Section = std::vector<Vec2>;

/// Points of an arc from one angle to the other (degrees, from +rho towards +z) with `pieces` chords.
inline void addArc(Section& section, const Vec2& center, double radius, double from, double to, int pieces) {
  for (int i = 0; i <= pieces; ++i) {
    const double a = degToRad(from + (to - from) * i / pieces);
    const Vec2 p(std::max(0.0, center.x() + radius * std::cos(a)), center.y() + radius * std::sin(a));
    const Vec2 at(p.x() < 1e-9 ? 0.0 : p.x(), p.y());
    if (section.empty() || (section.back() - at).norm() > 1e-9) section.push_back(at);
  }
}

/// Chords of a full circle of which each is `chord` high.
inline int fragmentsFor(double radius, double chord) {
  return std::max(5, static_cast<int>(std::ceil(kPi / std::acos(1.0 - chord / radius) - 1e-9)));
}
inline int piecesFor(double radius, double chord, double span_deg) {
  const double all = fragmentsFor(radius, chord);
  return std::max(1, static_cast<int>(std::ceil(all * std::abs(span_deg) / 360.0 - 1e-9)));
}

/// A body under construction: triangles of separate corners, welded at the end.
class Soup {
 public:
  void add(const Vec3& a, const Vec3& b, const Vec3& c) {
    if ((a - b).norm() < 1e-9 || (b - c).norm() < 1e-9 || (c - a).norm() < 1e-9) return;
    const auto n = static_cast<std::uint32_t>(soup_.positions.size());
    for (const Vec3& p : {a, b, c}) soup_.positions.push_back(p.cast<float>());
    soup_.triangles.push_back({n, n + 1, n + 2});
  }
  /// Corners in order round the outward normal; `shorter`: split along the shorter diagonal.
  void add(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, bool shorter) {
    if (shorter && (b - d).norm() < (a - c).norm()) {
      add(a, b, d);
      add(b, c, d);
    } else {
      add(a, b, c);
      add(a, c, d);
    }
  }
  TriMesh mesh() const { return weldVertices(soup_); }

 private:
  TriMesh soup_;
};

/// A body of revolution about Z. The half section runs upwards, the material on its left; ends off the axis
/// are closed by flat fans.
inline TriMesh revolve(Section section, int fragments, Manner manner) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> jitter(-0.2, 0.2);
  const bool irregular = manner == Manner::kIrregular;
  std::vector<char> own(section.size(), 1);  // a corner of the section, not a point put between
  if (irregular) {
    Section fine;
    std::vector<char> corner;
    for (std::size_t i = 0; i < section.size(); ++i) {
      fine.push_back(section[i]);
      corner.push_back(1);
      if (i + 1 == section.size()) continue;
      const Vec2 way = section[i + 1] - section[i];
      const double step = 2.0 * kPi * std::max(section[i].x(), section[i + 1].x()) / fragments;
      const int n = std::min(40, std::max(1, static_cast<int>(way.norm() / step)));
      const bool flat = std::abs(way.y()) < 1e-12;
      for (int k = 1; k < n && !flat; ++k) {
        fine.push_back(section[i] + way * (k + jitter(random)) / n);
        corner.push_back(0);
      }
    }
    section = fine;
    own = corner;
  }
  std::vector<std::vector<Vec3>> rows;
  for (std::size_t i = 0; i < section.size(); ++i) {
    std::vector<Vec3> row;
    for (int j = 0; j < fragments; ++j) {
      const double shift = !irregular ? 0.0 : 0.5 * (i % 2) + (own[i] ? 0.5 : 1.0) * jitter(random);
      const double a = 2.0 * kPi * (j + shift) / fragments;
      row.emplace_back(section[i].x() * std::cos(a), section[i].x() * std::sin(a), section[i].y());
    }
    rows.push_back(row);
  }
  Soup soup;
  const auto n = static_cast<std::size_t>(fragments);
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const std::size_t k = (j + 1) % n;
      soup.add(rows[i][j], rows[i][k], rows[i + 1][k], rows[i + 1][j], irregular);
    }
  }
  for (std::size_t j = 1; j + 1 < n; ++j) {
    if (section.front().x() > 0.0) soup.add(rows.front()[0], rows.front()[j + 1], rows.front()[j]);
    if (section.back().x() > 0.0) soup.add(rows.back()[0], rows.back()[j], rows.back()[j + 1]);
  }
  return soup.mesh();
}

/// How far a point lies inside of a round about an axis or point, from its distance to that.
inline double within(double radius, double distance) { return radius - distance; }

inline Facets cylinder(double radius, double height, int fragments, Manner manner) {
  return {"cylinder", revolve({{radius, 0}, {radius, height}}, fragments, manner), [=](const Vec3& p) {
            const bool end = p.z() < 1e-5 || p.z() > height - 1e-5;
            return end ? 0.0 : within(radius, p.head<2>().norm());
          }};
}

/// From one radius at z = 0 to the other, which may be 0.
inline Facets cone(double radius, double top_radius, double height, int fragments, Manner manner) {
  const double slope = (radius - top_radius) / height, scale = 1.0 / std::hypot(1.0, slope);
  return {top_radius > 0.0 ? "frustum" : "cone",
          revolve({{radius, 0}, {top_radius, height}}, fragments, manner), [=](const Vec3& p) {
            const bool end = p.z() < 1e-5 || (top_radius > 0.0 && p.z() > height - 1e-5);
            return end ? 0.0 : scale * (radius - slope * p.z() - p.head<2>().norm());
          }};
}

/// With a vertex at either pole, or, as constructive modellers have it, flat ends half a ring off them.
inline Facets sphere(double radius, int fragments, Manner manner) {
  Section section;
  const int rings = fragments / 2;
  if (manner == Manner::kFan) {
    for (int i = 0; i < rings; ++i) {
      const double a = kPi * ((i + 0.5) / rings - 0.5);
      section.emplace_back(radius * std::cos(a), radius * std::sin(a));
    }
  } else {
    addArc(section, {0, 0}, radius, -90, 90, rings);
  }
  return {"sphere", revolve(section, fragments, manner),
          [=](const Vec3& p) { return within(radius, p.norm()); }};
}

inline Facets torus(double radius, double tube, int fragments, int tube_fragments, Manner manner) {
  // The section closes on itself: an outer and an inner half, each from the lowest to the highest circle.
  Soup soup;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> jitter(-0.2, 0.2);
  const bool irregular = manner == Manner::kIrregular;
  std::vector<std::vector<Vec3>> rows;
  for (int i = 0; i < tube_fragments; ++i) {
    std::vector<Vec3> row;
    for (int j = 0; j < fragments; ++j) {
      const double b = 2 * kPi * (i + (irregular ? jitter(random) : 0.0)) / tube_fragments,
                   shift = irregular ? 0.5 * (i % 2) + jitter(random) : 0.0,
                   a = 2 * kPi * (j + shift) / fragments, rho = radius + tube * std::cos(b);
      row.emplace_back(rho * std::cos(a), rho * std::sin(a), tube * std::sin(b));
    }
    rows.push_back(row);
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto &low = rows[i], &high = rows[(i + 1) % rows.size()];
    for (std::size_t j = 0; j < low.size(); ++j) {
      const std::size_t k = (j + 1) % low.size();
      soup.add(low[j], low[k], high[k], high[j], irregular);
    }
  }
  return {"torus", soup.mesh(),
          [=](const Vec3& p) { return within(tube, std::hypot(p.head<2>().norm() - radius, p.z())); }};
}

/// A block whose top is z = height + amplitude sin(2 pi x / period) cos(2 pi y / period) (a free-form patch).
inline Facets wavyBlock(double size, double amplitude, double period, int steps, Manner manner) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> jitter(-0.3, 0.3);
  const double height = 10.0, w = 2 * kPi / period;
  const auto top = [=](double x, double y) { return height + amplitude * std::sin(w * x) * std::cos(w * y); };
  const int n = steps;
  std::vector<std::vector<Vec3>> grid;
  for (int i = 0; i <= n; ++i) {
    std::vector<Vec3> row;
    for (int j = 0; j <= n; ++j) {
      const bool moves = manner == Manner::kIrregular && i > 0 && j > 0 && i < n && j < n;
      const double x = size * (i + (moves ? jitter(random) : 0.0)) / n,
                   y = size * (j + (moves ? jitter(random) : 0.0)) / n;
      row.emplace_back(x, y, top(x, y));
    }
    grid.push_back(row);
  }
  Soup soup;
  const auto at = [&](int i, int j) {
    return grid[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  };
  const auto floor = [](Vec3 p) { return Vec3(p.x(), p.y(), 0.0); };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j)
      soup.add(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1), manner == Manner::kIrregular);
    soup.add(floor(at(i, 0)), floor(at(i + 1, 0)), at(i + 1, 0), at(i, 0), false);
    soup.add(floor(at(i + 1, n)), floor(at(i, n)), at(i, n), at(i + 1, n), false);
    soup.add(floor(at(n, i)), floor(at(n, i + 1)), at(n, i + 1), at(n, i), false);
    soup.add(floor(at(0, i + 1)), floor(at(0, i)), at(0, i), at(0, i + 1), false);
    for (const auto& [a, b] : {std::pair(at(i, 0), at(i + 1, 0)), std::pair(at(i + 1, n), at(i, n)),
                               std::pair(at(n, i), at(n, i + 1)), std::pair(at(0, i + 1), at(0, i))})
      soup.add(Vec3(0.5 * size, 0.5 * size, 0.0), floor(b), floor(a));
  }
  return {"wavy block", soup.mesh(), [=](const Vec3& p) {
            if (p.z() < 0.5 * height || std::min({p.x(), p.y(), size - p.x(), size - p.y()}) < 1e-5)
              return 0.0;
            const double sx = amplitude * w * std::cos(w * p.x()) * std::cos(w * p.y()),
                         sy = amplitude * w * std::sin(w * p.x()) * std::sin(w * p.y());
            return (top(p.x(), p.y()) - p.z()) / std::sqrt(1.0 + sx * sx + sy * sy);
          }};
}

/// A body of revolution: a flange, on it a fillet up to the shank, a ball on top (all of them touch).
inline Facets pin(double radius, double fillet, double length, double chord, Manner manner) {
  const double foot = radius + fillet, rim = foot + 2.0;
  Section section{{rim, -2.0}, {rim, 0.0}};
  addArc(section, {foot, fillet}, fillet, 270, 180, piecesFor(fillet, chord, 90));
  addArc(section, {0, length}, radius, 0, 90, piecesFor(radius, chord, 90));
  return {"pin", revolve(section, fragmentsFor(rim, chord), manner), [=](const Vec3& p) {
            const double rho = p.head<2>().norm();
            if (p.z() < -2.0 + 1e-5 || std::abs(p.z()) < 1e-5) return 0.0;
            if (p.z() < 0.0) return within(rim, rho);
            if (p.z() > length) return within(radius, (p - Vec3(0, 0, length)).norm());
            if (p.z() > fillet) return within(radius, rho);
            return std::hypot(rho - foot, p.z() - fillet) - fillet;
          }};
}

}  // namespace proveout::tessellations
