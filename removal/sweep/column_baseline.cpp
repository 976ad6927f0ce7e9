#include "removal/sweep/column_kernel_body.h"

namespace proveout {

ColumnKernels baselineKernels() {
  return {columns, leafColumns, lowerTops, leafHits, cover, reachFour, edgeCuts, "baseline"};
}

}  // namespace proveout
