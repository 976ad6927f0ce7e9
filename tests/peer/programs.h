// Random programs of the common language of LinuxCNC.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace proveout::peer {

/// The lines of a program: motions and arcs, frames and offsets, cycles, compensation or threads, by the
/// seed.
std::vector<std::string> randomProgram(std::uint64_t seed);

}  // namespace proveout::peer
