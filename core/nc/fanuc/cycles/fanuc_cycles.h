// Drilling cycles of Fanuc-like mills (section 10 of the rows).
#pragma once

#include "core/nc/iso/cycles/cycle_rules.h"

namespace proveout::nc {

/// What the words of drilling cycles mean: K and L repeat, Q of fine and back boring shifts in the direction
/// of `g76_shift`, P counts milliseconds, rigid tapping by M29 or always. Haas: section 18.
const CycleRules& fanucCycleRulesOf(bool haas);
/// G73 to G89. Alarms 045 (no peck), 200 and 201 (rigid tapping without S or F), `cycle-no-z`.
bool planFanucCycle(IsoContext& c, BlockPlan& plan);
/// M29: the next tapping cycle is rigid. Alarm 200 without S.
bool planRigidTapMode(IsoContext& c, BlockPlan& plan);
/// Rigid tapping begins with the cycle behind M29 and ends with the cycle. Alarm 203: something moves in
/// between; 206: the plane changes.
bool followRigidTap(IsoContext& c, BlockPlan& plan);

/// Does the job choose the flavour of Haas?
bool isHaas(const IsoContext& c);
/// Seconds of a P word: milliseconds, for Haas seconds where it has a decimal point. Alarm 007: a point where
/// none may stand.
bool fanucDwellSeconds(IsoContext& c, const Word& p, double& seconds);

}  // namespace proveout::nc
