// Blanks, comments and words in the text of formulas.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
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

/// Digits with at most one point among them, without a sign.
struct PlainNumber {
  /// So many digits make an integer that a double holds, and divide by a power of ten that one holds too.
  static constexpr std::size_t kExact = 15;

  std::size_t end = 0;  ///< behind it
  std::size_t digits = 0, fraction = 0;
  std::uint64_t mantissa = 0;  ///< of the first kExact digits and one

  bool exact() const { return digits <= kExact; }
  /// The nearest double, where it is exact().
  double value() const {
    constexpr std::array<double, kExact + 1> kTens{1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                   1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    return static_cast<double>(mantissa) / kTens[fraction];
  }
};

/// The one that stands at text[begin]; without digits: none does. A second point ends it.
inline PlainNumber plainNumberAt(std::string_view text, std::size_t begin) {
  PlainNumber out;
  bool point = false;
  std::size_t i = begin;
  for (; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '.' && !point) {
      point = true;
    } else if (isDigit(c)) {
      if (out.digits <= PlainNumber::kExact)
        out.mantissa = out.mantissa * 10 + static_cast<unsigned>(c - '0');
      ++out.digits;
      out.fraction += point;
    } else {
      break;
    }
  }
  out.end = i;
  return out;
}

}  // namespace proveout::nc
