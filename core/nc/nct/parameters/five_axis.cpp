#include "core/nc/iso/parameters/five_axis.h"

#include "core/nc/nct/parameters/rows.h"

namespace proveout::nc {
namespace {

using namespace param_rows;

constexpr double kFar = 1e6;

/// Without a value in the job these are those of the machine.
constexpr std::array<ParamInfo, static_cast<std::size_t>(FiveAxisParam::kCount)> kFiveAxisRows{{
    atPowerOn(number("N3200", 3200, kChannel, 0, 0, 3, "1 head-head, 2 table-table, 3 head-table; 0: none")),
    atPowerOn(number("N3201", 3201, kChannel, 3, 1, 3, "axis that the tool lies along: 1 X, 2 Y, 3 Z")),
    atPowerOn(number("N3204", 3204, kChannel, 0, 0, 32, "number of the first rotary axis")),
    atPowerOn(number("N3205", 3205, kChannel, 0, 0, 6,
                     "its direction: 1 X, 2 Y, 3 Z, 4 from X to Y, 5 from Y to Z, 6 from Z to X")),
    atPowerOn(number("N3206", 3206, kChannel, 0, -360, 360, "its inclination for directions 4 to 6, deg")),
    atPowerOn(number("N3208", 3208, kChannel, 0, 0, 32, "number of the second rotary axis")),
    atPowerOn(number("N3209", 3209, kChannel, 0, 0, 6, "its direction, as N3205")),
    atPowerOn(number("N3210", 3210, kChannel, 0, -360, 360, "its inclination, deg")),
    atPowerOn(bit("N3212.RD1", 3212, kNamedBit, kChannel, 0, "the first rotary axis turns left-handed")),
    atPowerOn(bit("N3212.RD2", 3212, kNamedBit, kChannel, 0, "the second rotary axis turns left-handed")),
    bit("N3212.FOS", 3212, 7, kChannel, 0,
        "where a rotary axis changes offsets or zeros (G43.1, G54.2, G53.1): 0 the linear axes follow, 1 the "
        "coordinates change"),
    atPowerOn(number("N3213", 3213, kChannel, 0, -kFar, kFar, "a point of the first table's axis, X, mm")),
    atPowerOn(number("N3214", 3214, kChannel, 0, -kFar, kFar, "the same, Y")),
    atPowerOn(number("N3215", 3215, kChannel, 0, -kFar, kFar, "the same, Z")),
    atPowerOn(
        number("N3216", 3216, kChannel, 0, -kFar, kFar, "from there to the second table's axis, X, mm")),
    atPowerOn(number("N3217", 3217, kChannel, 0, -kFar, kFar, "the same, Y")),
    atPowerOn(number("N3218", 3218, kChannel, 0, -kFar, kFar, "the same, Z")),
    atPowerOn(
        number("N3219", 3219, kChannel, 0, -kFar, kFar, "from the holder to the nearest head axis, X, mm")),
    atPowerOn(number("N3220", 3220, kChannel, 0, -kFar, kFar, "the same, Y")),
    atPowerOn(number("N3221", 3221, kChannel, 0, -kFar, kFar, "the same, Z")),
    atPowerOn(number("N3222", 3222, kChannel, 0, -kFar, kFar, "from there to the other head axis, X, mm")),
    atPowerOn(number("N3223", 3223, kChannel, 0, -kFar, kFar, "the same, Y")),
    atPowerOn(number("N3224", 3224, kChannel, 0, -kFar, kFar, "the same, Z")),
}};

}  // namespace

std::span<const ParamInfo> fiveAxisParams() { return kFiveAxisRows; }

}  // namespace proveout::nc
