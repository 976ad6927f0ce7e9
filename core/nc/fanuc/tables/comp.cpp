// Length offsets and cutter compensation.
#include "core/nc/fanuc/tables/tables.h"
#include "core/nc/fanuc/tools/offsets.h"
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/model/code_rows.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr GCode positionOffset(int code10, std::string_view ids, std::string_view meaning) {
  return action(code10, kOneShot, kSim, "XYZUVWIJKR", planFanucPositionOffset, false, ids, meaning);
}

constexpr auto kFanucCompTableG = std::to_array<GCode>({
    action(390, kOneShot, kSim, "IJK", planCornerArc, false, "fan-8-G39", "corner arc"),
    modal(400, kGroupRadiusComp, kSim, "fan-8-G40 fan-8-cancel", "cutter compensation off", "IJK"),
    modal(401, kOneShot, kState, "fan-8-G41.1", "normal direction control off"),
    modal(410, kGroupRadiusComp, kSim, "fan-8-G41", "cutter compensation left", "IJK"),
    modal(411, kOneShot, kState, "fan-8-G41.1", "normal direction control left: noted"),
    modal(420, kGroupRadiusComp, kSim, "fan-8-G42", "cutter compensation right", "IJK"),
    modal(421, kOneShot, kState, "fan-8-G41.1", "normal direction control right: noted"),
    modal(430, kGroupLengthComp, kSim, "fan-7-G43 fan-7-g43alone", "length offset plus", {}, true),
    modal(440, kGroupLengthComp, kSim, "fan-7-G44", "length offset minus", {}, true),
    positionOffset(450, "fan-7-G45", "the way grows by D"),
    positionOffset(460, "fan-7-G46", "the way shrinks by D"),
    positionOffset(470, "fan-7-G47", "the way grows by twice D"),
    positionOffset(480, "fan-7-G48", "the way shrinks by twice D"),
    modal(490, kGroupLengthComp, kSim, "fan-7-G49", "length offset off", {}, true),
});

constexpr auto kFanucCompTableFeatures = std::to_array<FeatureRow>({
    {"H", kState, "fan-7-hmissing", "length offset row; a missing one is told with its tool"},
    {"T groups", kHost, "fan-7-life", "tool life groups: noted with G10 L3"},
    {"start-up", kSim, "fan-8-startA fan-8-startB", "way in and out by comp_startup"},
    {"corners", kSim, "fan-8-corner fan-8-inner", "outside and inside corners of cutter compensation"},
    {"idle blocks", kSim, "fan-8-nomove",
     "one block without motion is bridged, before two the path is square"},
    {"D", kSim, "fan-8-dchange fan-8-inside", "change of D, negative D"},
    {"missing D", kState, "fan-8-dmissing", "the tool's own radius, or 0, with a finding"},
    {"side", kSim, "fan-8-sidechange", "change between G41 and G42"},
    {"F", kTime, "fan-8-feed", "feed of the tool centre"},
    {"041 033", kReject, "fan-8-041", "interference, no intersection"},
    {"034", kReject, "fan-8-034", "arc at start-up or cancel"},
});

}  // namespace

CodeTable fanucCompTable() { return {kFanucCompTableG, {}, kFanucCompTableFeatures}; }

}  // namespace proveout::nc
