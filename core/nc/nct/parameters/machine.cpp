#include "core/nc/iso/parameters/machine.h"

#include "core/nc/nct/parameters/rows.h"

namespace proveout::nc {
namespace {

using namespace param_rows;

constexpr std::array<ParamInfo, static_cast<std::size_t>(MachineParam::kCount)> kMachineRows{{
    bit("N0607.ORI", 607, 1, kSpindle, 1, "the spindle can be oriented (G76, G87 back boring)"),
    bit("N0607.INX", 607, 2, kSpindle, 1, "the spindle can be indexed (G84.2, G84.3)"),
    bit("N1338.M06", 1338, 0, kChannel, 1, "1: M6 changes the tool, T selects it; 0: T changes it"),
}};

}  // namespace

std::span<const ParamInfo> machineParams() { return kMachineRows; }

}  // namespace proveout::nc
