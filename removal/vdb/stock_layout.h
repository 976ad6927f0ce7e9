// How the file of a saved stock is built. Whoever can write a file can give it a right checksum, and
// OpenVDB's reader trusts what it reads: counts, offsets, types. So that it never meets what Stock::save does
// not write, the file is walked here first, from its first byte to its last, and OpenVDB is given the trees
// alone, where the walk found them. Only for the sources of the module.
#pragma once

#include <openvdb/openvdb.h>

#include <array>
#include <cstdint>
#include <istream>
#include <stdexcept>
#include <string>

#include "removal/grid/stock_impl.h"

namespace proveout {

inline constexpr char kStockSchema[] = "proveout.stock/2";
/// Flags of OpenVDB's compression in a saved stock.
inline constexpr std::uint32_t kStockCompression =
    openvdb::io::COMPRESS_BLOSC | openvdb::io::COMPRESS_ACTIVE_MASK;
inline constexpr std::size_t kStockGrids = 13;

/// Names of the grids in their order: distance; t, normal, motion and element of the crossings along x, y and
/// z.
const std::array<std::string, kStockGrids>& stockGridNames();

/// More memory than is allowed.
struct StockTooLarge : std::runtime_error {
  StockTooLarge() : std::runtime_error("more memory than is allowed") {}
};

/// Where the trees stand.
struct StockLayout {
  std::array<std::streamoff, kStockGrids> trees{};
  openvdb::VersionId library;  ///< that wrote the file
};

/// Walks the first `size` bytes of a file, and fills h, origin, blank and initial volume of `impl`. Throws
/// StockTooLarge where the stock's tree, or the file's grids, would take more than `limit_bytes`, else
/// std::runtime_error: not built as Stock::save builds it (says where).
StockLayout walkStockFile(std::istream& file, std::uint64_t size, double limit_bytes, Stock::Impl& impl);

/// Reads the tree of the grid `index`, whose type is that of the walk. Throws std::exception: values that do
/// not unpack.
template <typename Grid>
typename Grid::Ptr readStockTree(std::istream& file, const StockLayout& layout, std::size_t index) {
  file.clear();
  file.seekg(layout.trees[index]);
  openvdb::io::setVersion(file, layout.library, openvdb::OPENVDB_FILE_VERSION);
  openvdb::io::setDataCompression(file, kStockCompression);
  typename Grid::Ptr grid = Grid::create(openvdb::zeroVal<typename Grid::ValueType>());
  grid->tree().readTopology(file);
  grid->tree().readBuffers(file);
  if (!file) throw std::runtime_error("it cannot be read");
  return grid;
}

}  // namespace proveout
