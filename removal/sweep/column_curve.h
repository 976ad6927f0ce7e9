// Columns and reach of the parts of curves (TurnSweep, UprightSweep and WaySweep), one column after the
// other: the kernels of every SIMD level call the same code for what they have no closed form of. Plain
// declarations only, see column_types.h.
#pragma once

#include "removal/sweep/column_types.h"

namespace proveout {

/// Least k2 of a column, mm2: those on the axis of a helix are as far from all of it.
inline constexpr double kLeastAcross = 1e-12;

/// As ColumnKernel for one column; error below 1e-8 mm.
void curveColumn(const TurnSweep& sweep, double x, double y, double* lo, double* hi);
void curveColumn(const UprightSweep& sweep, double x, double y, double* lo, double* hi);
void curveColumn(const WaySweep& sweep, double x, double y, double* lo, double* hi);

/// A point as a part of a curve sees it.
struct CurveSide {
  /// Above 0 outside, 0 on the surface, below 0 inside; changes steadily along level lines but where the way
  /// comes to be over them, mm.
  double value;
  /// Where the tool is when it decides the value; of a point of the surface: when it leaves it there. Turn
  /// and way: angle of the whole way, rad; upright: the place along (ux, uy) from the center, mm.
  double place;
  double slope;  ///< of the value along the direction; 0 also where it is not known
};
/// (dx, dy): a level direction, unit.
CurveSide curveSide(const TurnSweep& sweep, const double (&point)[3], double dx, double dy);
CurveSide curveSide(const UprightSweep& sweep, const double (&point)[3], double dx, double dy);
CurveSide curveSide(const WaySweep& sweep, const double (&point)[3], double dx, double dy);
/// As ReachKernel.
void curveReach(const TurnSweep& sweep, const FourBlocks& blocks, double* low, double* high);
void curveReach(const UprightSweep& sweep, const FourBlocks& blocks, double* low, double* high);
void curveReach(const WaySweep& sweep, const FourBlocks& blocks, double* low, double* high);

}  // namespace proveout
