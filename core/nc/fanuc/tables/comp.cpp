// Length offsets and cutter compensation.
#include "core/nc/fanuc/tables/tables.h"
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/model/code_rows.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr auto kFanucCompTableG = std::to_array<GCode>({
    action(390, kOneShot, kSim, "IJK", planCornerArc, false, "fan-8-G39", "corner arc"),
    modal(400, kGroupRadiusComp, kSim, "fan-8-G40", "cutter compensation off", "IJK"),
    modal(410, kGroupRadiusComp, kSim, "fan-8-G41", "cutter compensation left", "IJK"),
    modal(420, kGroupRadiusComp, kSim, "fan-8-G42", "cutter compensation right", "IJK"),
    modal(430, kGroupLengthComp, kSim, "fan-7-G43", "length offset plus", {}, true),
    modal(440, kGroupLengthComp, kSim, "fan-7-G44", "length offset minus", {}, true),
    modal(490, kGroupLengthComp, kSim, "fan-7-G49", "length offset off", {}, true),
});

}  // namespace

CodeTable fanucCompTable() { return {kFanucCompTableG, {}, {}}; }

}  // namespace proveout::nc
