#include "core/nc/iso/parameters/feeds.h"

#include "core/nc/nct/parameters/rows.h"

namespace proveout::nc {
namespace {

using namespace param_rows;

constexpr std::array<ParamInfo, static_cast<std::size_t>(FeedParam::kCount)> kFeedsRows{{
    number("N0305", 305, kAxis, 0, 0, 1e7, "highest feed of the axis, mm/min or deg/min; 0: no limit"),
    bit("N0306.FDF", 306, 0, kChannel, 1, "corners: 1 by the change of the axes' speeds, 0 by their angle"),
    number("N0307", 307, kChannel, 0, 0, 180,
           "corners by angle: a larger change of direction is a corner, deg; 0: none is"),
    number("N0308", 308, kChannel, 60, 1e-3, 1e7, "corners by angle: feed there, mm/min"),
    number(
        "N0309", 309, kAxis, 0, 0, 1e7,
        "change of the axis' speed that a corner may make, mm/min; 0: what its acceleration makes in 10 ms"),
    number("N0310", 310, kChannel, 0, 0, 1e7,
           "the limit of acceleration across arcs lowers the feed no further than this, mm/min"),
    number("N0402", 402, kAxis, 0, 0, 1e6, "acceleration of the axis across the path, mm/s^2; 0: no limit"),
    number("N0403", 403, kAxis, 0, 0, 1e6, "jump of acceleration between short lines, mm/s^2; 0: no limit"),
    number("N0404", 404, kAxis, 0, 0, 1e6,
           "jump of acceleration where an arc begins or ends, mm/s^2; 0: no limit"),
    bit("N0421.ROL", 421, kNamedBit, kChannel, 0,
        "rapids overlap: the next starts before the last has ended"),
    number("N0422", 422, kChannel, 0, 0, 100,
           "overlap: a rapid starts when the last one is down to this part of its speed, %"),
    noted(number("N0516", 516, kAxis, 0.01, 0, 10,
                 "in-position window; an ideal machine is always inside, mm or deg")),
    bit("N1337.PCH", 1337, kNamedBit, kChannel, 0, "rapids stop at their end and wait for their position"),
    noted(number("N1340", 1340, kChannel, 1, 0, 1e6,
                 "time to reach the in-position window, s; an ideal machine never needs it")),
    number("N1406", 1406, kChannel, 0, 0, 1, "least part of the feed on arcs that are cut from inside"),
    number("N1407", 1407, kChannel, 0, 0, 1e4, "G62: length of the slow way before an inside corner, mm"),
    number("N1408", 1408, kChannel, 0, 0, 1e4, "G62: length of the slow way behind an inside corner, mm"),
    number("N1409", 1409, kChannel, 90, 1, 180, "G62: corners with a smaller angle count, deg"),
    number("N1410", 1410, kChannel, 1, 1e-6, 1, "G62: part of the feed at inside corners"),
}};

}  // namespace

std::span<const ParamInfo> feedParams() { return kFeedsRows; }

}  // namespace proveout::nc
