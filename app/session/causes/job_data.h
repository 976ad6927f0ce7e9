// Numbers of a job by the keys that messages name them with: "offsets.work.G54.x", "offsets.radius.1",
// "tools.2.diameter", "control.wl4-lathe.RT.3", "setup.bottom.transform.translate.z",
// "setup.bottom.transform.rotate.z" (degrees).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/job/job.h"

namespace proveout {

/// Value of a number as a clamping has it; none: there is no such number.
std::optional<double> jobNumber(const Job& job, std::size_t setup, const std::string& key);
/// Puts it. False: there is no such number, or a tool cannot have it.
bool putJobNumber(Job& job, std::size_t setup, const std::string& key, double value);

/// Keys of the numbers that give a tool its shape, a flat mill's corner radius among them.
std::vector<std::string> toolKeys(const Tool& tool);

}  // namespace proveout
