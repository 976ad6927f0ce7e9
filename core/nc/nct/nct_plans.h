// Plan functions that the code tables name. A chapter with codes of its own has a header of its own.
#pragma once

#include "core/nc/nct/nct_plan.h"

namespace proveout::nc {

// nct_motion.cpp
bool planRapid(NctContext& c, BlockPlan& plan);
bool planLine(NctContext& c, BlockPlan& plan);
bool planArc(NctContext& c, BlockPlan& plan);
bool planDwell(NctContext& c, BlockPlan& plan);
bool planMachineMove(NctContext& c, BlockPlan& plan);
bool planReference(NctContext& c, BlockPlan& plan);

// nct_frames.cpp
bool planLocalShift(NctContext& c, BlockPlan& plan);
bool planSetPosition(NctContext& c, BlockPlan& plan);
bool planOffsets(NctContext& c, BlockPlan& plan);

// nct_cycles.cpp
bool planCycle(NctContext& c, BlockPlan& plan);

}  // namespace proveout::nc
