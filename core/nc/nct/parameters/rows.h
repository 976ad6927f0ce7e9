// The chapters of the parameter table.
#pragma once

#include <array>
#include <span>

#include "core/nc/iso/parameters/parameter_rows.h"

namespace proveout::nc {

std::span<const ParamInfo> motionParams();
std::span<const ParamInfo> machineParams();
std::span<const ParamInfo> compParams();
std::span<const ParamInfo> cyclesParams();
std::span<const ParamInfo> macroParams();
std::span<const ParamInfo> feedParams();
std::span<const ParamInfo> dataParams();
std::span<const ParamInfo> axisParams();
std::span<const ParamInfo> toolParams();
std::span<const ParamInfo> spindleParams();
std::span<const ParamInfo> functionParams();
std::span<const ParamInfo> programParams();
std::span<const ParamInfo> safetyParams();
std::span<const ParamInfo> fiveAxisParams();

}  // namespace proveout::nc
