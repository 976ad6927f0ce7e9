// Expressions of LinuxCNC, in the text of a line without blanks and comments.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/nc/linuxcnc/text/lcn_line.h"
#include "core/nc/macro/value.h"

namespace proveout::nc {

/// What expressions ask of the control.
class LcnNames {
 public:
  virtual ~LcnNames() = default;
  /// Is there such a parameter?
  virtual bool hasParameter(int number) const = 0;
  virtual Value parameter(int number) = 0;
  /// A parameter by its name in small letters. False: it is not defined.
  virtual bool named(std::string_view name, Value& out) = 0;
};

/// A parameter as the program names it.
struct LcnParameter {
  int number = -1;        ///< below 0: it has a name
  std::string_view name;  ///< points into the text
};

/// Reads expressions of one line. Errors have the interpreter's words; places are those of the text.
class LcnEvaluator {
 public:
  LcnEvaluator(std::string_view text, LcnNames& names) : text_(text), names_(names) {}

  /// The value of a word from `pos` on: signs, and a number, parameter, bracket or function; `pos` goes
  /// behind it. False: fault() says why; so below.
  bool value(std::size_t& pos, Value& out);
  /// `[expression]` from `pos` on.
  bool bracket(std::size_t& pos, Value& out);
  /// `#n`, `#<name>`, `##n`, `#[expression]` from `pos` on, which is not read.
  bool parameter(std::size_t& pos, LcnParameter& out);

  const LcnFault& fault() const { return fault_; }
  /// How far apart the sides of the last comparison stood; NaN: there was none since forget().
  double distance() const { return distance_; }
  void forget();
  /// Origins of the parameters that were read since forget().
  const std::vector<std::uint32_t>& reads() const { return reads_; }

 private:
  std::string_view text_;
  LcnNames& names_;
  LcnFault fault_;
  double distance_ = 0.0;
  std::vector<std::uint32_t> reads_;
};

/// The integer that the interpreter takes a value for: within 0.0001 of one. False: it is none.
bool lcnInteger(double value, std::int64_t& out);

}  // namespace proveout::nc
