// How fast the machine is on which the program runs.
#pragma once

namespace proveout {

/// Wall time of a small piece of milling here and now, over what it took where the coefficients of the
/// prediction were measured: 1 there, 2 where everything takes twice as long. Takes some milliseconds, and
/// not much more than a hundredth of the time that the run is expected to take there.
double machineSlowness(double expected_s);

}  // namespace proveout
