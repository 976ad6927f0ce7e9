// Functions and bit operations of the macro language.
#pragma once

#include <optional>
#include <string_view>

#include "core/nc/text/alarms.h"

namespace proveout::nc {

/// Why an argument is refused; nothing: it is not.
using Refusal = std::optional<SharedAlarm>;

enum class MacroFunction { kSqrt, kSin, kCos, kTan, kAsin, kAcos, kAtan, kExp, kLn, kAbs, kFix, kFup, kNot };

/// Angles in degrees, arguments and results. Sines of multiples of 30 degrees and tangents of multiples of 45
/// that are rational come out exact (nct manual 23.2.4).
Refusal applyFunction(MacroFunction function, double x, double& out);

enum class LogicOperator { kOr, kXor, kAnd };

/// Bits of 32-bit signed integers (manual 23.2.3): operands are rounded to the nearest integer. kBits
/// where an operand lies beyond +-(2^32 - 1).
Refusal applyLogic(LogicOperator op, double a, double b, double& out);

}  // namespace proveout::nc
