// Columns and reach of the parts of curves (ColumnSweep::Kind::kTurn and kUpright), one column after the
// other: the kernels of every SIMD level call the same code. Plain declarations only, see column_types.h.
#pragma once

#include "removal/sweep/column_types.h"

namespace proveout {

/// As ColumnKernel; error below 1e-8 mm.
void curveColumns(const ColumnSweep& sweep, const double* x, const double* y, int count, double* lo,
                  double* hi);
/// Above 0 outside, 0 on the surface, below 0 inside; changes steadily along level lines but where the way
/// comes to be over them, mm.
double curveOutside(const ColumnSweep& sweep, double x, double y, double z);
/// As ReachKernel.
void curveReach(const ColumnSweep& sweep, const FourBlocks& blocks, double* low);

}  // namespace proveout
