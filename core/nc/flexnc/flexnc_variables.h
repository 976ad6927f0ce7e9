// Variables P of the FlexNC control (digest flexnc, 2.2).
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/nc/origins/intern_table.h"

namespace proveout::nc {

/// P0 to P8191, all 0 at the start, one set for the whole run.
class FlexVariables {
 public:
  static constexpr int kLast = 8191;
  /// What the manual gives to programs.
  static constexpr int kFirstOfPrograms = 1100, kLastOfPrograms = 8100;

  static bool exists(int number) { return number >= 0 && number <= kLast; }
  static bool ofPrograms(int number) { return number >= kFirstOfPrograms && number <= kLastOfPrograms; }

  double value(int number) const { return places_[static_cast<std::size_t>(number)].value; }
  /// Number of the assignment that gave the value; 0: none.
  std::uint32_t originOf(int number) const { return places_[static_cast<std::size_t>(number)].origin; }
  void assign(int number, double value, std::uint32_t origin) {
    undo_.push_back({number, places_[static_cast<std::size_t>(number)]});
    put(number, {value, origin});
  }

  /// From here on takeBack() restores.
  void mark() { undo_.clear(); }
  void takeBack() {
    for (; !undo_.empty(); undo_.pop_back()) put(undo_.back().number, undo_.back().held);
  }
  /// The same while all variables have the same values.
  std::uint64_t fingerprint() const { return sum_; }

 private:
  struct Held {
    double value = 0.0;
    std::uint32_t origin = 0;
  };
  struct Undo {
    int number;
    Held held;
  };
  void put(int number, const Held& held) {
    Held& place = places_[static_cast<std::size_t>(number)];
    const auto hash = [&](double value) {
      return mixBits(static_cast<std::uint64_t>(number) ^ mixBits(std::bit_cast<std::uint64_t>(value)));
    };
    sum_ += hash(held.value) - hash(place.value);
    place = held;
  }

  std::vector<Held> places_ = std::vector<Held>(kLast + 1);
  std::vector<Undo> undo_;
  std::uint64_t sum_ = 0;
};

}  // namespace proveout::nc
