// Drilling cycles of mills.
#include "core/nc/fanuc/tables/tables.h"
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/model/code_rows.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr GCode cycle(int code10, std::string_view ids, std::string_view meaning) {
  return action(code10, kGroupCycle, kSim, "XYZUVWIJKRQPKLa", planCycle, false, ids, meaning);
}

constexpr auto kFanucCyclesTableG = std::to_array<GCode>({
    cycle(730, "fan-10-G73", "high-speed peck drilling"),
    cycle(740, "fan-10-G74", "left tapping"),
    cycle(760, "fan-10-G76", "fine boring"),
    modal(800, kGroupCycle, kSim, "fan-10-G80", "drilling cycle off"),
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

}  // namespace

CodeTable fanucCyclesTable() { return {kFanucCyclesTableG, {}, {}}; }

}  // namespace proveout::nc
