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

  void open() { levels_.push_back(levels_.back()); }
  void close() { levels_.pop_back(); }

  std::optional<double> read(int number) const;
  /// Number of the word that a variable was assigned by, or that a system variable tells of; 0: none.
  std::uint32_t originOf(int number) const;
  /// False: the variable cannot be written. `origin`: number of the assignment.
  bool write(int number, double value, std::uint32_t origin = 0);

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

  struct Undo {
    int number;
    Held held;
  };
  const Wl4System& system_;
  std::vector<std::array<Held, kLocals + 1>> levels_;
  std::array<Held, kGlobals + 1> globals_{};
  std::vector<Undo> undo_;
};

}  // namespace proveout::nc
