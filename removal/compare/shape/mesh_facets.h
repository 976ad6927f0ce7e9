// The flat facets of a mesh as exporters write it, and the borders at which they meet. Internal to
// NominalShape.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/geometry/types.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/surface_mesh.h"

namespace proveout::shape_detail {

/// Facets of a curved face turn by less than this; those of small radii by more, as long as the chord is
/// small.
inline constexpr double kSoftRad = degToRad(20.0), kSteepRad = degToRad(55.0);
/// Chords larger than this are not an exporter's, mm; those between steep facets.
inline constexpr double kMostChord = 0.25, kMostSteepChord = 0.12;
/// Facets of one curved face are about as wide as their neighbours, and it curves about alike on two sides.
inline constexpr double kWidthRatio = 2.5, kCurvatureRatio = 3.0, kSteepTurnRatio = 1.3;
/// Flats of regular polygons with chords of up to this could stand for a round, mm: of those that turn
/// softly, and steeply. Nobody makes rounds of hexagons.
inline constexpr double kMostDoubt = 1.0, kMostSteepDoubt = 0.25;
inline constexpr std::uint32_t kNobody = 0xFFFFFFFFu;

/// Two facets that meet.
struct Link {
  std::uint32_t a, b;   ///< facets
  double length, turn;  ///< of the border, mm; rad, > 0 where it is convex
  double width_a, width_b;
  Vec3 along;         ///< direction of the border, unit
  bool runs = false;  ///< a curved face goes on across it
  double width() const { return 0.5 * (width_a + width_b); }
  double curvature() const { return turn / width(); }
  bool alike() const { return width_a < kWidthRatio * width_b && width_b < kWidthRatio * width_a; }
  double angle() const { return std::abs(turn); }
  double chord() const { return 0.5 * std::min(width_a, width_b) * std::tan(0.25 * angle()); }
  bool plausible() const {
    return chord() <= kMostChord &&
           (angle() <= kSoftRad || (angle() <= kSteepRad && chord() <= kMostSteepChord));
  }
  bool doubtful() const {
    return !plausible() && angle() <= kSteepRad &&
           chord() <= (angle() <= kSoftRad ? kMostDoubt : kMostSteepDoubt);
  }
};

/// Triangles joined to facets; slivers belong to the facet that they were cut of. A facet goes by the number
/// of its first triangle, and vectors that are per facet have an entry per triangle.
struct MeshFacets {
  explicit MeshFacets(const SurfaceMesh& mesh);

  Vec3 edge(std::size_t t, int c) const {
    return mesh.points[mesh.triangles[t][(c + 1) % 3]] - mesh.points[mesh.triangles[t][c]];
  }

  /// Calls body(half edge, half edge) where two triangles with normals meet.
  template <typename Body>
  void forEachPair(const Body& body) const {
    edges.forEachEdge([&](std::uint32_t, const HalfEdge* first, const HalfEdge* last) {
      if (last - first != 2) return;
      const std::uint32_t g = first[0].half_edge, h = first[1].half_edge;
      if (!normals[g / 3].isZero() && !normals[h / 3].isZero()) body(g, h);
    });
  }

  double turnAt(std::uint32_t g, std::uint32_t h) const {
    const Vec3 &n = normals[g / 3], &m = normals[h / 3], cross = n.cross(m);
    const double angle = std::atan2(cross.norm(), n.dot(m));
    return cross.dot(edge(g / 3, static_cast<int>(g % 3))) > 0.0 ? angle : -angle;
  }
  /// The borders between facets, by their two facets, a below b; one where several edges are between the two.
  std::vector<Link> links() const;

  const SurfaceMesh& mesh;
  std::vector<std::uint32_t> facet_of;  ///< per triangle: the first triangle of its facet
  EdgeTable edges;
  std::vector<Vec3> normals;             ///< per triangle, unit; zero: not to be trusted
  std::vector<double> area;              ///< per facet, mm2
  std::vector<std::uint32_t> triangles;  ///< per facet: how many, without slivers

 private:
  /// A triangle that was cut off another's facet and is so narrow that rounding turned it.
  struct Sliver {
    std::uint32_t triangle = kNobody, beside = kNobody;    ///< kNobody: neither of the two is one
    double off = std::numeric_limits<double>::infinity();  ///< of that facet, mm
  };
  void findNormals();
  void findFacets();
  Sliver sliverOf(std::uint32_t g, std::uint32_t h) const;
  std::vector<std::uint32_t> joinSlivers(const std::vector<char>& joined, DisjointSets& sets) const;
  void straighten(const std::vector<std::uint32_t>& slivers, DisjointSets& sets);
  double widthOf(std::uint32_t facet, double length) const;
};

}  // namespace proveout::shape_detail
