// What a lathe makes of the job's settings: numbers of axes, and live tools and the C axis by
// `[control.fanuc.live]` (section 15).
#pragma once

#include "core/nc/control/control_settings.h"
#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// The settings with the axis numbers of lathes where the job gives X, Y, Z none: X 1, Z 2, Y 3. Haas counts
/// X 1, Y 2, Z 3 on lathes too.
ControlSettings withLatheAxes(const ControlSettings& settings);
/// The settings with the spindle of live tools, and the main spindle as an axis, where the job or the flavour
/// names their M codes: a spindle of the job other than the first, or spindle 2.
ControlSettings withLiveTools(const ControlSettings& settings);
/// Codes of the settings that mean something to the control already: errors. IsoDialect::begin of lathes.
void checkLiveCodes(IsoContext& c);
/// The block turns a live tool: told once what the simulation makes of it.
void tellLiveTool(IsoContext& c, const BlockPlan& plan);

}  // namespace proveout::nc
