#include "core/path/origin_query.h"

#include <string_view>

#include "core/base/assert.h"
#include "core/path/line_word.h"

namespace proveout {
namespace {

constexpr double kMmPerInch = 25.4;

/// Columns, text, block and, where the record has none, the value from the line. `written`: the kind whose
/// address the word has.
void readLine(ResolvedOrigin& origin, OriginKind written, bool inch, const LineText& text) {
  const std::string line = text(origin.file, origin.line);
  if (line.empty()) return;
  if (origin.begin == 0) {
    if (const auto word = findWord(line, written)) {
      origin.begin = word->begin;
      origin.end = word->end;
      origin.value = word->value * (inch && isLength(written) ? kMmPerInch : 1.0);
    }
    origin.block = blockNumberIn(line);
  }
  if (origin.begin == 0 || origin.begin > line.size()) return;
  origin.text = line.substr(origin.begin - 1u, static_cast<std::size_t>(origin.end - origin.begin));
}

/// `left`: how many more may stand behind it.
ResolvedOrigin ofWord(const Toolpath& path, std::uint32_t number, const LineText& text, std::size_t& left) {
  PROVEOUT_ASSERT(number >= 1 && number <= path.origins.words.size());
  const WordOrigin& word = path.origins.words[number - 1];
  ResolvedOrigin origin;
  origin.kind = word.kind;
  origin.file = word.file;
  origin.line = word.line;
  origin.begin = word.begin;
  origin.end = word.end;
  origin.depth = word.depth;
  origin.block = word.block;
  origin.incremental = word.incremental && isCoordinate(word.kind);
  origin.value = word.value;
  readLine(origin, word.kind, word.inch, text);
  for (const std::uint32_t from : word.from) {
    if (left == 0) break;
    --left;
    origin.from.push_back(ofWord(path, from, text, left));
  }
  return origin;
}
ResolvedOrigin ofWord(const Toolpath& path, std::uint32_t number, const LineText& text) {
  std::size_t left = kMostBehind;
  return ofWord(path, number, text, left);
}

ResolvedOrigin ofCode(const Toolpath& path, const SourceRef& source, OriginKind kind, OriginCode code,
                      const LineText& text) {
  if (code.isWord()) {
    ResolvedOrigin origin = ofWord(path, code.number(), text);
    origin.kind = kind;  // the word of a level of a cycle is that of the coordinate too
    return origin;
  }
  ResolvedOrigin origin;
  origin.kind = kind;
  origin.file = source.file;
  const OriginCode::Reading reading = code.reading();
  origin.line = code.isLinesBack() ? source.line - code.lines() : code.lines();
  origin.depth = source.depth;
  origin.incremental = reading.incremental() && isCoordinate(kind);
  origin.value = std::numeric_limits<double>::quiet_NaN();
  readLine(origin, writtenAs(kind, reading), reading.inch(), text);
  return origin;
}

}  // namespace

std::optional<ResolvedOrigin> originOf(const Toolpath& path, MotionId motion, OriginKind kind,
                                       const LineText& text) {
  PROVEOUT_ASSERT(motion < path.motions.size());
  const SourceRef& source = path.motions[motion].source;
  const OriginCode code = path.origins.code(source.origins, kind);
  if (code.none()) return std::nullopt;
  return ofCode(path, source, kind, code, text);
}

std::vector<ResolvedOrigin> originsOf(const Toolpath& path, MotionId motion, const LineText& text) {
  std::vector<ResolvedOrigin> all;
  for (std::size_t k = 0; k < kOriginKinds; ++k) {
    if (auto origin = originOf(path, motion, static_cast<OriginKind>(k), text))
      all.push_back(std::move(*origin));
  }
  return all;
}

std::optional<ResolvedOrigin> originOfWord(const Toolpath& path, std::uint32_t number, const LineText& text) {
  if (number == 0) return std::nullopt;
  return ofWord(path, number, text);
}

std::optional<ResolvedOrigin> callOf(const Toolpath& path, MotionId motion, const LineText& text) {
  const std::int32_t index = path.motions[motion].source.origins;
  if (index < 0) return std::nullopt;
  PROVEOUT_ASSERT(static_cast<std::size_t>(index) < path.origins.sets.size());
  const OriginSet& set = path.origins.sets[static_cast<std::size_t>(index)];
  return originOfWord(path, path.origins.modal[set.modal].call, text);
}

const DataInForce* dataOf(const Toolpath& path, MotionId motion) {
  const std::int32_t index = path.motions[motion].source.origins;
  if (index < 0) return nullptr;
  PROVEOUT_ASSERT(static_cast<std::size_t>(index) < path.origins.sets.size());
  const OriginSet& set = path.origins.sets[static_cast<std::size_t>(index)];
  return &path.origins.data[path.origins.modal[set.modal].data];
}

}  // namespace proveout
