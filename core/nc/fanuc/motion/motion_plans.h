// Plan functions of Fanuc-like controls for motion, dwell and reference points (sections 3 to 5).
#pragma once

#include "core/nc/iso/model/plan.h"

namespace proveout::nc {

// dwell.cpp
/// G04 X, U seconds, P milliseconds; alone an exact stop.
bool planFanucDwell(IsoContext& c, BlockPlan& plan);

// arcs.cpp
/// G02, G03 with R or I J K; with Q or L a spiral or cone.
bool planFanucArc(IsoContext& c, BlockPlan& plan);

// thread_blocks.cpp
/// G33 of mills.
bool planFanucThread(IsoContext& c, BlockPlan& plan);
/// Threads have no chamfers and corners. Alarm 050.
bool refuseCorners(IsoContext& c);
/// Q of a thread: a start angle within a turn. Alarm 003.
bool checkStartAngle(IsoContext& c, const BlockPlan& plan);
/// G31, P1 to P4 the input that stops it: the path is the same.
bool planFanucSkip(IsoContext& c, BlockPlan& plan);

// curves.cpp
/// G02.2, G03.2: involute of the base circle R about I, J.
bool planInvolute(IsoContext& c, BlockPlan& plan);
/// G02.4, G03.4: an arc in space through the end of one block to the end of the next.
bool planSpaceArc(IsoContext& c, BlockPlan& plan);
/// G06.2.
bool planNurbs(IsoContext& c, BlockPlan& plan);

// reference.cpp
bool planFanucMachineMove(IsoContext& c, BlockPlan& plan);  ///< G53
bool planFanucReference(IsoContext& c, BlockPlan& plan);    ///< G28, G30
bool planFromReference(IsoContext& c, BlockPlan& plan);     ///< G29
bool planReferenceCheck(IsoContext& c, BlockPlan& plan);    ///< G27
bool planOneDirection(IsoContext& c, BlockPlan& plan);      ///< G60

// virtual_planes.cpp
bool planFanucPolarOn(IsoContext& c, BlockPlan& plan);   ///< G12.1
bool planFanucPolarOff(IsoContext& c, BlockPlan& plan);  ///< G13.1
bool planFanucCylinder(IsoContext& c, BlockPlan& plan);  ///< G07.1

// accepted.cpp
/// Codes of look-ahead, G05, G05.1, G08: the path stays what it is.
bool planLookAhead(IsoContext& c, BlockPlan& plan);
/// A code that only the machine has an effect of; noted once.
bool planNoted(IsoContext& c, BlockPlan& plan);

}  // namespace proveout::nc
