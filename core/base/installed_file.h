// Files that are installed beside the program: modules and helpers, in lib/proveout.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace proveout {

/// Where a file of that name may be, most likely place first: beside the program (../lib/proveout) and where
/// it was installed. Only files that are there.
std::vector<std::string> installedFiles(std::string_view name);

}  // namespace proveout
