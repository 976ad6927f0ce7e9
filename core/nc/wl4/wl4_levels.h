// The programs of the WL4 control that are open, each called by the one before.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/nc/wl4/wl4_programs.h"
#include "core/path/source_ref.h"

namespace proveout::nc {

/// An open program.
struct Wl4Level {
  const Wl4Program* program = nullptr;
  std::size_t line = 0;  ///< of the block in hand
  std::int64_t number = -1;
  std::uint64_t run = 0;  ///< of this repetition of the call
  /// Of the call, from 1; 0: the main program.
  struct Call {
    std::uint64_t number = 0;
    int repetition = 0, repetitions = 1;
  };
  Call call = {};
};
using Wl4Levels = std::vector<Wl4Level>;

/// Of the block in hand, without the words in force. Line 0: no program is open.
inline SourceRef placeOf(const Wl4Levels& levels) {
  SourceRef at;
  if (levels.empty()) return at;
  const Wl4Level& level = levels.back();
  at.file = level.program->file;
  at.line = static_cast<std::uint32_t>(level.line + 1);
  at.block = level.number;
  at.depth = static_cast<decltype(at.depth)>(levels.size() - 1);
  return at;
}

}  // namespace proveout::nc
