// Program organisation: channels, reset, look-ahead.
#include "core/nc/iso/model/code_rows.h"
#include "core/nc/nct/tables/tables.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr auto kProgramFeatures = std::to_array<FeatureRow>({
    {"channels", kHost, "nct-1.2-channel nct-1.2-sync",
     "up to 8 milling channels, each with its program, on one time axis and one stock"},
    {"offsets of channels", kState, "nct-10.2-channels", "tables of their own; common rows by N1401"},
    {"waiting codes", kSim, "nct-14.5-wait", "M codes N2201 to N2202 with P: channels meet"},
    {"lathe channel", kReject, "nct-1.2-lathe", "refused: it has a control of its own"},
    {"reset", kState, "nct-3-reset nct-3-CLR nct-3-N1301",
     "codes after M2 and M30: N1300, N1301 and the CLR G tables"},
    {"buffer functions", kSim, "nct-13.3-flush", "M codes, S, T and auxiliary functions that end look-ahead"},
});

}  // namespace

CodeTable programTable() { return {{}, {}, kProgramFeatures}; }

}  // namespace proveout::nc
