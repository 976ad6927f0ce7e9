// The machine's way to where it changes tools.
#pragma once

#include <vector>

#include "core/machine/axis_point.h"
#include "core/nc/control/control_settings.h"
#include "core/nc/origins/kind_set.h"
#include "core/nc/origins/origin_recorder.h"
#include "core/nc/stages/motion_pipe.h"

namespace proveout::nc {

/// Points that the machine goes to one after the other in rapid, machine coordinates, mm; none where it
/// stands right. `ceiling`: upper end of Z in the control's own areas, infinite without one.
std::vector<AxisPoint> toolChangeWay(const ControlSettings& settings, const AxisPoint& from, double ceiling);

/// The coordinates that no word gives behind such a way: those of the axes that it may move.
KindSet unsaidBehind(const ToolChangePlace& place);

/// What takes part when a control sends the machine there.
struct ToolChangeParts {
  MotionPipe& pipe;
  const PathEmitter& emitter;
  OriginRecorder& recorder;
};
/// Sends the machine to where it changes tools, for controls without areas of their own. `plane` and `source`
/// are those of the block in hand; `machine`, the programmed point, follows. `moves`: it was not there yet.
/// False: a stage reported an error.
bool goToToolChange(const ControlSettings& settings, const ToolChangeParts& parts, const WorkPlane& plane,
                    const SourceRef& source, AxisPoint& machine, bool& moves);

}  // namespace proveout::nc
