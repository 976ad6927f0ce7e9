// What a block plans for the tool offset tables.
#pragma once

#include <array>
#include <cstddef>

#include "core/nc/iso/model/offset_tables.h"
#include "core/nc/text/block.h"

namespace proveout::nc {

/// New values of one row.
struct OffsetChange {
  struct Cell {
    OffsetColumn column;
    double value;
    Address word;  ///< that says it
  };
  int row = 0;
  bool wear = false;
  std::array<Cell, 4> cells{};
  std::size_t count = 0;
  int tip = -1;  ///< -1: stays
};

}  // namespace proveout::nc
