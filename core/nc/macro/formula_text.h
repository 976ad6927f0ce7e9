// Blanks, comments and words in the text of formulas.
#pragma once

#include <cstddef>
#include <string_view>

#include "core/base/characters.h"

namespace proveout::nc {

/// Behind blanks.
inline std::size_t behindBlanks(std::string_view text, std::size_t pos) {
  while (pos < text.size() && isBlank(text[pos])) ++pos;
  return pos;
}

/// Behind blanks and comments that end in this line.
inline std::size_t skipBlanks(std::string_view text, std::size_t pos) {
  while (pos < text.size()) {
    const char c = text[pos];
    if (isBlank(c)) {
      ++pos;
    } else if (c == '(') {
      const std::size_t close = text.find(')', pos);
      if (close == std::string_view::npos) return pos;
      pos = close + 1;
    } else {
      return pos;
    }
  }
  return pos;
}

/// Does `word` (upper case) stand at text[pos], letters of either case?
inline bool keywordAt(std::string_view text, std::size_t pos, std::string_view word) {
  if (pos + word.size() > text.size()) return false;
  for (std::size_t k = 0; k < word.size(); ++k) {
    if (upper(text[pos + k]) != word[k]) return false;
  }
  return true;
}

}  // namespace proveout::nc
