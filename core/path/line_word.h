// Finds a word in the text of a block: letters with plain numbers, as all controls with addresses write them.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/path/word_origin.h"

namespace proveout {

/// A word of a line: columns from 1, end one past; the number as it is written.
struct LineWord {
  std::uint16_t begin = 0, end = 0;
  double value = 0.0;
};

/// The last word of the line that can be of that kind: by its address, G and M codes by their number too. The
/// line has plain words and comments only. Nothing: there is none.
std::optional<LineWord> findWord(std::string_view line, OriginKind kind);
/// N number of the line, or -1.
std::int64_t blockNumberIn(std::string_view line);

}  // namespace proveout
