#include "removal/sweep/column_kernel_body.h"

namespace proveout {

ColumnKernels avx512Kernels() { return {columns, leafColumns, cover, reachFour, "avx512"}; }

}  // namespace proveout
