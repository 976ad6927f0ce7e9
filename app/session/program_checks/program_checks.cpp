#include "app/session/program_checks/program_checks.h"

#include "app/session/findings/blame.h"
#include "app/session/program_checks/limits.h"
#include "app/session/program_checks/program_unit.h"
#include "app/session/program_checks/retracts.h"
#include "app/session/program_checks/times.h"

namespace proveout {

void addProgramFindings(const CheckedProgram& program, std::vector<Finding>& findings) {
  addOverLimits(program, findings);
  addLongMotions(program, findings);
  addLongDwells(program, findings);
  addLowToolChanges(program, findings);
  addProgramUnit(program, findings);
}

Finding findingAt(FindingKind kind, MotionId motion, const CheckedProgram& program) {
  Finding finding(kind);
  finding.where = program.path.motions[motion].to;
  blame(finding, motion, program.path, program.texts);
  return finding;
}

}  // namespace proveout
