// Values that are kept once each and known by their index.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/assert.h"

namespace proveout::nc {

/// Spreads the bits of `value` (the finaliser of splitmix64).
constexpr std::uint64_t mixBits(std::uint64_t value) {
  value += 0x9E3779B97F4A7C15u;
  value = (value ^ value >> 30) * 0xBF58476D1CE4E5B9u;
  value = (value ^ value >> 27) * 0x94D049BB133111EBu;
  return value ^ value >> 31;
}

/// T has ==. Hashes are the caller's: equal values have equal ones.
template <class T>
class InternTable {
 public:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

  /// Index of the value, counted from 0; kNone where it is not there.
  std::uint32_t find(const T& value, std::uint64_t hash) const {
    if (slots_.empty()) return kNone;
    for (std::size_t at = hash & mask();; at = (at + 1) & mask()) {
      if (slots_[at] == kNone) return kNone;
      if (hashes_[slots_[at]] == low(hash) && values_[slots_[at]] == value) return slots_[at];
    }
  }
  /// Adds a value that is not there. Returns its index.
  std::uint32_t add(const T& value, std::uint64_t hash) {
    PROVEOUT_ASSERT_DEAR(find(value, hash) == kNone);
    if (2 * (values_.size() + 1) > slots_.size()) grow();
    const auto index = static_cast<std::uint32_t>(values_.size());
    values_.push_back(value);
    hashes_.push_back(low(hash));
    place(index, hash);
    return index;
  }
  const T& at(std::uint32_t index) const { return values_[index]; }
  std::size_t size() const { return values_.size(); }

 private:
  // The low half of a hash finds the slot and the kept half is the same one, so that slots can be filled
  // anew.
  static std::uint32_t low(std::uint64_t hash) { return static_cast<std::uint32_t>(hash); }
  std::size_t mask() const { return slots_.size() - 1; }
  void place(std::uint32_t index, std::uint64_t hash) {
    std::size_t at = hash & mask();
    while (slots_[at] != kNone) at = (at + 1) & mask();
    slots_[at] = index;
  }
  void grow() {
    constexpr std::size_t kFirst = 64;
    slots_.assign(slots_.empty() ? kFirst : 2 * slots_.size(), kNone);
    for (std::uint32_t index = 0; index < values_.size(); ++index) place(index, hashes_[index]);
  }

  std::vector<T> values_;
  std::vector<std::uint32_t> hashes_;
  std::vector<std::uint32_t> slots_;  ///< a power of two of them, half of them free at least
};

}  // namespace proveout::nc
