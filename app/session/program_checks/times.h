// Times that can hardly be meant.
#pragma once

#include "app/session/program_checks/program_checks.h"

namespace proveout {

/// `cycle_time`: one warning where a motion takes more than half an hour, or the motions together more than a
/// day.
void addLongMotions(const CheckedProgram& program, std::vector<Finding>& findings);

/// `dwell`: one warning, at the longest, where a dwell takes more than a minute, or all of them take more
/// than half a minute and more than the motions. It says in which unit the control reads the number.
void addLongDwells(const CheckedProgram& program, std::vector<Finding>& findings);

}  // namespace proveout
