#include "removal/sweep/column_kernel_body.h"

namespace proveout {

ColumnKernels baselineKernels() { return kernels("baseline"); }

}  // namespace proveout
