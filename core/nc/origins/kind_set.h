// Sets of kinds of words.
#pragma once

#include <bit>
#include <cstdint>

#include "core/path/word_origin.h"

namespace proveout::nc {

/// A set of kinds of words.
class KindSet {
 public:
  constexpr KindSet() = default;
  constexpr KindSet(OriginKind kind) : bits_(std::uint64_t{1} << static_cast<unsigned>(kind)) {}  // NOLINT
  template <class... Kinds>
  static constexpr KindSet of(Kinds... kinds) {
    return (KindSet() | ... | KindSet(kinds));
  }
  constexpr KindSet operator|(KindSet other) const { return KindSet(bits_ | other.bits_); }
  constexpr KindSet operator&(KindSet other) const { return KindSet(bits_ & other.bits_); }
  constexpr KindSet without(KindSet other) const { return KindSet(bits_ & ~other.bits_); }
  constexpr void add(KindSet other) { bits_ |= other.bits_; }
  constexpr void remove(KindSet other) { bits_ &= ~other.bits_; }
  constexpr bool has(OriginKind kind) const { return (bits_ >> static_cast<unsigned>(kind) & 1u) != 0; }
  constexpr bool empty() const { return bits_ == 0; }
  constexpr std::uint64_t bits() const { return bits_; }
  constexpr bool operator==(const KindSet&) const = default;
  /// Calls `visit` with each kind.
  template <class Visit>
  void each(Visit visit) const {
    for (std::uint64_t left = bits_; left != 0; left &= left - 1)
      visit(static_cast<OriginKind>(std::countr_zero(left)));
  }

 private:
  constexpr explicit KindSet(std::uint64_t bits) : bits_(bits) {}
  std::uint64_t bits_ = 0;
};
static_assert(kOriginKinds <= 64);

}  // namespace proveout::nc
