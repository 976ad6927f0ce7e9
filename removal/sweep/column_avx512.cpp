#include "removal/sweep/column_kernel_body.h"

namespace proveout {

ColumnKernels avx512Kernels() {
  return {columns, leafColumns, lowerTops, leafHits, cover, reachFour, edgeCuts, "avx512"};
}

}  // namespace proveout
