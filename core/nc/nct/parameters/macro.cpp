#include "core/nc/nct/parameters/macro.h"

#include "core/nc/nct/parameters/rows.h"

namespace proveout::nc {
namespace {

using namespace param_rows;

constexpr std::array<ParamInfo, static_cast<std::size_t>(MacroParam::kCount)> kRows{{
    bit("N1301.MBM", 1301, 6, kChannel, 1,
        "blocks are read ahead; the simulation runs them in order either way, with the same path"),
    number("N1702", 1702, kChannel, 0, 0, 999,
           "first variable of #500 to #999 that programs cannot write; 0: none"),
    number("N1703", 1703, kChannel, 0, 0, 999, "last variable of #500 to #999 that programs cannot write"),
    bit("N1755.SBM", 1755, 2, kChannel, 0,
        "macro blocks run during the motion before them; the path is the same either way"),
}};

}  // namespace

std::span<const ParamInfo> macroParams() { return kRows; }

}  // namespace proveout::nc
