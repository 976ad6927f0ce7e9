// Where the values of macro variables come from, as evaluators tell it.
#pragma once

#include <cstdint>
#include <span>

#include "core/nc/text/block.h"

namespace proveout::nc {

/// What an expression read, in one number: 0 nothing, else a word, or a list of several (see OriginWords).
using ReadList = std::uint32_t;

class ValueOrigins {
 public:
  virtual ~ValueOrigins() = default;
  /// Of an expression that read variables which these words assigned.
  virtual ReadList listOf(std::span<const std::uint32_t> words) = 0;
  /// Number of the assignment at `columns` of the block in hand.
  virtual std::uint32_t assigned(Columns columns, double value, ReadList reads) = 0;
};

}  // namespace proveout::nc
