// Functions of custom macro B that other controls do not have (section 12 of the rows).
#pragma once

#include "core/nc/macro/functions.h"

namespace proveout::nc {

/// Decimal digits of four bits each to a number, 16#25 to 25; kBits where a digit is above 9 or the value is
/// none of 0 to 16#99999999.
Refusal fromBcd(double x, double& out);
/// The other way; kBits beyond 0 to 99999999.
Refusal toBcd(double x, double& out);
/// x to the power y; kRoot where there is none.
Refusal powerOf(double x, double y, double& out);
/// The value itself: values of arguments count in units already.
Refusal withPoint(double x, double& out);
/// Arc sine of 270 to 360 and 0 to 90 degrees, arc tangent of 0 to 360 (6004#0 NAT 0).
Refusal arcSineOfTurn(double x, double& out);
Refusal arcTangentOfTurn(double y, double x, double& out);

}  // namespace proveout::nc
