// Plan functions that the code tables name. A chapter with codes of its own has a header of its own.
#pragma once

#include "core/nc/iso/model/plan.h"

namespace proveout::nc {

// motion/motion.cpp
bool planRapid(IsoContext& c, BlockPlan& plan);
bool planLine(IsoContext& c, BlockPlan& plan);
bool planArc(IsoContext& c, BlockPlan& plan);
bool planDwell(IsoContext& c, BlockPlan& plan);
bool planMachineMove(IsoContext& c, BlockPlan& plan);
bool planReference(IsoContext& c, BlockPlan& plan);

// motion/thread.cpp, motion/diameter.cpp, motion/smooth.cpp
bool planThread(IsoContext& c, BlockPlan& plan);
bool planDiameter(IsoContext& c, BlockPlan& plan);
bool planSmooth(IsoContext& c, BlockPlan& plan);

// motion/virtual_plane.cpp
bool planPolarOn(IsoContext& c, BlockPlan& plan);
bool planPolarOff(IsoContext& c, BlockPlan& plan);
bool planCylinder(IsoContext& c, BlockPlan& plan);

// frames/frames.cpp
bool planLocalShift(IsoContext& c, BlockPlan& plan);
bool planSetPosition(IsoContext& c, BlockPlan& plan);
/// The shifts of G52 and G92 of the named axes end.
bool planShiftsOff(IsoContext& c, BlockPlan& plan);
/// G10 L2, L20.
bool planWorkOffset(IsoContext& c, BlockPlan& plan);

// five_axis/tilt.cpp
/// G68.1.
bool planSpaceRotation(IsoContext& c, BlockPlan& plan);
/// G68.2.
bool planTiltedPlane(IsoContext& c, BlockPlan& plan);

// motion/tool_direction.cpp
/// G53.1.
bool planToolDirection(IsoContext& c, BlockPlan& plan);
/// G53.6.
bool planToolDirectionAboutTip(IsoContext& c, BlockPlan& plan);

// five_axis/dynamic_zero.cpp
/// G10 L21.
bool planDynamicOffset(IsoContext& c, BlockPlan& plan);

// zones/zones.cpp
bool planZoneOn(IsoContext& c, BlockPlan& plan);
bool planZoneOff(IsoContext& c, BlockPlan& plan);

// motion/measuring.cpp
/// G31, with P98 too.
bool planSkip(IsoContext& c, BlockPlan& plan);
/// G37.
bool planToolLength(IsoContext& c, BlockPlan& plan);

// program/data_input.cpp
/// G10: hands over to the function of its L.
bool planDataInput(IsoContext& c, BlockPlan& plan);
/// G11 where no data input is open.
bool planEndOfData(IsoContext& c, BlockPlan& plan);
/// A block between G10 L... and G11.
bool dataBlock(IsoContext& c);

// tools/offsets.cpp
/// G10 L10 to L13, L110, L111.
bool planMillingOffset(IsoContext& c, BlockPlan& plan);
/// G10 L200 to L203.
bool planTurningOffset(IsoContext& c, BlockPlan& plan);
/// G43.7, and H while it is in force: lengths of the row on X, Y and Z.
bool planTurningLength(IsoContext& c, BlockPlan& plan);

// frames/transforms.cpp
bool planRotation(IsoContext& c, BlockPlan& plan);
bool planScaling(IsoContext& c, BlockPlan& plan);
bool planMirror(IsoContext& c, BlockPlan& plan);
bool planMirrorOff(IsoContext& c, BlockPlan& plan);

// motion/contour.cpp
bool planCornerArc(IsoContext& c, BlockPlan& plan);

// cycles/cycles.cpp
bool planCycle(IsoContext& c, BlockPlan& plan);

}  // namespace proveout::nc
