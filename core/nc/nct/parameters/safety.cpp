#include "core/nc/iso/parameters/safety.h"

#include "core/nc/nct/parameters/rows.h"

namespace proveout::nc {
namespace {

using namespace param_rows;

// The manual names N1006 and N1007; the ends of the stroke and zone 3 have the numbers around these.
// The manual prints no values for the distances of G37: those here suit setting gauges of usual size.
constexpr std::array<ParamInfo, static_cast<std::size_t>(SafetyParam::kCount)> kSafetyRows{{
    bit("N3001.SKF", 3001, 0, kChannel, 0, "G31 goes with the feed N0311; 0: with F"),
    number("N0311", 311, kChannel, 0, 0, 1e6, "feed of G31, mm/min"),
    bit("N3003.TLF", 3003, 0, kChannel, 0, "G37 goes with the feed N0312; 0: with F"),
    bit("N3003.TMW", 3003, 1, kChannel, 0, "G37 corrects wear; 0: geometry"),
    bit("N3003.TCA", 3003, 2, kChannel, 0, "G37 adds the difference to the length; 0: takes it away"),
    number("N0312", 312, kChannel, 0, 0, 1e6, "feed of G37, mm/min"),
    number("N3004", 3004, kChannel, 10, 0, 1e6,
           "G37 goes in rapid up to this distance from the gauge, mm; above N3005"),
    number("N3005", 3005, kChannel, 5, 0, 1e6,
           "largest difference that G37 may measure, mm; above 0, otherwise alarm 2104"),
    noted(number("N3019", 3019, kChannel, 0, 0, 1e9, "lag of the servos allowed during G31 P98")),
    bit("N1000.RE2", 1000, 1, kAxis, 0, "the axis takes part in zone 2"),
    bit("N1000.RE3", 1000, 2, kAxis, 0, "the axis takes part in zone 3"),
    bit("N1001.EXT", 1001, 0, kChannel, 0, "zone 2 forbids its outside; 0: its inside"),
    bit("N1001.STE", 1001, 1, kChannel, 0, "zone 2 of the parameters is on"),
    bit("N1001.CBM", 1001, 2, kChannel, 0, "areas are looked at before a motion starts"),
    number("N1002", 1002, kAxis, 0, -1e6, 1e6,
           "positive end of the stroke, range A, machine coordinates; limits once it is given"),
    number("N1003", 1003, kAxis, 0, -1e6, 1e6, "negative end of the stroke, range A"),
    number("N1004", 1004, kAxis, 0, -1e6, 1e6, "positive end of the stroke, range B"),
    number("N1005", 1005, kAxis, 0, -1e6, 1e6, "negative end of the stroke, range B"),
    number("N1006", 1006, kAxis, 0, -1e6, 1e6, "zone 2, positive side, machine coordinates; above N1007"),
    number("N1007", 1007, kAxis, 0, -1e6, 1e6, "zone 2, negative side"),
    number("N1008", 1008, kAxis, 0, -1e6, 1e6, "zone 3, positive side, machine coordinates; above N1009"),
    number("N1009", 1009, kAxis, 0, -1e6, 1e6, "zone 3, negative side"),
}};

}  // namespace

std::span<const ParamInfo> safetyParams() { return kSafetyRows; }

}  // namespace proveout::nc
