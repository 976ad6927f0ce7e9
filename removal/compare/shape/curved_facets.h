// Which facets of a mesh stand for curved faces, and how these run. Internal to NominalShape.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "removal/compare/shape/mesh_facets.h"

namespace proveout::shape_detail {

/// Cosine of how far borders may turn off each other for a facet to be straight along them, and how many
/// times as long as wide it is then.
inline constexpr double kStraight = 0.65, kStraightLength = 2.0;

/// How a facet that is straight in one direction curves across it.
struct Straight {
  Vec3 along = Vec3::Zero(), across = Vec3::Zero();  ///< unit; zero: the facet is no such
  double curvature = 0.0;                            ///< 1/mm, > 0: convex
  Eigen::Array2d low = Eigen::Array2d::Constant(1e300), high = Eigen::Array2d::Constant(-1e300);
  bool holds() const {
    const Eigen::Array2d size = high - low;
    return !along.isZero() && size[0] >= kStraightLength * size[1];
  }
};

/// What is per facet has an entry per triangle, as in MeshFacets, which has to outlive this.
class CurvedFacets {
 public:
  explicit CurvedFacets(const MeshFacets& facets);

  /// Per triangle: the chord of the round that flats of a regular polygon could stand for, mm; empty: none.
  std::vector<float> doubts() const;
  /// Whether any facet is curved; if not, only doubts() and this may be asked.
  bool any() const { return any_; }
  bool curved(std::uint32_t facet) const { return curved_[facet] != 0; }
  /// Of a curved facet against its neighbours, rad.
  double turn(std::uint32_t facet) const { return turn_[facet]; }
  const std::vector<Link>& links() const { return links_; }
  /// The border of two facets; null: they do not meet.
  const Link* linkOf(std::uint32_t a, std::uint32_t b) const;
  /// The facet as straight in one direction; null where it is not.
  const Straight* straight(std::uint32_t facet) const {
    return straight_of_[facet] == kNobody ? nullptr : &straight_[straight_of_[facet]];
  }
  bool isStrip(std::uint32_t facet) const {
    return facets_.triangles[facet] > 1 && straight(facet) != nullptr;
  }
  /// Whether the surface goes on smoothly from one facet to the other.
  bool smooth(std::uint32_t a, std::uint32_t b, double turn) const;
  /// Where a long facet of one curved face meets the short ones of another that it touches (a straight fillet
  /// the round of its corner), the face is straight on the long one's side: its normal is the right one.
  /// kNobody: neither leads.
  std::uint32_t leadingOf(std::uint32_t a, std::uint32_t b) const;

 private:
  void gatherLinks();
  /// Those that a curved face could cross, by their numbers.
  std::span<const std::uint32_t> linksOf(std::uint32_t facet) const {
    return std::span(link_of_).subspan(first_link_[facet], first_link_[facet + 1] - first_link_[facet]);
  }
  bool findCurved();
  void findStraight();
  void dropShort();
  Straight straightBy(std::uint32_t facet) const;
  void endAtCreases();
  double turnAcross(std::uint32_t facet, const Link& border) const;

  const MeshFacets& facets_;
  std::vector<Link> links_;
  std::vector<std::uint32_t> link_of_, first_link_;  ///< facet by facet, and where in that each facet's begin
  std::vector<char> curved_;                         ///< per facet
  std::vector<std::uint32_t> straight_of_;           ///< per facet: its place in straight_, or kNobody
  std::vector<Straight> straight_;
  std::vector<double> turn_;
  bool any_ = false;
};

}  // namespace proveout::shape_detail
