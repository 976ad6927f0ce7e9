// Cycles of the FlexNC control that are no templates (digest flexnc, 10): what the rows of cycles.cpp name.
// Letters are there, and none besides those that the row lists; numbers are finite.
#pragma once

#include "core/nc/flexnc/cycles/cycle_call.h"

namespace proveout::nc {

/// G79: passes along X, from the allowance Z down to the face.
void faceEnd(const CycleCall& call, CycleAnswer& answer);
/// G5: on the axis, out of the hole behind each depth P.
void drillDeep(const CycleCall& call, CycleAnswer& answer);
/// G79.1: into a shaft; the working point is the left edge.
void cutRadialGroove(const CycleCall& call, CycleAnswer& answer);
/// G79.2: into a face; the working point is the edge nearer to the axis.
void cutFaceGroove(const CycleCall& call, CycleAnswer& answer);
/// G76: keeps what the cut block needs, or cuts.
void cutThread(const CycleCall& call, CycleAnswer& answer);
/// G30: a groove of round section on K helices. The working point is the lowest one of a round tool along X,
/// its middle along Z.
void cutWorm(const CycleCall& call, CycleAnswer& answer);

}  // namespace proveout::nc
