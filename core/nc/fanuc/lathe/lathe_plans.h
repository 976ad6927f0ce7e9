// Plan functions of the codes of lathes (sections 15 and 16). False: an error was reported.
#pragma once

#include "core/nc/iso/model/plan.h"

namespace proveout::nc {

/// G01, with chamfers and corners by I, K, C, R. Alarms 053, 054.
bool planLatheLine(IsoContext& c, BlockPlan& plan);
/// G90, G94 of system A.
bool planSingleCycle(IsoContext& c, BlockPlan& plan);
/// G92 of system A.
bool planThreadingCycle(IsoContext& c, BlockPlan& plan);
/// G32, G34.
bool planLatheThread(IsoContext& c, BlockPlan& plan);
/// G71, G72.
bool planRoughing(IsoContext& c, BlockPlan& plan);
/// G73.
bool planPattern(IsoContext& c, BlockPlan& plan);
/// G70.
bool planFinishing(IsoContext& c, BlockPlan& plan);
/// G74, G75.
bool planPecking(IsoContext& c, BlockPlan& plan);
/// G76.
bool planThreadCycle(IsoContext& c, BlockPlan& plan);
/// G83 to G85 along Z, G87 to G89 along X.
bool planLatheDrilling(IsoContext& c, BlockPlan& plan);
/// G10: offsets of tools and the work shift without L; with L as on mills.
bool planLatheData(IsoContext& c, BlockPlan& plan);
/// G50.3 (A), G92.1: the shifts of the named axes go.
bool planLathePreset(IsoContext& c, BlockPlan& plan);

}  // namespace proveout::nc
