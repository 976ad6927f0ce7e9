// Expressions of the WL4 control (digest wl4, 3.3).
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/nc/limits/loop_budget.h"
#include "core/nc/macro/formula_text.h"
#include "core/nc/origins/value_origins.h"
#include "core/nc/text/block.h"
#include "core/nc/wl4/macro/wl4_variables.h"

namespace proveout::nc {

/// Angles are in degrees. Operators, all from left to right: ** * / MOD before + - before comparisons before
/// AND OR XOR. `#n=` inside an expression takes one operand and yields it. Division by zero gives an infinite
/// value: whoever uses the value refuses it.
class Wl4Evaluator {
 public:
  struct Error {
    std::string message;
    Columns columns;
  };

  explicit Wl4Evaluator(Wl4Variables& variables) : variables_(variables) {}

  /// The expression at `pos`, which goes behind it. False: see error().
  bool evaluate(std::string_view text, std::size_t& pos, double& out);
  /// The number of a variable behind its '#', at `pos`.
  bool reference(std::string_view text, std::size_t& pos, int& number);
  /// Of what the last expression gave.
  bool assign(int number, double value, std::size_t from, std::size_t to) {
    return assignBehind(0, number, value, from, to);
  }
  /// `origins` must outlive the evaluator. Without, values have no origins.
  void setOrigins(ValueOrigins& origins) { origins_ = &origins; }
  /// What is compared is told to `loops`, which must outlive the evaluator.
  void setLoops(LoopBudget& loops) { loops_ = &loops; }
  /// That a condition at `text` has this value.
  void tellLoops(const char* text, double value, bool holds) {
    if (loops_ != nullptr) loops_->asked(conditionAt(text), std::abs(value), holds);
  }
  /// Where the last number of the last expression stands.
  struct Stretch {
    std::size_t begin = 0, end = 0;
  };
  const Stretch& lastNumber() const { return last_number_; }
  /// What the last expression read.
  ReadList reads() const { return reads_.empty() ? 0 : origins_->listOf(reads_); }

  /// Values that differ by less than half a unit of this decimal are equal; without, by less than 1e-9.
  void setDecimals(int decimals);
  void setFullPrecision() { tolerance_ = kFullPrecision; }
  bool isTrue(double value) const { return value >= tolerance_ || value <= -tolerance_; }

  /// A power stood beside another operator of its class without parentheses.
  bool mixedPower() const { return mixed_power_; }
  /// Behind a comparison, AND, OR or XOR an operator that binds closer stood without parentheses: from left
  /// to right, as two classes of operators have it, the value would be another one.
  bool mixedClasses() const { return mixed_classes_; }
  const Error& error() const { return error_; }

 private:
  static constexpr double kFullPrecision = 1e-9;
  class Formula;

  /// Assigns what was read from `reads_[first]` on.
  bool assignBehind(std::size_t first, int number, double value, std::size_t from, std::size_t to);
  bool fail(std::string message, std::size_t from, std::size_t to);

  Wl4Variables& variables_;
  ValueOrigins* origins_ = nullptr;
  LoopBudget* loops_ = nullptr;
  std::vector<std::uint32_t> reads_;  ///< origins of the variables of the expression in hand
  double tolerance_ = kFullPrecision;
  Stretch last_number_;
  bool mixed_power_ = false;
  bool mixed_classes_ = false;
  Error error_;
};

}  // namespace proveout::nc
