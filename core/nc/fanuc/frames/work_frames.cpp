// G54 to G59 and G54.1 (iso-fanuc, section 6).
#include "core/nc/fanuc/frames/frames.h"
#include "core/nc/iso/context/plans.h"

namespace proveout::nc {
namespace {

/// Whether a P beside G54 to G59 belongs to another code of the block.
bool takenElsewhere(const BlockPlan& plan) {
  if (plan.flow != nullptr || plan.claimed.has('P')) return true;
  for (const GCode* code : plan.by_group) {
    if (code != nullptr && code->group != kGroupWorkSystem && code->words.has('P')) return true;
  }
  const int macro = plan.next.active[kGroupMacro];
  return plan.by_group[kGroupMacro] != nullptr && macro != gcode::kMacroCancel;
}

}  // namespace

bool fanucWorkSystem(IsoContext& c, BlockPlan& plan) {
  const int code10 = plan.by_group[kGroupWorkSystem]->code10;
  const bool extended = code10 == gcode::kExtendedWorkSystem;
  const bool beside = code10 == gcode::kWorkSystem1 && c.block.present.has('P') && !takenElsewhere(plan);
  if (plan.next.transforms.rotates) {
    c.warnOnce("frame in rotation", "frame-in-rotation",
               "a work frame is chosen while the rotation (G68) is on: some controls refuse it (049); here "
               "the rotation goes on in the new frame",
               {}, Severity::kNote);
  }
  if (!extended && !beside) {
    plan.next.work_system = (code10 - gcode::kWorkSystem1) / 10 + 1;
    return true;
  }
  plan.claimed.add('P');
  std::int64_t number = 1;
  const Word* p = c.word('P');
  if (p != nullptr && !integerWord(c, *p, 1, c.dialect.rules.extended_systems, number)) return false;
  plan.next.work_system = kFirstExtended + static_cast<int>(number) - 1;
  plan.next.last.extended_system = static_cast<int>(number);
  return true;
}

}  // namespace proveout::nc
