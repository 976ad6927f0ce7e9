#include "removal/sweep/column_kernel_body.h"

namespace proveout {

ColumnKernels avx2Kernels() { return {columns, leafColumns, leafHits, cover, reachFour, "avx2"}; }

}  // namespace proveout
