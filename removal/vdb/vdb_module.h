// The functions of the module behind vdb_support.h, which says what they do.
#pragma once

#include <string>

#include "removal/grid/stock_impl.h"

namespace proveout {

Status writeStockFile(const Stock::Impl& impl, const std::string& path);
Status readStockFile(Stock::Impl& impl, const std::string& path, const RemovalOptions& options);
Status rasteriseMesh(Stock::Impl& impl, const MeshShape& shape, const RemovalOptions& options);

}  // namespace proveout
