// Fanuc-like controls as tables of the ISO family.
#pragma once

#include <map>
#include <string>

#include "core/nc/fanuc/tables/tables.h"
#include "core/nc/iso/model/dialect.h"

namespace proveout::nc {

/// Codes of mills and of lathes; made once.
const CodeIndex& fanucMillCodes();
const CodeIndex& haasMillCodes();
const CodeIndex& fanucLatheCodes(GCodeSystem system = GCodeSystem::kA, bool haas = false);

/// The control as the settings of the job (ControlSettings::parameters) have it at power-on. It lives as long
/// as the process.
const IsoDialect& fanucMillDialect(const std::map<std::string, double>& settings);
const IsoDialect& fanucLatheDialect(const std::map<std::string, double>& settings);

}  // namespace proveout::nc
