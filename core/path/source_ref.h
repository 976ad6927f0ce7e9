// A place in a program.
#pragma once

#include <cstdint>

namespace proveout {

/// Where a motion comes from in the program.
struct SourceRef {
  std::uint32_t file = 0;     ///< index into Toolpath::files
  std::uint32_t line = 0;     ///< from 1
  std::int64_t block = -1;    ///< N number of the block, or -1
  std::uint16_t depth = 0;    ///< 0 in the main program, +1 per subprogram level
  std::int32_t origins = -1;  ///< index into OriginTables::sets: the words in force; -1: not recorded
};

/// Of one block: the same line of a file, called as deep.
inline bool sameBlock(const SourceRef& a, const SourceRef& b) {
  return a.file == b.file && a.line == b.line && a.depth == b.depth;
}

}  // namespace proveout
