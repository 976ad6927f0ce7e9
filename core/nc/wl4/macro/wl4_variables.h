// Variables of the WL4 control (digest wl4, 3.1 and 3.2).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace proveout::nc {

/// Answers reads of #100 and up.
class Wl4System {
 public:
  virtual ~Wl4System() = default;
  /// Nothing: there is no such variable.
  virtual std::optional<double> systemVariable(int number) const = 0;
  /// Number of the word that such a variable tells of (see ValueOrigins); 0: none.
  virtual std::uint32_t systemOrigin(int number) const = 0;
};

/// #1-#29 are local: a call gets a copy of the caller's. #30-#99 are global. All are 0 at the start. #100 and
/// up are read only.
class Wl4Variables {
 public:
  static constexpr int kLocals = 29, kGlobals = 99;

  explicit Wl4Variables(const Wl4System& system) : system_(system), levels_(1) {}

  void open() {
    levels_.push_back(levels_.back());
    levels_values_.push_back(levels_values_.back());
  }
  void close() {
    levels_.pop_back();
    levels_values_.pop_back();
  }

  std::optional<double> read(int number) const;
  /// Number of the word that a variable was assigned by, or that a system variable tells of; 0: none.
  std::uint32_t originOf(int number) const;
  /// False: the variable cannot be written. `origin`: number of the assignment.
  bool write(int number, double value, std::uint32_t origin = 0);

  /// The same while all variables have the same values and no system variable is read.
  std::uint64_t fingerprint() const {
    return globals_values_ + levels_values_.back() + system_reads_ * 0x9E3779B97F4A7C15u;
  }

  /// Writes since the last mark can be taken back.
  void mark() { undo_.clear(); }
  void takeBack();

 private:
  struct Held {
    double value = 0.0;
    std::uint32_t origin = 0;
  };
  Held& at(int number) {
    const auto n = static_cast<std::size_t>(number);
    return number <= kLocals ? levels_.back()[n] : globals_[n];
  }

  void put(int number, const Held& held);

  struct Undo {
    int number;
    Held held;
  };
  const Wl4System& system_;
  std::vector<std::array<Held, kLocals + 1>> levels_;
  std::array<Held, kGlobals + 1> globals_{};
  std::vector<Undo> undo_;
  /// Sums over the values in all places.
  std::vector<std::uint64_t> levels_values_{0};
  std::uint64_t globals_values_ = 0;
  mutable std::uint64_t system_reads_ = 0;
};

}  // namespace proveout::nc
