// Reading the origins of a path: which words made a motion, where they stand and what they say.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/path/toolpath.h"
#include "core/path/word_origin.h"

namespace proveout {

/// Text of line `line` (from 1) of Toolpath::files[file], UTF-8, without its end. Empty where it is not
/// known: then places have no columns.
using LineText = std::function<std::string(std::uint32_t file, std::uint32_t line)>;

/// A word in force, or an assignment behind one.
struct ResolvedOrigin {
  OriginKind kind = OriginKind::kVariable;
  std::uint32_t file = 0;            ///< index into Toolpath::files
  std::uint32_t line = 0;            ///< from 1
  std::uint16_t begin = 0, end = 0;  ///< columns from 1, end one past; 0: the text is not known
  std::uint16_t depth = 0;           ///< as in SourceRef
  std::int64_t block = -1;           ///< N number, or -1
  bool incremental = false;          ///< a step: the coordinate depends on the words before as well
  double value = 0.0;                ///< as the word says it, lengths in mm; NaN: not known
  std::string text;                  ///< "Z-3.5", "G43", "#101=-3"
  std::vector<ResolvedOrigin> from;  ///< assignments of the variables that the word read
};
/// So many assignments are given behind one word, in the order of reading; further ones are left out.
inline constexpr std::size_t kMostBehind = 100;

/// The word of that kind in force during the motion. Nothing: the program never said it.
std::optional<ResolvedOrigin> originOf(const Toolpath& path, MotionId motion, OriginKind kind,
                                       const LineText& text);
/// All words in force during the motion, in the order of OriginKind.
std::vector<ResolvedOrigin> originsOf(const Toolpath& path, MotionId motion, const LineText& text);
/// The word with that number (index + 1 of OriginTables::words), as `..._by` of DataInForce gives it. Nothing
/// for 0.
std::optional<ResolvedOrigin> originOfWord(const Toolpath& path, std::uint32_t number, const LineText& text);
/// The block that called the program of the motion, its own call in `from`. Nothing: the motion is one of the
/// main program, or nothing was recorded for it.
std::optional<ResolvedOrigin> callOf(const Toolpath& path, MotionId motion, const LineText& text);
/// The rows of the tables that the motion was made with. Null: nothing was recorded for it.
const DataInForce* dataOf(const Toolpath& path, MotionId motion);

}  // namespace proveout
