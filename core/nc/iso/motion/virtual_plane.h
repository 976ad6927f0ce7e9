// Checks of the planes with a virtual axis.
#pragma once

#include <string_view>

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// During G12.1 and G7.1: refuses the codes that they exclude. False: reported.
bool checkVirtual(IsoContext& c, const BlockPlan& plan);

}  // namespace proveout::nc
