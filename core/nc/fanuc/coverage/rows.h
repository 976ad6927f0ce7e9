// The rows that Fanuc-like controls serve, each with what is done and what proves it.
#pragma once

#include <array>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/nc/control/control_info.h"

namespace proveout::nc {

std::span<const CoverageIdRow> fanucTextRows();
std::span<const CoverageIdRow> fanucCycleRows();
std::span<const CoverageIdRow> fanucMacroRows();
std::span<const CoverageIdRow> fanucLatheRows();
std::span<const CoverageIdRow> haasRows();

/// All of them.
std::vector<CoverageIdRow> fanucRows();
/// Why rows that are not done are open, by id.
std::map<std::string, std::string_view> fanucOpenReasons();

}  // namespace proveout::nc
