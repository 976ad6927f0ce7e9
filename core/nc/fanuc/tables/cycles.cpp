// Drilling cycles of mills.
#include "core/nc/fanuc/cycles/fanuc_cycles.h"
#include "core/nc/fanuc/tables/tables.h"
#include "core/nc/iso/model/code_rows.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr GCode cycle(int code10, std::string_view ids, std::string_view meaning) {
  return action(code10, kGroupCycle, kSim, "XYZUVWIJKRQPKLa", planFanucCycle, false, ids, meaning);
}

constexpr auto kFanucCyclesTableG = std::to_array<GCode>({
    cycle(730, "fan-10-G73", "high-speed peck drilling"),
    cycle(740, "fan-10-G74", "left tapping"),
    cycle(760, "fan-10-G76", "fine boring"),
    modal(800, kGroupCycle, kSim, "fan-10-G80", "drilling cycle off"),
    refused(811, kGroupCycle, kReject, "fan-10-G81.1", "chopping"),
    cycle(810, "fan-10-G81", "drilling"),
    cycle(820, "fan-10-G82", "drilling with dwell"),
    cycle(830, "fan-10-G83", "peck drilling"),
    cycle(840, "fan-10-G84", "right tapping"),
    cycle(850, "fan-10-G85", "boring, feed out"),
    cycle(860, "fan-10-G86", "boring, spindle stop, rapid out"),
    cycle(870, "fan-10-G87", "back boring"),
    cycle(880, "fan-10-G88", "boring, manual out"),
    cycle(890, "fan-10-G89", "boring with dwell, feed out"),
    modal(980, kGroupReturn, kSim, "fan-10-return", "cycles return to the start level"),
    modal(990, kGroupReturn, kSim, "fan-10-return", "cycles return to level R"),
});

constexpr auto kFanucCyclesTableM = std::to_array<MCode>({
    {29, MPhase::kBefore, 0, kSim, {}, "fan-10-rigid", "rigid tapping", planRigidTapMode},
});

constexpr auto kFanucCyclesFeatures = std::to_array<FeatureRow>({
    {"repeats", kSim, "fan-10-K", "K and L of a cycle; 0 keeps its words"},
    {"cycle levels", kSim, "fan-10-inc", "R counts from the start level and Z from R under G91"},
    {"cycle blocks", kSim, "fan-10-nomove fan-10-group1", "which blocks of the cycle mode drill"},
    {"cycle errors", kReject, "fan-10-missing fan-10-rigiderr", "alarms 045, 200, 201, 203, no bottom"},
    {"rigid pecks", kSim, "fan-10-rigidpeck", "Q of G84 and G74 in rigid tapping"},
});

}  // namespace

CodeTable fanucCyclesTable() { return {kFanucCyclesTableG, kFanucCyclesTableM, kFanucCyclesFeatures}; }

}  // namespace proveout::nc
