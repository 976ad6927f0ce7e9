// Spindles and tool change.
#pragma once

#include "core/nc/iso/parameters/parameter_types.h"

namespace proveout::nc {

enum class MachineParam : std::uint16_t { kSpindleOrients, kSpindleIndexes, kToolChangeOnM6, kCount };
constexpr ParamId paramId(MachineParam p) { return {ParamChapter::kMachine, static_cast<std::uint16_t>(p)}; }

}  // namespace proveout::nc
