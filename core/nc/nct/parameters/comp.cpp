#include "core/nc/iso/parameters/comp.h"

#include "core/nc/nct/parameters/rows.h"

namespace proveout::nc {
namespace {

using namespace param_rows;

constexpr std::array<ParamInfo, static_cast<std::size_t>(CompParam::kCount)> kCompRows{{
    number("N1400", 1400, kChannel, 999, 1, 999, "rows of the offset table"),
    bit("N1403.IEN", 1403, 0, kChannel, 1, "interference check of cutter compensation"),
    bit("N1403.AAL", 1403, 1, kChannel, 0,
        "interference: 1 always alarm, 0 leave out blocks where that mends it"),
    number("N1404", 1404, kChannel, 0, 0, 8, "further blocks that the interference check looks ahead"),
    number("N1405", 1405, kChannel, 0.001, 0, 10,
           "corner points of cutter compensation nearer than this are merged, mm"),
    bit("N1416.ZAX", 1416, 0, kChannel, 1, "length compensation always on Z"),
    bit("N1416.PLN", 1416, 1, kChannel, 0, "length compensation on the axis normal to the plane"),
}};

}  // namespace

std::span<const ParamInfo> compParams() { return kCompRows; }

}  // namespace proveout::nc
