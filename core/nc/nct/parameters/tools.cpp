#include "core/nc/iso/parameters/tools.h"

#include "core/nc/nct/parameters/rows.h"

namespace proveout::nc {
namespace {

using namespace param_rows;

constexpr std::array<ParamInfo, static_cast<std::size_t>(ToolParam::kCount)> kToolsRows{{
    bit("N2901.TLC", 2901, 1, kGlobal, 0, "the life of counted tools counts at T instead of the tool change"),
    number("N2902", 2902, kGlobal, 999, 1, 9999, "rows of the tool management table"),
    number("N2903", 2903, kGlobal, 20, 0, 20, "columns of user values in the tool management table"),
    number("N2923", 2923, kGlobal, 0, 0, 999,
           "H or D that stands for the offsets of the tool in the spindle; 0: none does"),
    number("N2924", 2924, kGlobal, 0, 0, 99999999,
           "M function with which T is a place: magazine * 10000 + pocket; 0: there is none"),
}};

}  // namespace

std::span<const ParamInfo> toolParams() { return kToolsRows; }

}  // namespace proveout::nc
