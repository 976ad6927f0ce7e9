// Stretches of any curve that an arc's words describe: spirals, cones of helices, arcs and helices about axes
// that lean. As column_curve.h, for what has no closed form; column_way_body.h has the vectors.
//
// The way is C + R(t) (u cos t + v sin t) + climb t with R(t) = radius + growth t for angles t from 0 on; a
// pass is a part of a sixteenth of a turn. A part may be over a column twice, where it bends more than the
// tool's rim: what it covers then are two intervals, of two passes (WaySweep::again).
#pragma once

#include <optional>
#include <vector>

#include "core/geometry/types.h"
#include "core/path/toolpath.h"
#include "removal/sweep/column_interval.h"

namespace proveout {

struct CurveWay {
  /// A place of the way and its derivatives by the angle, mm; its own angle's cosine and sine.
  struct Node {
    Vec3 at, velocity, bend;
    double cosine, sine;
  };
  static constexpr int kNodesAPart = 4;

  Vec3 center, u, v, climb;                  ///< mm; climb: a radian
  double radius, growth, way_rad, node_rad;  ///< mm, mm a radian; angles of the way and between nodes
  std::vector<Node> nodes;                   ///< kNodesAPart a part, and one
  std::vector<WayPart> plain;                ///< its parts for the kernels
  double most_bend;                          ///< no |Node::bend| is larger
  double still4;   ///< what the fourth derivative of a squared level distance has from the way alone,
  double far4;     ///< and for each mm that the column is off its axis
  double height4;  ///< no fourth derivative of the height is larger

  /// At any angle of the way.
  Node node(double rad) const;
  int parts() const { return static_cast<int>(nodes.size()) / kNodesAPart; }
};

CurveWay curveWay(const Vec3& from, const Vec3& to, const ArcGeometry& arc);

/// Whether the kernels have vectors for the solid: a level top, and below a disc, a sphere or a disc with a
/// corner.
bool hasPlainEnds(const ColumnSolid& solid);

/// Whether the kernels have vectors for all columns that see the part but for few.
bool isPlainPart(const WaySweep& part);

/// Passes of a solid along the way, in the order of the motion; both must outlive them.
std::vector<WaySweep> columnParts(const ColumnSolid& solid, const CurveWay& way);

/// What a column sees of a part; Interval::u, at_lo, at_hi are angles of the way.
Interval wayColumn(const WaySweep& part, double x, double y, const Asked& asked);
/// The same where it has a short search: for one end of solids with plain ends; else nothing.
std::optional<Interval> plainWayColumn(const WaySweep& part, double x, double y, const Asked& asked);
/// Least level distance of the tool's axis from a column, mm.
double wayGap(const WaySweep& part, double x, double y);

}  // namespace proveout
