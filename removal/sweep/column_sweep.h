// Where a moving tool covers vertical lines of the grid: for each column (x, y) the interval of z that the
// swept volume of a convex solid of revolution about z holds.
//
// A swept convex solid along a line is convex, so it meets a vertical line in one interval, whose ends are
// the least of (height of the tool + lower boundary) and the greatest of (height + upper boundary) over the
// time in which the tool is over the column. Both are found in closed form (flat ends, cones, balls) or by
// bisection (torus corners); level arcs have their nearest position in closed form. The same operations run
// for every SIMD level, so that the results are equal bit for bit.
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/geometry/types.h"
#include "core/path/toolpath.h"
#include "core/tool/profile.h"
#include "removal/sweep/column_types.h"

namespace proveout {

ColumnSolid columnSolid(const ConvexProfile& profile);
/// Whether the upper boundary is one level disc of the full radius.
inline bool hasLevelTop(const ColumnSolid& solid) { return !solid.round_top; }

/// `solid` must outlive the sweep.
LineSweep columnLine(const ColumnSolid& solid, const Vec3& from, const Vec3& to);
/// Requires a vertical axis, one radius and no rise.
ArcSweep columnArc(const ColumnSolid& solid, const Vec3& from, const Vec3& to, const ArcGeometry& arc);

/// Turns of a helix about z, in the order of the motion; a circle may have no rise. Requires one radius: but
/// for rounding of its ends it is their mean.
std::vector<TurnSweep> columnTurns(const ColumnSolid& solid, const Vec3& from, const Vec3& to,
                                   const ArcGeometry& arc);
/// Whether all of the turn is on the way, however far around a column stands.
bool isWholeTurn(const TurnSweep& turn);
/// An arc in an upright plane, from where it turns back to where it does so again. Requires a level axis, no
/// rise along it, and one radius as above.
std::vector<UprightSweep> columnUprights(const ColumnSolid& solid, const Vec3& from, const Vec3& to,
                                         const ArcGeometry& arc);

inline Vec3 sweepStart(const LineSweep& s) { return {s.x, s.y, s.z}; }
/// From start to end of a line.
inline Vec3 sweepWay(const LineSweep& s) { return {s.ux * s.length, s.uy * s.length, s.rise}; }

/// The kernels of the widest SIMD level that the machine has; PROVEOUT_SIMD=baseline|avx2|avx512 asks for a
/// narrower one, and what is no level or one that the machine lacks counts as not asked for.
const ColumnKernels& pickedKernels();
inline const ColumnKernels& columnKernels() {
  static const ColumnKernels& picked = pickedKernels();  // a call is more than some of them take
  return picked;
}
/// Those of one kind of way.
inline const WayKernels<LineSweep>& kernelsOf(const LineSweep&) { return columnKernels().line; }
inline const WayKernels<ArcSweep>& kernelsOf(const ArcSweep&) { return columnKernels().arc; }
inline const WayKernels<TurnSweep>& kernelsOf(const TurnSweep&) { return columnKernels().turn; }
inline const WayKernels<UprightSweep>& kernelsOf(const UprightSweep&) { return columnKernels().upright; }
inline const WayKernels<WaySweep>& kernelsOf(const WaySweep&) { return columnKernels().way; }
/// Errors: PROVEOUT_SIMD names no level, or one that the machine lacks; says which there are.
Status checkSimdWish();

}  // namespace proveout
