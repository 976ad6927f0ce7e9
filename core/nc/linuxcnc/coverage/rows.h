// The rows of LinuxCNC that this control serves, each with what is done and what proves it.
#pragma once

#include <array>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/nc/control/control_info.h"

namespace proveout::nc {

std::span<const CoverageIdRow> linuxCncTextRows();
std::span<const CoverageIdRow> linuxCncMotionRows();

/// All of them.
std::vector<CoverageIdRow> linuxCncRows();
/// Why rows that are not done are open, by id.
std::map<std::string, std::string_view> linuxCncOpenReasons();

}  // namespace proveout::nc
