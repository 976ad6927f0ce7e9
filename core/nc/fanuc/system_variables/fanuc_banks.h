// The system variables of Fanuc-like controls (section 13 of the rows).
#pragma once

#include <memory>

#include "core/nc/iso/model/dialect.h"

namespace proveout::nc {

/// See IsoDialect::system_variables.
std::unique_ptr<SystemVariables> fanucMillBanks(IsoContext& context);
std::unique_ptr<SystemVariables> fanucLatheBanks(IsoContext& context);

}  // namespace proveout::nc
