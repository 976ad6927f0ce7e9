#include "removal/column_kernel_body.h"

namespace proveout {

ColumnKernels baselineKernels() { return {columns, leafColumns, reachFour, "baseline"}; }

}  // namespace proveout
