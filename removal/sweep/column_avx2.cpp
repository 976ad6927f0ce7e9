#include "removal/sweep/column_kernel_body.h"

namespace proveout {

ColumnKernels avx2Kernels() { return kernels("avx2"); }

}  // namespace proveout
