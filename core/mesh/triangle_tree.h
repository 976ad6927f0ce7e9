// Nearest points and winding numbers of a triangle mesh.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "core/geometry/box_tree.h"
#include "core/mesh/surface_mesh.h"

namespace proveout {

/// Part of a triangle that holds a point: corner 0..2, edge 3..5 (from corner i - 3 to the next), or the
/// face.
inline constexpr int kFacePart = 6;

/// The point of triangle abc nearest to p, by the signs of its barycentric coordinates and of the projections
/// on its edges (C. Ericson, Real-Time Collision Detection, 5.1.5).
struct TrianglePoint {
  Vec3 point;
  int part = kFacePart;
};
TrianglePoint nearestOfTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

class TriangleTree {
 public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  /// Copies what it needs. Requires finite points and indices in range.
  explicit TriangleTree(const SurfaceMesh& mesh);

  struct Nearest {
    double squared = std::numeric_limits<double>::infinity();  ///< distance, mm2
    std::uint32_t triangle = kNone;                            ///< kNone: none as near as asked for
    int part = kFacePart;
    Vec3 point = Vec3::Zero();
  };
  /// Of equally near triangles the one with the lowest number. Nothing farther than `within`, mm, is looked
  /// for. `hint`: a triangle that may be near; it makes the search faster and does not change the result.
  Nearest nearest(const Vec3& p, std::uint32_t hint = kNone,
                  double within = std::numeric_limits<double>::infinity()) const;

  /// How often the mesh goes round `p`: 1 inside of a closed mesh, 0 outside, and between where it is open or
  /// on it. Groups of triangles far off count as dipoles (G. Barill et al., "Fast winding numbers for soups
  /// and clouds", 2018): off by less than 0.1.
  double windingNumber(const Vec3& p) const;

  /// The same, whole and exact, of a mesh whose edges are balanced (as many triangles use each one way as the
  /// other): the crossings of a ray, counted by their direction. Several times faster where triangles are
  /// long. Nothing where each of three rays runs within rounding of an edge. `p` must not be on the mesh.
  std::optional<int> crossings(const Vec3& p) const;

  /// Whether such a mesh goes round `p`: by crossings, else by the winding number.
  bool goesRound(const Vec3& p) const {
    const std::optional<int> sum = crossings(p);
    return sum ? *sum > 0 : windingNumber(p) > 0.5;
  }

  /// Calls visit(triangle) for every triangle whose bounds touch the box.
  template <typename Visit>
  void forEachIn(const Box3& box, const Visit& visit) const {
    boxes_.forEachPlace(box, [&](std::uint32_t place) {
      const Corners t = cornersAt(place);
      const Box3 own{t.a.cwiseMin(t.b).cwiseMin(t.c), t.a.cwiseMax(t.b).cwiseMax(t.c)};
      if (own.overlaps(box)) visit(boxes_.order()[place]);
    });
  }

 private:
  /// What a group of triangles looks like from afar.
  struct Dipole {
    float center[3], normal[3];  ///< mm; sum of areas along the normals, mm2
    float reach;                 ///< seen from farther off it is a dipole, mm
  };
  struct Corners {
    Vec3 a, b, c;
  };
  Corners cornersAt(std::uint32_t place) const {
    if (short_corners_.empty()) {
      const auto& v = vertices_[place];
      return {points_[v[0]], points_[v[1]], points_[v[2]]};
    }
    const std::array<float, 9>& s = short_corners_[place];
    return {Vec3(s[0], s[1], s[2]), Vec3(s[3], s[4], s[5]), Vec3(s[6], s[7], s[8])};
  }
  /// Of a group: area vectors, area times middle, and area.
  struct AreaSum {
    Vec3 normal = Vec3::Zero(), moment = Vec3::Zero();
    double area = 0.0;
    void add(const AreaSum& more) {
      normal += more.normal;
      moment += more.moment;
      area += more.area;
    }
  };
  void keepCorners(const SurfaceMesh& mesh);
  /// Of all nodes below a child. Returns what that holds.
  AreaSum findDipoles(const SurfaceMesh& mesh, std::uint32_t child);
  static Dipole dipoleOf(const AreaSum& group, const BoxTree::Node& node, std::size_t side);
  std::optional<int> crossingsAlong(const Vec3& p, const Vec3& direction) const;
  void tryPlace(std::uint32_t place, const Vec3& p, Nearest& best) const;

  BoxTree boxes_;
  std::vector<Dipole> dipoles_;          ///< two a node
  std::vector<std::uint32_t> place_of_;  ///< of each triangle in the tree's order
  /// Corners in that order where single precision holds all points of the mesh, as those of files.
  std::vector<std::array<float, 9>> short_corners_;
  // Else the points, and which of them are corners: a third of the memory of the corners themselves.
  std::vector<Vec3> points_;
  std::vector<std::array<std::uint32_t, 3>> vertices_;
};

}  // namespace proveout
