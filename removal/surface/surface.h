// The stock's surface, taken from the leaves. Only for the .cpp files of removal.
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "removal/grid/stock_impl.h"

namespace proveout {

/// Stock::surface without the limit of threads. Errors: cancelled; more vertices than a mesh can number; a
/// grid with a hole (a bug).
Result<StockSurface> extractSurface(const Stock::Impl& impl, const SurfaceOptions& options,
                                    Progress& progress);

}  // namespace proveout
