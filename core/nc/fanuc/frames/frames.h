// Work frames, data input and transforms of Fanuc-like controls (iso-fanuc, sections 6 and 9).
#pragma once

#include "core/nc/iso/context/context.h"
#include "core/nc/iso/context/words.h"

namespace proveout::nc {

/// G54 to G59, G54.1 P1 to P300 (P1 without P), and `G54 P n`, which is the same. IsoDialect::usual_systems.
bool fanucWorkSystem(IsoContext& c, BlockPlan& plan);

/// G10 by its L: 2 and 20 frames, 1 and 10 to 13 tool offsets, 50 and 52 parameters, 3 tool life, 21
/// fixtures.
bool planFanucDataInput(IsoContext& c, BlockPlan& plan);
/// G10 L50, L52: the blocks until G11 are parameters.
bool planFanucParameters(IsoContext& c, BlockPlan& plan);
/// G10 L3: the blocks until G11 are tool life data, which are noted.
bool planFanucToolLife(IsoContext& c, BlockPlan& plan);
/// The P of a form of G10: an integer from `min` to `max`. False: alarm `number` was reported.
bool fanucDataRow(IsoContext& c, const BlockPlan& plan, const char* number, std::int64_t min,
                  std::int64_t max, std::int64_t& row);

/// G68.2 P0 to P4.
bool planFanucTiltedPlane(IsoContext& c, BlockPlan& plan);
/// G69 ends the plane of G68.2 too. False: an error was reported.
bool fanucTiltOff(IsoContext& c, BlockPlan& plan);

/// G69, G50, G50.1 without axes, and the plane under G68 and G51. IsoDialect::transforms_off.
bool fanucTransformsOff(IsoContext& c, BlockPlan& plan);
/// G68 X Y R.
bool planFanucRotation(IsoContext& c, BlockPlan& plan);
/// G51 X Y Z P, or I J K.
bool planFanucScaling(IsoContext& c, BlockPlan& plan);
/// G51.1.
bool planFanucMirror(IsoContext& c, BlockPlan& plan);
/// G50.1 with axes.
bool planFanucMirrorOff(IsoContext& c, BlockPlan& plan);

}  // namespace proveout::nc
