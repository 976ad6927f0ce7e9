// The words that origins name besides plain ones: assignments, arguments, computed words, words of other
// programs. Each is kept once.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/nc/origins/intern_table.h"
#include "core/nc/origins/value_origins.h"
#include "core/nc/text/block.h"
#include "core/path/toolpath.h"

namespace proveout::nc {

/// Common to the channels of a control, since they share variables. Words are numbered from 1 (0: none) in
/// the order in which they are sent.
class OriginWords {
 public:
  /// Variables computed from variables are followed so many times.
  static constexpr std::uint8_t kMostGenerations = 8;
  /// A place whose computed values are more is kept without values from there on: a loop would fill the
  /// memory.
  static constexpr std::uint32_t kMostValues = 64;
  // Variables that a loop computes from each other in all ways would take time and memory without end:
  static constexpr std::size_t kMostReads = 32;     ///< words that one word names
  static constexpr std::uint32_t kMostSteps = 256;  ///< words looked at for one new word
  /// A place has so many words that lost some of what they read; the next ones lose all of it.
  static constexpr std::uint32_t kMostCuts = 1024;

  /// The list of these words; doubled ones count once.
  ReadList listOf(std::span<const std::uint32_t> words);
  /// Number of `word` (its `from` is left out of account), whose expression read `reads`. Sent to the sink if
  /// it is new. `channel`: whose files and lines they are.
  std::uint32_t numberOf(const WordOrigin& word, ReadList reads, int channel, MotionSink& sink);

 private:
  /// A word as it is told apart; `value` by its bits, so that NaN is a value.
  struct Key {
    std::uint32_t file, line;
    std::uint16_t begin, end, depth;
    OriginKind kind;
    std::uint8_t flags;
    std::int32_t channel;
    ReadList reads;
    std::uint64_t value;
    std::int64_t block;
    bool operator==(const Key&) const = default;
    bool samePlace(const Key& other) const {
      return line == other.line && begin == other.begin && file == other.file && channel == other.channel;
    }
  };
  static std::uint64_t hashOf(const Key& key);
  static Key keyOf(const WordOrigin& word, ReadList reads, int channel);
  static WordOrigin wordOf(const Key& key);

  std::uint32_t intern(const Key& key, MotionSink& sink);
  std::uint32_t make(const Key& key, MotionSink& sink);
  std::uint32_t internCut(Key key, ReadList reads, MotionSink& sink);
  std::uint32_t placeOf(const Key& key);
  bool valueIsKept(const Key& key) { return values_[placeOf(key)]++ < kMostValues; }
  ReadList without(ReadList reads, const Key& place, MotionSink& sink);
  bool reaches(std::uint32_t word, const Key& place);
  std::span<const std::uint32_t> elements(const ReadList& reads) const;
  const Key& keyOf(std::uint32_t word) const { return keys_.at(sources_[word - 1]); }

  InternTable<Key> keys_;                  ///< as asked for
  std::vector<std::uint32_t> numbers_;     ///< of the words, by key
  std::vector<std::uint32_t> sources_;     ///< by word: index of the key that it was made of
  std::vector<std::uint8_t> generations_;  ///< by word
  InternTable<std::vector<std::uint32_t>> lists_;
  InternTable<Key> places_;            ///< of computed words, nothing but the place
  std::vector<std::uint32_t> values_;  ///< by place: how many values it took
  std::vector<std::uint32_t> cuts_;    ///< by place: words that lost some of what they read
  std::uint32_t steps_ = 0;            ///< words looked at for the new word in hand
  struct Capped {
    Key key{};
    std::uint32_t number = 0;
  };
  std::array<Capped, 64> capped_;  ///< the last computed words without values: loops ask for the same again
};

}  // namespace proveout::nc
