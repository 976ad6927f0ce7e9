// Names of axes and spindles that a lexer knows besides the letters.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/nc/text/block.h"

namespace proveout::nc {

/// The configured names. A longer name wins over a shorter one and over a letter (manual 2.2).
class LexNames {
 public:
  LexNames() { letters_.fill(-1); }

  /// `name` is upper case, 1 to 3 characters, the first a letter; `number` is the axis number of AX[n].
  void addAxis(std::string_view name, int index, int number);
  /// `name` is upper case, at least two characters.
  void addSpindle(std::string_view name, int index);

  struct Name {
    std::string text;
    std::int8_t axis = -1, spindle = -1;
    bool endsInDigit() const { return text.back() >= '0' && text.back() <= '9'; }
  };
  /// The longest name of two characters or more that stands at text[pos], letters of either case; or null.
  const Name* match(std::string_view text, std::size_t pos) const;
  /// Axis of a single letter, or -1.
  int axisOfLetter(char upper) const { return letters_[static_cast<std::size_t>(upper - 'A')]; }
  /// Index of axis number `number`, or -1.
  int axisByNumber(int number) const;
  /// The word address under which the axis' words are found: its letter, or kNamedWord.
  Address addressOf(int axis) const;

 private:
  struct Axis {
    std::int8_t index;
    int number;
    Address address;
  };
  std::array<std::int8_t, 26> letters_;
  std::uint32_t starts_ = 0;  ///< letters that a longer name starts with
  std::vector<Name> longer_;  ///< longest first
  std::vector<Axis> axes_;
};

}  // namespace proveout::nc
