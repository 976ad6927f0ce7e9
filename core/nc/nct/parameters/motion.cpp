#include "core/nc/iso/parameters/motion.h"

#include "core/nc/nct/parameters/rows.h"

namespace proveout::nc {
namespace {

using namespace param_rows;

constexpr std::array<ParamInfo, static_cast<std::size_t>(MotionParam::kCount)> kMotionRows{{
    number("N0300", 300, kChannel, 0, 0, 1e6,
           "feed at power-on in G94, units of length a minute; 0: a feed must be programmed"),
    number("N0301", 301, kChannel, 0, 0, 1e3,
           "feed at power-on in G95, units of length a turn; 0: a feed must be programmed"),
    bit("N1300.G01", 1300, 0, kChannel, 0, "power-on interpolation: 0 G0, 1 G1"),
    bit("N1300.G18", 1300, 1, kChannel, 0, "power-on plane G18"),
    bit("N1300.G19", 1300, 2, kChannel, 0, "power-on plane G19"),
    bit("N1300.G20", 1300, 3, kChannel, 0, "power-on inch data; not given: as the job says"),
    bit("N1300.G43", 1300, 5, kChannel, 0, "power-on length compensation G43"),
    bit("N1300.G44", 1300, 6, kChannel, 0, "power-on length compensation G44"),
    bit("N1300.G91", 1300, 7, kChannel, 0, "power-on incremental data"),
    bit("N1301.G95", 1301, 0, kChannel, 0, "power-on feed per turn"),
    bit("N1337.SEC", 1337, 1, kChannel, 0, "dwell always in seconds"),
    bit("N1337.CCA", 1337, 2, kChannel, 0, "arc centre words are absolute"),
    bit("N1337.HEF", 1337, 3, kChannel, 0, "helix feed along the path in space, not along the circle"),
    bit("N1337.CBB", 1337, 4, kChannel, 1, "an optional-skip block does not stop look-ahead"),
    // The machine builder sets it. A job that does not give it leaves open whether the real control would
    // alarm: up to this difference the arc then runs as a spiral with a warning. 2 mm lets sloppy but
    // harmless arcs of real programs through and still refuses a wrong centre.
    number("N1339", 1339, kChannel, 2, 0, 1e3, "difference of start and end radius that an arc may have, mm"),
}};

}  // namespace

std::span<const ParamInfo> motionParams() { return kMotionRows; }

}  // namespace proveout::nc
