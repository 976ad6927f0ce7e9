// The programs of the WL4 control that are open, each called by the one before.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/nc/flow/flow_frame.h"
#include "core/nc/wl4/wl4_programs.h"
#include "core/path/source_ref.h"

namespace proveout::nc {

/// An open program.
struct Wl4Level : FlowFrame {
  explicit Wl4Level(const Wl4Program& opened) : program(&opened) {
    first = opened.first;
    end = opened.last;
  }
  const Wl4Program* program;
};
using Wl4Levels = std::vector<Wl4Level>;

/// Of the block in hand, without the words in force. Line 0: no program is open.
inline SourceRef placeOf(const Wl4Levels& levels) {
  SourceRef at;
  if (levels.empty()) return at;
  const Wl4Level& level = levels.back();
  at.file = level.program->file;
  at.line = static_cast<std::uint32_t>(level.block + 1);
  at.block = level.number;
  at.depth = static_cast<decltype(at.depth)>(levels.size() - 1);
  return at;
}

}  // namespace proveout::nc
