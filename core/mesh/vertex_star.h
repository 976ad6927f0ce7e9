// The triangles around a vertex, and by how much the surface moves where the vertex is joined with a
// neighbour.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/geometry/types.h"
#include "core/mesh/corner_table.h"

namespace proveout {

struct TriangleState {
  Eigen::Vector3f normal;  ///< unit
  float error;             ///< mm: by how much it is off what there was, at most
};

/// What stars are looked at with.
struct StarSurroundings {
  const CornerTable& table;
  std::span<const Eigen::Vector3f> positions;  ///< mm
  std::span<const TriangleState> triangles;
  double least_height = 0.0;  ///< triangles of less height than this, mm, are needles
};

/// Triangle j has the corners middle, ring(j), ring(j + 1).
class VertexStar {
 public:
  static constexpr int kMost = 48;  ///< triangles

  /// Finds what is around. False: the vertex has too many triangles.
  bool walk(const CornerTable& table, std::uint32_t middle);
  /// Edges where the label changes, up to three, and the first two of them: numbers of ring vertices.
  int borders() const { return borders_; }
  const std::array<int, 2>& borderAt() const { return border_at_; }
  /// Reads places and normals. `around` must outlive this. What follows requires it.
  void look(const StarSurroundings& around);

  int size() const { return size_; }
  int after(int j) const { return j + 1 == size_ ? 0 : j + 1; }
  int before(int j) const { return j == 0 ? size_ - 1 : j - 1; }
  std::uint32_t ring(int j) const { return ring_[j]; }
  std::uint32_t halfEdge(int j) const { return half_edge_[j]; }  ///< from the middle to ring(j)
  std::uint32_t triangle(int j) const { return CornerTable::triangleOf(half_edge_[j]); }
  const Vec3& arm(int j) const { return arm_[j]; }  ///< from the middle to ring(j), mm
  bool hasInRing(std::uint32_t v) const {
    if ((names_ >> (v & 63) & 1) == 0) return false;
    for (int j = 0; j < size_; ++j) {
      if (ring_[j] == v) return true;
    }
    return false;
  }

  /// Finds the view in which all triangles face the viewer; false: there is none. Joining requires it.
  bool findView();
  /// Sum of the squared distances of ring(b) from the planes of the triangles, mm2.
  double offPlanes2(int b) const {
    const Vec3& a = arm_[b];
    const std::array<double, 6>& q = planes_;
    return a.x() * (q[0] * a.x() + 2.0 * (q[1] * a.y() + q[2] * a.z())) +
           a.y() * (q[3] * a.y() + 2.0 * q[4] * a.z()) + q[5] * a.z() * a.z();
  }

  /// What takes the place of the star where its middle is joined with ring(b): triangles ring(b), ring(j),
  /// ring(j + 1), for all j from after(b) with after(j) != b.
  struct Change {
    std::array<TriangleState, kMost> triangle;  ///< as in the surroundings
    float moved = 0.0f;                         ///< the largest part of their errors that is new
  };
  /// Both are seen as heights over one plane, so that going along the view leads from either one to the
  /// other: they are nowhere farther apart than along it, and this difference is largest where the middle is
  /// or where an old edge crosses a new one, as it is linear between. False: the new triangles would fold, be
  /// needles, or lean much against those that have been there, or an error be above `most`.
  bool join(int b, double most, Change& change) const;

 private:
  using Values = std::array<double, kMost>;
  /// The new triangles as a fan around ring(b): k-th corner and k-th triangle, which goes from corner k to k
  /// + 1, are those of j = b + 1 + k. Places are seen along the view, from ring(b).
  struct Fan {
    int base = 0, corners = 0;
    std::array<int, kMost> j;
    std::array<Vec2, kMost> p;
    Values side;           ///< which side of the edge to a corner the middle is on; above 0: behind it
    Values moved, before;  ///< by triangle
  };
  bool openFan(int b, Fan& fan) const;
  bool shape(const Fan& fan, Change& change) const;
  double addMiddle(Fan& fan, int& first, int& last) const;
  void addCrossings(Fan& fan, int first, int last) const;
  void addCrossing(Fan& fan, int d, double over_length2, int k) const;

  const StarSurroundings* around_ = nullptr;
  std::uint32_t middle_ = 0;
  int size_ = 0, borders_ = 0;
  std::uint64_t names_ = 0;  ///< bits of the numbers of the ring's vertices, modulo 64
  std::array<int, 2> border_at_;
  std::array<std::uint32_t, kMost> ring_, half_edge_;
  std::array<Vec3, kMost> arm_, normal_;
  std::array<Vec2, kMost> flat_;  ///< arms, seen along the view
  Values height_;                 ///< of them along it
  Values error_;
  double largest_error_ = 0.0;
  std::array<double, 6> planes_;  ///< sum of the products of the normals: xx, xy, xz, yy, yz, zz
};

}  // namespace proveout
