// Rows of the manual that this control does not serve yet, and why. A row leaves this list when a test proves
// it.
#include "core/nc/nct/coverage/coverage_rows.h"

namespace proveout::nc {
namespace {

// clang-format off: ids separated by blanks
constexpr OpenRows kOpen[] = {
    {"deferred: turning, gear and five-axis functions are not asked of this control yet",
     "nct-3-G77.7 nct-3-G78.7 nct-3-G79.7 nct-3-G43.8 nct-3-G43.9 "
     "nct-3-G70.7 nct-3-G71.7 "
     "nct-3-G72.7 nct-3-G73.7 nct-3-G74.7 nct-3-G75.7 nct-3-G76.7 nct-3-G80.8 nct-3-G81.8 "
     "nct-18.2-turning "},
    {"turning cycles are not built for this control",
     "nct-19.1.1-G77.7 nct-19.1.2-G78.7 nct-19.1.3-G79.7 nct-19.2.1-G71.7 nct-19.2.2-G72.7 "
     "nct-19.2.3-G73.7 nct-19.2.4-G70.7 nct-19.2.5-G74.7 nct-19.2.6-G75.7 nct-19.2.7-G76.7 "},
    {"the electronic gear is not built",
     "nct-20.1-G81.8 nct-20.1-G80.8 nct-20.1.1-FRS nct-20.1.2-R1R2 nct-20.1.3-QP nct-20.1.4-retract "},
    {"five-axis functions are not built",
     "nct-25.17-G43.8 nct-25.17-G43.9 nct-25.17-L2 "
     "nct-25.17-r nct-25.17-G49 nct-25.18-G5.1Q3 nct-25.18-G5.1Q1 nct-25.18-G5.1Q0 nct-25.18-PAR "
     "nct-25.18-SBK nct-25.20-BSE nct-25.20-HH nct-25.20-TT nct-25.20-HT nct-25.20-ORD "
     "nct-25.20-HIRTH nct-25.20-JOG "},
};
// clang-format on

}  // namespace

std::span<const OpenRows> nctOpenRows() { return kOpen; }

}  // namespace proveout::nc
