// The control of a job that leaves it to the program.
#pragma once

#include <optional>
#include <vector>

#include "core/nc/control/program_source.h"
#include "io/job/job.h"

namespace proveout {

/// Whether a clamping of the job has kAutoControl.
bool leavesControl(const Job& job);

/// Puts the control that its program looks like in the place of every kAutoControl, with the settings that
/// the job has for it, and the flavour where the job names none; control_note says why. `programs`: one a
/// clamping. Errors: a program that cannot be read, or that does not tell (with the two best guesses).
Status chooseControls(Job& job, const std::vector<const ProgramSource*>& programs);

/// Where a program that went wrong looks like one for another control or flavour than `job` names: a note
/// that says so. Nothing where the program itself has told the control.
std::optional<Diagnostic> otherControlNote(const Job& job, const ProgramText& program);

/// The note of a control that the program has told; nothing: the job named it.
std::optional<Diagnostic> choiceNote(const Job& job);

}  // namespace proveout
