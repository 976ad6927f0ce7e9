#include "core/nc/iso/parameters/spindle.h"

#include "core/nc/nct/parameters/rows.h"

namespace proveout::nc {
namespace {

using namespace param_rows;

/// N1507 + n in, N1523 + n out (with N1503.EAE), n the range.
constexpr ParamInfo tapping(std::string_view name, int no) {
  return number(
      name, no, kSpindle, 0, 0, 1e6,
      "rigid tapping: acceleration of the spindle in a range, 1/min per second; 0: as it accelerates "
      "otherwise");
}

constexpr std::array<ParamInfo, static_cast<std::size_t>(SpindleParam::kCount)> kSpindleRows{{
    atPowerOn(number("N0604", 604, kChannel, 1, 1, 16, "spindle of plain S, the main one at power-on")),
    number("N0685", 685, kSpindle, 0, -1e6, 1e6, "shift of phase behind the main spindle, pulses"),
    number("N0686", 686, kChannel, 0, 0, 1e6, "surface speed of G96 at power-on; 0: S must be programmed"),
    number("N0687", 687, kChannel, 1, 1, 32, "number of the axis whose position is the radius of G96"),
    number("N0688", 688, kChannel, 0, 0, 1e6, "least speed of the spindle in G96, 1/min"),
    number("N0689", 689, kChannel, 0, 0, 99999999, "first further M code of the spindles; 0: there are none"),
    number("N0690", 690, kChannel, 0, 0, 99999999, "last further M code of the spindles"),
    bit("N0607.IDS", 607, 7, kSpindle, 0, "M codes index the spindle in negative direction"),
    number("N0820", 820, kSpindle, 0, 0, 99999999,
           "first M code that indexes the spindle; 0: there are none"),
    number("N0821", 821, kSpindle, 0, 0, 1000, "number of M codes that index the spindle"),
    number("N0822", 822, kSpindle, 0, 0, 360, "angle of the first of them; the others turn by its multiples"),
    number("N0823", 823, kSpindle, 0, 0, 99999999,
           "M code that closes the position loop of the spindle; 0: there is none"),
    tapping("N1508", 1508),
    tapping("N1509", 1509),
    tapping("N1510", 1510),
    tapping("N1511", 1511),
    tapping("N1512", 1512),
    tapping("N1513", 1513),
    tapping("N1514", 1514),
    tapping("N1515", 1515),
    tapping("N1524", 1524),
    tapping("N1525", 1525),
    tapping("N1526", 1526),
    tapping("N1527", 1527),
    tapping("N1528", 1528),
    tapping("N1529", 1529),
    tapping("N1530", 1530),
    tapping("N1531", 1531),
}};

}  // namespace

std::span<const ParamInfo> spindleParams() { return kSpindleRows; }

}  // namespace proveout::nc
