// The stock's surface, taken from the leaves. Only for .cpp files: pulls in OpenVDB.
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "removal/stock_impl.h"

namespace proveout {

/// Closed 2-manifold mesh of the stock. The order of vertices and triangles does not depend on the number of
/// threads. Errors: cancelled; more vertices than a mesh can number; a grid with a hole (a bug).
Result<StockSurface> extractSurface(const Stock::Impl& impl, Progress& progress);

}  // namespace proveout
