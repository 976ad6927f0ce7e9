// Drilling cycles.
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/model/code_rows.h"
#include "core/nc/nct/tables/tables.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr GCode cycle(int code10, std::string_view ids, std::string_view meaning) {
  return action(code10, kGroupCycle, kSim, "XYZUVWIJKRQEPLa", planCycle, false, ids, meaning);
}

constexpr auto kCyclesGCodes = std::to_array<GCode>({
    cycle(730, "nct-3-G73 nct-18.1.1-G73", "high-speed peck drilling"),
    cycle(740, "nct-3-G74 nct-18.1.2-G74", "left tapping, floating holder"),
    cycle(760, "nct-3-G76 nct-18.1.3-G76", "fine boring, oriented retract"),
    modal(800, kGroupCycle, kSim, "nct-3-G80 nct-18.1.4-G80", "drilling cycle off"),
    cycle(810, "nct-3-G81 nct-18.1.5-G81", "drilling, rapid out"),
    cycle(820, "nct-3-G82 nct-18.1.6-G82", "drilling with dwell"),
    cycle(830, "nct-3-G83 nct-18.1.7-G83", "peck drilling"),
    cycle(840, "nct-3-G84 nct-18.1.8-G84", "right tapping, floating holder"),
    cycle(842, "nct-3-G84.2 nct-18.1.9-G84.2 nct-18.1.10-G84.2Q", "right rigid tapping"),
    cycle(843, "nct-3-G84.3 nct-18.1.9-G84.3 nct-18.1.10-G84.3Q", "left rigid tapping"),
    cycle(850, "nct-3-G85 nct-18.1.11-G85", "boring, feed out"),
    cycle(860, "nct-3-G86 nct-18.1.12-G86", "boring, spindle stop, rapid out"),
    cycle(870, "nct-3-G87 nct-18.1.13-G87A nct-18.1.13-G87B",
          "back boring, or boring with manual intervention"),
    cycle(880, "nct-3-G88 nct-18.1.14-G88", "boring with manual intervention"),
    cycle(890, "nct-3-G89 nct-18.1.15-G89", "boring with dwell, feed out"),
    cycle(831, "nct-18-CSM", "high-speed peck drilling, with N1503.CSM"),
    cycle(841, "nct-18-CSM", "left tapping, with N1503.CSM"),
    cycle(861, "nct-18-CSM", "fine boring, with N1503.CSM"),
    modal(980, kGroupReturn, kSim, "nct-3-G98 nct-18-G98", "cycles return to the initial point"),
    modal(990, kGroupReturn, kSim, "nct-3-G99 nct-18-G99", "cycles return to point R"),
});

constexpr auto kCyclesFeatures = std::to_array<FeatureRow>({
    {"tap times", kTime, "nct-18.1.9-EAE nct-18.1.10-ROE", "acceleration and returns of rigid taps"},
    {"cycle words", kSim,
     "nct-18-ops nct-18-axis nct-18-init nct-18-hole nct-18-bottom nct-18-R nct-18-IJK nct-18-Q nct-18-E "
     "nct-18-L",
     "words and operations of drilling cycles"},
    {"cycle times", kTime, "nct-18-P nct-18-F nct-18-I nct-18-S nct-18.1.9-EOE",
     "dwell, feed, speed and feed out of cycles"},
    {"cycle blocks", kSim,
     "nct-18.2-trigger nct-18.2-G04 nct-18.2-M nct-18.2-G43 nct-18.1.9-TSC nct-18.1.10-PTC",
     "which blocks of the cycle mode drill"},
    {"single block", kHost, "nct-17.1-single nct-18.2-single nct-15.5-mode",
     "a run is automatic mode: it never stops between blocks or inside cycles"},
    {"2053", kReject, "nct-18-2053", "no bottom point or R point"},
});

}  // namespace

CodeTable cyclesTable() { return {kCyclesGCodes, {}, kCyclesFeatures}; }

}  // namespace proveout::nc
