#include "removal/sweep/column_kernel_body.h"

namespace proveout {

ColumnKernels avx2Kernels() { return {columns, leafColumns, cover, reachFour, "avx2"}; }

}  // namespace proveout
