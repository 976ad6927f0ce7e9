// The system variables that the controls of the ISO family have, all of them.
#pragma once

#include <memory>

#include "core/nc/iso/model/dialect.h"

namespace proveout::nc {

/// All banks, known to the variables of the context by number and by name. The context must outlive them.
std::unique_ptr<SystemVariables> allBanks(IsoContext& context);

}  // namespace proveout::nc
