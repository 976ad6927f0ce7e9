#include "core/nc/origins/origin_words.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace proveout::nc {
namespace {

constexpr ReadList kList = 0x8000'0000u;
constexpr std::uint8_t kIncremental = 1, kInch = 2;
const std::uint64_t kNoValue = std::bit_cast<std::uint64_t>(std::numeric_limits<double>::quiet_NaN());

std::uint64_t hashOfList(const std::vector<std::uint32_t>& words) {
  std::uint64_t hash = 0;
  for (const std::uint32_t word : words) hash = mixBits(hash ^ word);
  return hash;
}

}  // namespace

std::uint64_t OriginWords::hashOf(const Key& key) {
  const auto pack = [](std::uint64_t high, std::uint64_t low) { return high << 32 | low; };
  std::uint64_t hash = mixBits(pack(key.file, key.line));
  hash = mixBits(hash ^ pack(static_cast<std::uint64_t>(key.begin) << 16 | key.end,
                             static_cast<std::uint64_t>(key.depth) << 16 |
                                 static_cast<std::uint64_t>(key.kind) << 8 | key.flags));
  hash = mixBits(hash ^ pack(static_cast<std::uint32_t>(key.channel), key.reads));
  return mixBits(hash ^ key.value);
}

OriginWords::Key OriginWords::keyOf(const WordOrigin& word, ReadList reads, int channel) {
  const auto flags =
      static_cast<std::uint8_t>((word.incremental ? kIncremental : 0) | (word.inch ? kInch : 0));
  const std::uint64_t value = std::isnan(word.value) ? kNoValue : std::bit_cast<std::uint64_t>(word.value);
  return {word.file, word.line, word.begin, word.end, word.depth, word.kind,
          flags,     channel,   reads,      value,    word.block};
}

WordOrigin OriginWords::wordOf(const Key& key) {
  WordOrigin word;
  word.file = key.file;
  word.line = key.line;
  word.begin = key.begin;
  word.end = key.end;
  word.depth = key.depth;
  word.kind = key.kind;
  word.incremental = (key.flags & kIncremental) != 0;
  word.inch = (key.flags & kInch) != 0;
  word.block = key.block;
  word.value = std::bit_cast<double>(key.value);
  return word;
}

ReadList OriginWords::listOf(std::span<const std::uint32_t> words) {
  if (words.empty()) return 0;
  if (words.size() == 1) return words.front();
  std::vector<std::uint32_t> once;
  for (const std::uint32_t word : words) {
    if (std::find(once.begin(), once.end(), word) == once.end()) once.push_back(word);
  }
  if (once.size() == 1) return once.front();
  const std::uint64_t hash = hashOfList(once);
  const std::uint32_t known = lists_.find(once, hash);
  return kList | (known != lists_.kNone ? known : lists_.add(once, hash));
}

std::span<const std::uint32_t> OriginWords::elements(const ReadList& reads) const {
  if (reads == 0) return {};
  if ((reads & kList) == 0) return {&reads, 1};
  return lists_.at(reads & ~kList);
}

std::uint32_t OriginWords::numberOf(const WordOrigin& word, ReadList reads, int channel, MotionSink& sink) {
  Key key = keyOf(word, reads, channel);
  if (reads == 0) return intern(key, sink);
  steps_ = 0;
  const std::uint64_t value = std::exchange(key.value, kNoValue);
  Capped& last = capped_[(key.line * 31 + key.begin) % capped_.size()];
  if (last.number != 0 && last.key == key) return last.number;
  key.value = value;
  const std::uint32_t known = keys_.find(key, hashOf(key));
  if (known != keys_.kNone) return numbers_[known];
  if (valueIsKept(key)) return intern(key, sink);
  key.value = kNoValue;
  last = {key, intern(key, sink)};
  return last.number;
}

/// Index of the place of a computed word.
std::uint32_t OriginWords::placeOf(const Key& key) {
  const Key place{key.file, key.line, key.begin, 0, 0, OriginKind::kX, 0, key.channel, 0, 0, 0};
  const std::uint64_t hash = hashOf(place);
  std::uint32_t index = places_.find(place, hash);
  if (index == places_.kNone) {
    index = places_.add(place, hash);
    values_.push_back(0);
    cuts_.push_back(0);
  }
  return index;
}

/// The word with less to read.
std::uint32_t OriginWords::internCut(Key key, ReadList reads, MotionSink& sink) {
  key.reads = reads;
  const std::uint32_t known = keys_.find(key, hashOf(key));
  if (known != keys_.kNone) return numbers_[known];
  if (cuts_[placeOf(key)]++ >= kMostCuts) key.reads = 0;
  return intern(key, sink);
}

std::uint32_t OriginWords::intern(const Key& key, MotionSink& sink) {
  const std::uint64_t hash = hashOf(key);
  const std::uint32_t known = keys_.find(key, hash);
  if (known != keys_.kNone) return numbers_[known];
  const ReadList reads = without(key.reads, key, sink);
  const std::uint32_t number = reads == key.reads ? 0 : internCut(key, reads, sink);
  const std::uint32_t index = keys_.add(key, hash);
  numbers_.push_back(number);
  if (number == 0) numbers_[index] = make(keys_.at(index), sink);
  return numbers_[index];
}

/// The word itself: what it reads does not come back to its place.
std::uint32_t OriginWords::make(const Key& key, MotionSink& sink) {
  WordOrigin word = wordOf(key);
  std::uint8_t generation = 0;
  for (const std::uint32_t from : elements(key.reads)) {
    word.from.push_back(from);
    generation = std::max<std::uint8_t>(generation, generations_[from - 1] + 1);
  }
  sources_.push_back(keys_.find(key, hashOf(key)));
  generations_.push_back(generation);
  sink.originWord(word);
  return static_cast<std::uint32_t>(sources_.size());
}

/// The list without words of that place: what these read stands for them. Words as old as may be lose what
/// they read.
ReadList OriginWords::without(ReadList reads, const Key& place, MotionSink& sink) {
  std::vector<std::uint32_t> kept;
  const std::span<const std::uint32_t> all = elements(reads);
  const std::vector<std::uint32_t> words(all.begin(), all.end());  // making words may move the lists
  for (const std::uint32_t word : words) {
    Key key = keyOf(word);
    if (key.samePlace(place)) {
      const auto behind = elements(key.reads);
      kept.insert(kept.end(), behind.begin(), behind.end());
    } else if (generations_[word - 1] + 1 >= kMostGenerations) {
      kept.push_back(internCut(key, 0, sink));
    } else if (steps_ < kMostSteps ? reaches(word, place) : key.reads != 0) {
      const ReadList less = steps_ < kMostSteps ? without(key.reads, place, sink) : 0;
      kept.push_back(internCut(key, less, sink));
    } else {
      kept.push_back(word);
    }
    if (kept.size() >= kMostReads) break;
  }
  kept.resize(std::min(kept.size(), kMostReads));
  return listOf(kept);
}

/// Also where it takes too long to find out.
bool OriginWords::reaches(std::uint32_t word, const Key& place) {
  const Key& key = keyOf(word);
  if (++steps_ > kMostSteps) return key.reads != 0;
  if (key.samePlace(place)) return true;
  const auto behind = elements(key.reads);
  return std::any_of(behind.begin(), behind.end(), [&](std::uint32_t from) { return reaches(from, place); });
}

}  // namespace proveout::nc
