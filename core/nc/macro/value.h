// A value of the macro language: a number, or vacant.
#pragma once

#include <cstdint>

namespace proveout::nc {

/// What a variable or an expression holds. A vacant value counts as 0 in arithmetic, and a word whose value
/// is vacant is not there at all (manual 23.1.6).
struct Value {
  double number = 0.0;
  bool vacant = false;
  /// Of a variable: number of the word that assigned it; 0: none. Of an expression: what it read. See
  /// ValueOrigins.
  std::uint32_t origin = 0;
  static constexpr Value none() { return {0.0, true}; }
};

/// Local variables #1 to #33.
inline constexpr int kLocalCount = 33;

}  // namespace proveout::nc
