// Which variables are the cells of the offset tables.
#pragma once

#include <vector>

#include "core/nc/iso/system_variables/tool_offset_bank.h"

namespace proveout::nc {

/// What the numbers depend on.
struct OffsetNumbering {
  int memory = 2;          ///< 0 A one table; 1 B geometry and wear; 2 C the same with H and D apart
  bool v15 = false;        ///< 6000#3: geometry comes first
  bool haas = false;       ///< no numbers from #10001 on
  bool diameters = false;  ///< D holds diameters
};
std::vector<OffsetNumbers> millOffsetNumbers(const OffsetNumbering& numbering);
std::vector<OffsetNumbers> latheOffsetNumbers(const OffsetNumbering& numbering);

}  // namespace proveout::nc
