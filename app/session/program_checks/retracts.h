// Tool changes before which the tool was not taken out of the workpiece.
#pragma once

#include "app/session/program_checks/program_checks.h"

namespace proveout {

/// `tool_change`: one warning for each change called while the tip is below the top of the blank or of a
/// fixture and the tool less than 5 mm beside it or in it. While the part turns: while the tip is inside what
/// the blank sweeps. What counts is where the program has left the tool: not the way that the machine makes
/// to the place of its tool change. Where the job says how high that is, the machine retracts by itself and
/// nothing is told.
void addLowToolChanges(const CheckedProgram& program, std::vector<Finding>& findings);

}  // namespace proveout
