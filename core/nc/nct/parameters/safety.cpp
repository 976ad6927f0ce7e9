#include "core/nc/nct/parameters/safety.h"

#include "core/nc/nct/parameters/rows.h"

namespace proveout::nc {
namespace {

using namespace param_rows;

// The manual prints no values for the distances of G37: those here suit setting gauges of usual size.
constexpr std::array<ParamInfo, static_cast<std::size_t>(SafetyParam::kCount)> kRows{{
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
}};

}  // namespace

std::span<const ParamInfo> safetyParams() { return kRows; }

}  // namespace proveout::nc
