// Feeds and speeds above what machine and tools can take.
#pragma once

#include "app/session/program_checks/program_checks.h"

namespace proveout {

/// `feed_rate` and `spindle_speed`: one warning for each tool and each limit that is passed (the lower one of
/// machine and tool), at the first block that does so, with the worst value and how many motions there are.
/// Feeds are those along the path, speeds those that the control lets the spindle have: under constant
/// surface speed the mean of each motion, within the limit that the program gives.
void addOverLimits(const CheckedProgram& program, std::vector<Finding>& findings);

}  // namespace proveout
