// Which control of those that read LinuxCNC's language it is.
#pragma once

#include <cstdint>

namespace proveout::nc {

enum class LinuxCncFlavour : std::uint8_t { kLinuxCnc, kGrbl, kMach3, kPathPilot, kSmoothie, kGrblHal };

}  // namespace proveout::nc
