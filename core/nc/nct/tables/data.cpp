// System variables, parameters, output of programs.
#include "core/nc/nct/tables/rows.h"
#include "core/nc/nct/tables/tables.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr auto kFeatures = std::to_array<FeatureRow>({
    {"PRM", kSim, "nct-24.2-PRM", "value of a parameter in formulas"},
});

}  // namespace

CodeTable dataTable() { return {{}, {}, kFeatures}; }

}  // namespace proveout::nc
