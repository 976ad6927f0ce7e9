#include "core/nc/iso/parameters/data.h"

#include "core/nc/nct/parameters/rows.h"

namespace proveout::nc {
namespace {

using namespace param_rows;

constexpr std::array<ParamInfo, static_cast<std::size_t>(DataParam::kCount)> kDataRows{{
    atPowerOn(
        number("N1401", 1401, kGlobal, 0, 0, 999, "first rows of the offset tables that all channels share")),
    noted(bit("N1402.DIA", 1402, 0, kChannel, 0, "the control's table shows cutters by their diameter")),
    noted(number("N1414", 1414, kChannel, 0, 0, 255, "choice of turning offsets on lathes")),
    noted(number("N1415", 1415, kChannel, 0, 0, 1e3, "largest wear that a person may enter by hand, mm")),
    bit("N1416.TOL", 1416, 2, kChannel, 1, "turning columns in the offset table"),
    bit("N1755.PCS", 1755, 5, kChannel, 0,
        "positions are read in the coordinates of a tilted plane (G68.1, G68.2); 0: of the workpiece"),
    bit("N1755.TLC", 1755, 6, kChannel, 0, "positions with offsets are read without the length offset"),
    bit("N1757.PNT", 1757, 0, kChannel, 0, "DPRNT sends no spaces for plus signs and leading zeros"),
    number("N2305", 2305, kChannel, 0, 0, 99999999, "M function that counts parts; 0: M2 and M30 do"),
}};

}  // namespace

std::span<const ParamInfo> dataParams() { return kDataRows; }

}  // namespace proveout::nc
