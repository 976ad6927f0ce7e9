// Functions and bit operations of the macro language.
#pragma once

#include <string_view>

namespace proveout::nc {

enum class MacroFunction { kSqrt, kSin, kCos, kTan, kAsin, kAcos, kAtan, kExp, kLn, kAbs, kFix, kFup, kNot };

/// Angles in degrees, arguments and results. Sines of multiples of 30 degrees and tangents of multiples of 45
/// that are rational come out exact. 0, or the number of the alarm that refuses the argument (manual 23.2.4).
int applyFunction(MacroFunction function, double x, double& out);

enum class LogicOperator { kOr, kXor, kAnd };

/// Bits of 32-bit signed integers (manual 23.2.3): operands are rounded to the nearest integer. 0, or 2129
/// where an operand lies beyond +-(2^32 - 1).
int applyLogic(LogicOperator op, double a, double b, double& out);

}  // namespace proveout::nc
