// Programs that stand one behind the other in a text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace proveout::nc {

/// Where a program begins: a line with O1234, :1234 or a name in front.
struct ProgramHead {
  std::size_t line = 0;      ///< index
  std::int64_t number = -1;  ///< -1: it has a name
  std::string_view name = {};
};

/// In the order of the lines; a line inside a comment begins no program. `comments_end_in_line`: a comment
/// that nobody closes ends with its line, and O<NAME> or <NAME> in front of a line begins a program too.
std::vector<ProgramHead> programHeads(const std::vector<std::string_view>& lines,
                                      bool comments_end_in_line = false);

}  // namespace proveout::nc
