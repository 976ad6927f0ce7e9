#include "core/nc/iso/parameters/cycles.h"

#include "core/nc/nct/parameters/rows.h"

namespace proveout::nc {
namespace {

using namespace param_rows;

constexpr std::array<ParamInfo, static_cast<std::size_t>(CycleParam::kCount)> kCyclesRows{{
    number("N1500", 1500, kChannel, 1, 0, 1e3, "G73 pull-back, mm"),
    number("N1501", 1501, kChannel, 1, 0, 1e3, "G83 clearance, mm"),
    number("N1502", 1502, kChannel, 100, 1, 1000, "G85, G89 feed out, % of the feed in"),
    bit("N1503.TSC", 1503, kNamedBit, kChannel, 0,
        "rigid tapping: orient the spindle instead of closing the loop"),
    bit("N1503.PTC", 1503, 3, kChannel, 0, "rigid tapping with Q: return to R between pecks"),
    bit("N1503.EOE", 1503, 4, kChannel, 0, "rigid tapping: override of the feed out in force"),
    bit("N1503.ROE", 1503, 5, kChannel, 0,
        "rigid tapping with return to R: override of the returns in force"),
    bit("N1503.EAE", 1503, 6, kChannel, 0, "rigid tapping: acceleration of its own on the way out"),
    number("N1507", 1507, kChannel, 100, 1, 1000,
           "rigid tapping: returns to R between pecks, % (with N1503.ROE)"),
    bit("N1503.CSM", 1503, kNamedBit, kChannel, 0, "G83.1, G84.1, G86.1 instead of G73, G74, G76"),
    number("N1504", 1504, kChannel, 1, 0, 1e3, "rigid tapping with Q: pull-back, mm"),
    number("N1505", 1505, kChannel, 1, 0, 1e3, "rigid tapping with Q and return to R: clearance, mm"),
    number("N1506", 1506, kChannel, 100, 1, 1000, "rigid tapping: feed out, % (with N1503.EOE)"),
}};

}  // namespace

std::span<const ParamInfo> cyclesParams() { return kCyclesRows; }

}  // namespace proveout::nc
