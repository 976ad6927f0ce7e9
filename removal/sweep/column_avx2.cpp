#include "removal/sweep/column_kernel_body.h"

namespace proveout {

ColumnKernels avx2Kernels() {
  return {columns, leafColumns, lowerTops, leafHits, cover, reachFour, edgeCuts, "avx2"};
}

}  // namespace proveout
