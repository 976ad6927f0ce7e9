// A line of LinuxCNC without what means nothing: blanks and comments.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/nc/text/block.h"

namespace proveout::nc {

/// What is wrong with a line, as the interpreter says it. Places are indices into LcnLine::text.
struct LcnFault {
  const char* name = nullptr;  ///< of the diagnostic, behind the control's; null: nothing is wrong
  std::string message;
  std::size_t begin = 0, end = 0;
};

/// Small letters, as case means nothing; text of comments as it was written.
struct LcnLine {
  std::string text;                    ///< without blanks and comments
  std::vector<std::uint16_t> columns;  ///< of each character in the program's line, from 1
  std::string_view comment;            ///< the last one in ( ), without them; active comments are among these
  bool has_comment = false;
  Columns comment_columns;

  /// The columns of characters `begin` up to `end`.
  Columns columnsOf(std::size_t begin, std::size_t end) const;
};

/// Longest line, characters (LinuxCNC 2.9 takes 252 and the end of the line).
inline constexpr std::size_t kLongestLcnLine = 252;

/// Takes a line apart. `out.comment` points into `line`. False: `fault` says why; its places are columns of
/// the line itself, from 0.
bool takeLcnLine(std::string_view line, LcnLine& out, LcnFault& fault);

}  // namespace proveout::nc
