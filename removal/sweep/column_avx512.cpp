#include "removal/sweep/column_kernel_body.h"

namespace proveout {

ColumnKernels avx512Kernels() { return kernels("avx512"); }

}  // namespace proveout
