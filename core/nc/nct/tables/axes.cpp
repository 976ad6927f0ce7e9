// Axes that the machine builder's M codes and parameters tie together: manual 20.2 to 20.8.
#include "core/nc/iso/model/code_rows.h"
#include "core/nc/nct/tables/tables.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr auto kAxesFeatures = std::to_array<FeatureRow>({
    {"coupled axes", kSim, "nct-20.2-sync nct-20.2-MSY nct-20.2-CHAIN nct-20.2-WAIT",
     "slaves make the increments of their master"},
    {"slave axis", kReject, "nct-20.2-SLAVE", "a slave is not programmed while it is coupled"},
    {"parked axes", kSim, "nct-20.2-park", "computed, but not moved"},
    {"exchanged axes", kSim, "nct-20.3-exchange nct-20.3-MMI nct-20.3-INHERIT",
     "two axes move by each other's words; offsets stay with the axis"},
    {"reversed axes", kSim, "nct-20.4-mirror nct-20.4-G53",
     "an axis goes against its direction, not for G53 G28 G30"},
    {"head change", kSim, "nct-20.5-head", "horizontal head: Y and Z exchanged, X reversed"},
    {"gantry axes", kHost, "nct-20.6-gantry nct-20.6-1008", "two drives and encoders: one axis to programs"},
    {"tandem axes", kHost, "nct-20.7-tandem", "two drives, one encoder: one axis to programs"},
    {"inclined axes", kReject, "nct-20.8-inclined", "X, Y and Z are at right angles"},
});

}  // namespace

CodeTable axesTable() { return {{}, {}, kAxesFeatures}; }

}  // namespace proveout::nc
