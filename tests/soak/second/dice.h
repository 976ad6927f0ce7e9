// The random source of the second generator: PCG32 (M. O'Neill, 2014). The first one has a source of its own.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace proveout::soak::second {

class Dice {
 public:
  explicit Dice(std::uint64_t seed, std::uint64_t stream = 0) : step_(2 * stream + 1) {
    roll();
    state_ += seed;
    roll();
  }
  std::uint32_t roll() {
    const std::uint64_t old = state_;
    state_ = old * 6364136223846793005ull + step_;
    const auto word = static_cast<std::uint32_t>((old >> 18 ^ old) >> 27);
    const auto turn = static_cast<std::uint32_t>(old >> 59);
    return word >> turn | word << (32 - turn) % 32;
  }
  /// One of `sides` numbers from 0 on.
  int below(int sides) {
    return static_cast<int>(static_cast<std::uint64_t>(roll()) * static_cast<std::uint64_t>(sides) >> 32);
  }
  bool oneIn(int sides) { return below(sides) == 0; }
  /// A multiple of `step` from `low` up to `high`.
  double multiple(double low, double high, double step) {
    const auto first = static_cast<std::int64_t>(std::ceil(low / step - 1e-9));
    const auto last = static_cast<std::int64_t>(std::floor(high / step + 1e-9));
    const std::int64_t count = last > first ? last - first + 1 : 1;
    const std::uint64_t wide = static_cast<std::uint64_t>(roll()) * static_cast<std::uint64_t>(count) >> 32;
    return static_cast<double>(first + static_cast<std::int64_t>(wide)) * step;
  }
  /// Such a length in whole steps of the programs, mm: twice what they can say, so that halves can be said.
  double mm(double low, double high) { return multiple(low, high, kStep); }
  template <typename T>
  T of(std::initializer_list<T> list) {
    return list.begin()[static_cast<std::size_t>(below(static_cast<int>(list.size())))];
  }

  static constexpr double kStep = 0.002;

 private:
  std::uint64_t state_ = 0, step_;
};

}  // namespace proveout::soak::second
