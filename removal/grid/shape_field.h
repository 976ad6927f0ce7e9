// What a blank's or fixture's shape tells of distances.
#pragma once

#include <memory>

#include "removal/grid/blank_field.h"
#include "removal/grid/stock_shape.h"

namespace proveout {

/// The field of a shape; of a mesh the distance is exact on both sides. Null for a saved stock, which does
/// not tell its faces.
Result<std::unique_ptr<BlankField>> shapeField(const StockShape& shape);

}  // namespace proveout
