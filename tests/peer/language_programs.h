// Random programs of LinuxCNC's language: formulas, parameters, O-words; what they count becomes motions.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace proveout::peer {

/// The lines of a program that defines subs, counts with numbered and named parameters, branches and loops
/// (at most some hundred rounds by its construction), and goes where its parameters say.
std::vector<std::string> randomLanguageProgram(std::uint64_t seed);

}  // namespace proveout::peer
