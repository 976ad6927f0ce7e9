// What a block plans for the tables of tool management.
#pragma once

namespace proveout::nc {

struct IsoContext;

/// G10 L75, L76, L77: the blocks that follow are data of a table.
struct ToolTableInput {
  bool clears = false;                   ///< rows lose what they held
  bool (*block)(IsoContext&) = nullptr;  ///< see DataInput
};

}  // namespace proveout::nc
