// Expressions of the FlexNC control: + - * / in their usual order, parentheses, P variables, SIN, COS and TAN
// of degrees (digest flexnc, 2.2).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/nc/flexnc/flexnc_variables.h"
#include "core/nc/origins/value_origins.h"
#include "core/nc/text/block.h"

namespace proveout::nc {

/// Why a text cannot be read.
struct FlexSyntaxError {
  std::string code;  ///< of the diagnostic
  std::string message;
  Columns columns;
};

class FlexEvaluator {
 public:
  /// Both must outlive the evaluator.
  FlexEvaluator(const FlexVariables& variables, ValueOrigins& origins)
      : variables_(variables), origins_(origins) {}

  /// The expression at `pos`, which goes behind it. The value is finite. False: see error(); so below.
  bool expression(std::string_view text, std::size_t& pos, double& out);
  /// A number without a sign, or an expression in parentheses, as it stands behind an address.
  bool plainValue(std::string_view text, std::size_t& pos, double& out);
  /// Digits of a whole number up to `most`.
  bool whole(std::string_view text, std::size_t& pos, int most, int& out);

  /// What the last expression read.
  ReadList reads() const { return reads_.empty() ? 0 : origins_.listOf(reads_); }
  /// A variable that the last expression read and that is not one of the programs', or -1.
  int oddVariable() const { return odd_; }
  const FlexSyntaxError& error() const { return error_; }

 private:
  class Formula;

  bool read(std::string_view text, std::size_t& pos, double& out, bool plain);
  bool finite(double value, std::size_t from, std::size_t to);
  bool fail(const char* code, std::string message, std::size_t from, std::size_t to);

  const FlexVariables& variables_;
  ValueOrigins& origins_;
  std::vector<std::uint32_t> reads_;
  int odd_ = -1;
  FlexSyntaxError error_;
};

/// Columns of text[from, to), one character at least.
Columns flexColumns(std::size_t from, std::size_t to);

}  // namespace proveout::nc
