// What kinds of bodies have in common, and what they answer where they do not know better.
//
// A kind of body is a struct with the members of BodyDefaults, and with those that have no default: columns,
// leafColumns, reach and highestReach (KernelBody below, or ScalarBody in scalar_body.h). Its questions are
// told in swept_body.h. It may hide any of these; nothing here is virtual.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "removal/sweep/body_answers.h"
#include "removal/sweep/column_sweep.h"
#include "removal/sweep/swept_field.h"

namespace proveout {

/// What a body of any kind is of.
struct BodyContext {
  const ConvexProfile* profile = nullptr;
  /// The field of all that the body is a piece of. Null for whole lines only, which make it when it is asked.
  const SweptField* whole = nullptr;
};

struct BodyDefaults {
  Vec3 axis() const { return Vec3::Zero(); }

  unsigned hits(const LeafColumns&, unsigned quarters, double) const { return quarters; }
  bool cutsTogether() const { return false; }
  void cutEdges(const BodyContext&, EdgeCuts&) const {}

  double coveredTop() const { return -std::numeric_limits<double>::infinity(); }
  bool coversUpTo(double) const { return false; }
  double mostDepth(double, double) const { return std::numeric_limits<double>::infinity(); }
  bool isConvex() const { return false; }
  bool holdsEdges(double, const Vec2&, double) const { return false; }

  EdgeCut levelCut(const BodyContext& of, const Vec3& a, double dx, double dy, double inside) const {
    return {searchCut(*of.whole, a, Vec3(dx, dy, 0.0), inside)};
  }
  std::optional<SweptSurface> closedSurface(const BodyContext&, const Vec3&, int, bool) const {
    return std::nullopt;
  }
  /// Parameter of the motion at about which it leaves its surface at a point.
  double startAt(const BodyContext&, const Vec3&) const { return SweptField::kAnywhere; }
  std::optional<double> simpleBend(const ConvexProfile::Element&) const { return std::nullopt; }
  Vec3 directionAt(const Vec3&) const { return Vec3::Zero(); }

  SweptField field(const BodyContext& of) const { return *of.whole; }
  bool isAskedWhole(const BodyContext&) const { return false; }

  const ColumnSolid* uprightSolid() const { return nullptr; }
  std::optional<double> ownLength() const { return std::nullopt; }
  ToolPlace placeAt(double) const { return {Vec3::Zero(), Vec2::UnitX()}; }
};

/// Columns of quarters (bits) of a leaf; those beside each other in one call.
template <typename Kind>
void columnsOfQuarters(const Kind& kind, LeafColumns& leaf, unsigned quarters) {
  for (int q = 0; q < 4; ++q) {
    const int from = q * kQuarter;
    while (q < 4 && (quarters >> q & 1) != 0) ++q;
    if (const int count = q * kQuarter - from; count > 0)
      kind.columns(leaf.x + from, leaf.y + from, count, leaf.lo + from, leaf.hi + from);
  }
}

/// A solid whose axis stays upright on a way that the kernels know.
template <typename Way>
struct KernelBody : BodyDefaults {
  KernelBody() = default;
  explicit KernelBody(const Way& of) : way(of) {}

  Vec3 axis() const { return Vec3::UnitZ(); }
  const ColumnSolid& solid() const { return *way.solid; }

  void columns(const double* x, const double* y, int count, double* lo, double* hi) const {
    kernelsOf(way).columns(way, x, y, count, lo, hi);
  }
  void leafColumns(LeafColumns& leaf, unsigned quarters) const { kernelsOf(way).leaf(way, leaf, quarters); }
  void reach(const FourBlocks& blocks, double* low, double* high) const {
    kernelsOf(way).reach(way, blocks, low, high);
  }
  const ColumnSolid* uprightSolid() const { return way.solid; }

  Way way;

 protected:
  /// Of a way between two heights of the tip.
  double reachAbove(double highest_tip) const { return highest_tip + solid().z_max + kCullSlackMm; }
  /// A column is covered up to where the solid is widest, and farther.
  double topAbove(double lowest_tip) const { return lowest_tip - solid().upper.height(solid().radius); }
  /// No point of a column that the tool's axis comes this near to, level, is deeper in the solid, mm.
  double depthBeside(double gap) const {
    constexpr double kSlackMm = 1e-10;  // rounding
    const double in = std::min(gap, solid().radius);
    // Half of what the solid has above the point's radius and below it.
    const double half = -0.5 * (solid().upper.height(in) + solid().lower.height(in));
    return std::min(solid().radius - gap, half) + kSlackMm;
  }
};

/// Whether what turns around an axis leaves no pillar there that is thinner than the grid's step `h`, mm.
inline bool turnsWithoutPillar(const ColumnSolid& solid, double arc_radius, double h) {
  const double pillar = arc_radius - solid.radius;
  return pillar <= 0.0 || pillar >= h;
}

/// Unit direction at `p` of what turns level about an axis; `turn`: as ArcSweep::turn.
inline Vec3 directionAround(double x, double y, double turn, const Vec3& p) {
  return turn * Vec3(y - p.y(), p.x() - x, 0.0).stableNormalized();
}

/// Largest curvature of the round wall or the cone that ends in a plane; see SweptBody::simpleBend. `inner`:
/// the other radius that the element leaves, mm.
inline double wallBend(double radius, double inner) {
  constexpr double kLeastRadius = 1e-9;  // mm
  return 1.0 / std::max(std::min(radius, inner), kLeastRadius);
}

}  // namespace proveout
