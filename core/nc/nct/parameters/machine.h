// Spindles and tool change.
#pragma once

#include "core/nc/nct/parameters/parameter_types.h"

namespace proveout::nc {

/// Order of the rows in machine.cpp.
enum class MachineParam : std::uint16_t { kSpindleOrients, kSpindleIndexes, kToolChangeOnM6, kCount };
constexpr ParamId paramId(MachineParam p) { return {ParamChapter::kMachine, static_cast<std::uint16_t>(p)}; }
std::span<const ParamInfo> machineParams();

}  // namespace proveout::nc
