// Functions and bit operations of the macro language.
#pragma once

#include <optional>
#include <string_view>

#include "core/nc/text/alarms.h"

namespace proveout::nc {

/// Why an argument is refused; nothing: it is not.
using Refusal = std::optional<SharedAlarm>;

// Functions of one argument; angles in degrees, arguments and results. Sines of multiples of 30 degrees and
// tangents of multiples of 45 that are rational come out exact (nct manual 23.2.4). What overflows is
// infinite.
Refusal squareRoot(double x, double& out);
Refusal sine(double x, double& out);
Refusal cosine(double x, double& out);
Refusal tangent(double x, double& out);
Refusal arcSine(double x, double& out);
Refusal arcCosine(double x, double& out);
Refusal arcTangent(double x, double& out);
Refusal exponential(double x, double& out);
Refusal naturalLogarithm(double x, double& out);
Refusal absoluteValue(double x, double& out);
Refusal towardsZero(double x, double& out);  ///< whole numbers; so below
Refusal fromZero(double x, double& out);
Refusal downwards(double x, double& out);
Refusal upwards(double x, double& out);
Refusal nearest(double x, double& out);  ///< halves go from zero
Refusal bitComplement(double x, double& out);
/// In the quadrant of the point (y, x), -180 to 180.
Refusal arcTangentOf(double x, double y, double& out);

enum class LogicOperator { kOr, kXor, kAnd };

/// Bits of 32-bit signed integers (manual 23.2.3): operands are rounded to the nearest integer. kBits
/// where an operand lies beyond +-(2^32 - 1).
Refusal applyLogic(LogicOperator op, double a, double b, double& out);

}  // namespace proveout::nc
