// What the control's parameters say of the machine (N3200 to N3224).
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// The control computes with the machine's own data where the job gives no parameter, and else with the
/// parameter. A warning names each that says something else than the machine is, with both values: the
/// machine moves by its chain. False: parameters that can be of no machine; an error was reported.
bool takeMachineData(IsoContext& c);

}  // namespace proveout::nc
