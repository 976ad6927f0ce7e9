// Lines with several blocks: a ; ends one (LexRules::semicolon_ends_block).
#pragma once

#include <cstddef>

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// Where a block stands in its line, indices.
struct BlockSpan {
  std::size_t from = 0;
  std::size_t end = 0;
};

/// The block of the frame's line that is to be read now. Where another one stands behind it the frame comes
/// back to the line. What stands behind a ; and is no block is a comment, which is noted once.
BlockSpan nextSpan(IsoContext& c, CallFrame& frame);

/// Notes about comments of the block in hand: a ( inside of one, and one that nobody closes. Each once.
void noteComments(IsoContext& c);

}  // namespace proveout::nc
