// Variables of the WL4 control (digest wl4, 3.1 and 3.2).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace proveout::nc {

/// Answers reads of #100 and up.
class Wl4System {
 public:
  virtual ~Wl4System() = default;
  /// Nothing: there is no such variable.
  virtual std::optional<double> systemVariable(int number) const = 0;
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
  /// False: the variable cannot be written.
  bool write(int number, double value);

  /// Writes since the last mark can be taken back.
  void mark() { undo_.clear(); }
  void takeBack();

 private:
  double& at(int number) {
    const auto n = static_cast<std::size_t>(number);
    return number <= kLocals ? levels_.back()[n] : globals_[n];
  }

  struct Undo {
    int number;
    double value;
  };
  const Wl4System& system_;
  std::vector<std::array<double, kLocals + 1>> levels_;
  std::array<double, kGlobals + 1> globals_{};
  std::vector<Undo> undo_;
};

}  // namespace proveout::nc
