// Codes that Haas mills have beside those of Fanuc-like controls, or have otherwise (section 18 of the rows).
// Lengths in messages are millimetres. All functions: false means that an error was reported.
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

// haas_codes.cpp
/// G0, G1: as with Fanuc; under G141 along I, J, K beside the path.
bool planHaasMove(IsoContext& c, BlockPlan& plan);
/// G2, G3: a full circle by R is refused.
bool planHaasArc(IsoContext& c, BlockPlan& plan);
/// G28 without axes brings all of them home, Z first.
bool planHaasReference(IsoContext& c, BlockPlan& plan);
/// G52 by Setting 33.
bool planHaasLocalFrame(IsoContext& c, BlockPlan& plan);
/// G101 X Y Z: mirrored about the zero of the work system. G100: no longer.
bool planHaasMirror(IsoContext& c, BlockPlan& plan);
bool planHaasMirrorOff(IsoContext& c, BlockPlan& plan);
/// G141 D: every point is moved by the radius of D along I, J, K of its block.
bool planHaasSpaceComp(IsoContext& c, BlockPlan& plan);
/// M96, M109: what the machine or the person at it would answer is not known.
bool refuseHaasInput(IsoContext& c, BlockPlan& plan);
/// IsoDialect::work_system: G154 P1 to P99, and G110 to G129 for P1 to P20.
bool haasWorkSystem(IsoContext& c, BlockPlan& plan, const GCode& code, int& id);

/// G254: the zero of the work system goes with the rotary tables, from where it was measured with them at the
/// system's own angles; the coordinates do not turn. G255: no longer. Without a table in the job's machine an
/// error.
bool planHaasDynamicOffset(IsoContext& c, BlockPlan& plan);

// haas_patterns.cpp
/// G70 I J L: L holes on a circle of radius I, the first at J degrees. G71 I J K L: the same, K degrees
/// apart. G72 I J L: on a line at J degrees, I apart, the first at the start.
bool planHaasHoles(IsoContext& c, BlockPlan& plan);

// haas_pockets.cpp
/// G12, G13: a round pocket about the tool.
bool planHaasRoundPocket(IsoContext& c, BlockPlan& plan);
/// G150: a pocket of any outline, which a subprogram tells.
bool planHaasOutlinePocket(IsoContext& c, BlockPlan& plan);

// haas_engraving.cpp
/// G47: the text of the comment in single strokes.
bool planHaasEngraving(IsoContext& c, BlockPlan& plan);

/// The path is one of several that make the same part: told once for each code.
void noteHaasPath(IsoContext& c, std::string_view code, std::string_view what);

}  // namespace proveout::nc
