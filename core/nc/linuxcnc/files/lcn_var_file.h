// The file in which LinuxCNC keeps parameters: a number and its value a line.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace proveout::nc {

/// In the order of the file; values in machine units. Lines that are none are told in `faults`.
std::vector<std::pair<int, double>> readLcnVarFile(std::string_view text, std::vector<std::string>& faults);

}  // namespace proveout::nc
