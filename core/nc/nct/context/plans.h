// Plan functions that the code tables name. A chapter with codes of its own has a header of its own.
#pragma once

#include "core/nc/nct/model/plan.h"

namespace proveout::nc {

// motion/motion.cpp
bool planRapid(NctContext& c, BlockPlan& plan);
bool planLine(NctContext& c, BlockPlan& plan);
bool planArc(NctContext& c, BlockPlan& plan);
bool planDwell(NctContext& c, BlockPlan& plan);
bool planMachineMove(NctContext& c, BlockPlan& plan);
bool planReference(NctContext& c, BlockPlan& plan);

// motion/thread.cpp, motion/diameter.cpp, motion/smooth.cpp
bool planThread(NctContext& c, BlockPlan& plan);
bool planDiameter(NctContext& c, BlockPlan& plan);
bool planSmooth(NctContext& c, BlockPlan& plan);

// motion/virtual_plane.cpp
bool planPolarOn(NctContext& c, BlockPlan& plan);
bool planPolarOff(NctContext& c, BlockPlan& plan);
bool planCylinder(NctContext& c, BlockPlan& plan);

// frames/frames.cpp
bool planLocalShift(NctContext& c, BlockPlan& plan);
bool planSetPosition(NctContext& c, BlockPlan& plan);
/// G10 L2, L20.
bool planWorkOffset(NctContext& c, BlockPlan& plan);

// zones/zones.cpp
bool planZoneOn(NctContext& c, BlockPlan& plan);
bool planZoneOff(NctContext& c, BlockPlan& plan);

// motion/measuring.cpp
/// G31, with P98 too.
bool planSkip(NctContext& c, BlockPlan& plan);
/// G37.
bool planToolLength(NctContext& c, BlockPlan& plan);

// program/data_input.cpp
/// G10: hands over to the function of its L.
bool planDataInput(NctContext& c, BlockPlan& plan);
/// G11 where no data input is open.
bool planEndOfData(NctContext& c, BlockPlan& plan);
/// A block between G10 L... and G11.
bool dataBlock(NctContext& c);

// tools/offsets.cpp
/// G10 L10 to L13, L110, L111.
bool planMillingOffset(NctContext& c, BlockPlan& plan);
/// G10 L200 to L203.
bool planTurningOffset(NctContext& c, BlockPlan& plan);
/// G43.7, and H while it is in force: lengths of the row on X, Y and Z.
bool planTurningLength(NctContext& c, BlockPlan& plan);

// frames/transforms.cpp
bool planRotation(NctContext& c, BlockPlan& plan);
bool planScaling(NctContext& c, BlockPlan& plan);
bool planMirror(NctContext& c, BlockPlan& plan);
bool planMirrorOff(NctContext& c, BlockPlan& plan);

// motion/contour.cpp
bool planCornerArc(NctContext& c, BlockPlan& plan);

// cycles/cycles.cpp
bool planCycle(NctContext& c, BlockPlan& plan);

}  // namespace proveout::nc
