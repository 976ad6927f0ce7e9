// LinuxCNC as tables of the ISO family.
#pragma once

#include <map>
#include <string>

#include "core/nc/iso/model/dialect.h"

namespace proveout::nc {

/// Codes; made once.
const CodeIndex& linuxCncCodes();
/// The control as the settings of the job (ControlSettings::parameters) have it at power-on. It lives as long
/// as the process.
const IsoDialect& linuxCncDialect(const std::map<std::string, double>& settings);

}  // namespace proveout::nc
