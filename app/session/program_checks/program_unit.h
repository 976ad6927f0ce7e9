// A program written in inches and read in millimetres, or the other way round.
#pragma once

#include "app/session/program_checks/program_checks.h"

namespace proveout {

/// `program_unit`: one warning where the feeds reach over less than a twentieth of the blank, or ten times as
/// far as it does, and would fit it in the other unit.
void addProgramUnit(const CheckedProgram& program, std::vector<Finding>& findings);

}  // namespace proveout
