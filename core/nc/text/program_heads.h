// Programs that stand one behind the other in a text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace proveout::nc {

/// Where a program begins: a line with O1234 or :1234 in front.
struct ProgramHead {
  std::size_t line = 0;  ///< index
  std::int64_t number = 0;
};

/// In the order of the lines; a line inside a comment begins no program.
std::vector<ProgramHead> programHeads(const std::vector<std::string_view>& lines);

}  // namespace proveout::nc
