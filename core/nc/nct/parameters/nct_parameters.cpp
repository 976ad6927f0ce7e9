#include "core/nc/nct/parameters/nct_parameters.h"

#include "core/nc/iso/parameters/safety.h"
#include "core/nc/nct/parameters/rows.h"

namespace proveout::nc {

namespace {

/// Chapter 20 ties axes by parameters and by what the machine builder's PLC makes of M codes: only together
/// do they mean something, and the machine's file has both in one place.
constexpr auto kElsewhere = std::to_array<ElsewhereParam>({
    {"N2101",
     "write couple = [[\"MASTER\", \"SLAVE\"]] with the M code that couples them under [[machine.event]]; of "
     "axes with two drives (N2102 PSN = 1) gantry = [[\"MASTER\", \"SLAVE\"]] or tandem = ... under "
     "[machine]"},
    {"N2102",
     "a slave that goes the other way (MSY = 1) stands in opposite = [\"SLAVE\"] of its [[machine.event]]; "
     "axes with two drives (PSN = 1) are gantry = [[\"MASTER\", \"SLAVE\"]] or tandem = ... under [machine]"},
    {"N2103", "the manual does not name it; what M codes do to axes stands under [[machine.event]]"},
    {"N2104",
     "write exchange = [\"MASTER\", \"SLAVE\"] with the M code that exchanges them under [[machine.event]]"},
    {"N2105",
     "an axis that is reversed while it is exchanged (MMI = 1) stands in reverse = [\"AXIS\"] of its "
     "[[machine.event]]"},
});

}  // namespace

const ParameterTable& nctParameters() {
  static const ParameterTable kTable = [] {
    ParameterTable table("nct");
    table.add(ParamChapter::kMotion, motionParams())
        .add(ParamChapter::kMachine, machineParams())
        .add(ParamChapter::kComp, compParams())
        .add(ParamChapter::kCycles, cyclesParams())
        .add(ParamChapter::kMacro, macroParams())
        .add(ParamChapter::kFeeds, feedParams())
        .add(ParamChapter::kData, dataParams())
        .add(ParamChapter::kAxis, axisParams())
        .add(ParamChapter::kTools, toolParams())
        .add(ParamChapter::kSpindle, spindleParams())
        .add(ParamChapter::kFunctions, functionParams())
        .add(ParamChapter::kProgram, programParams())
        .add(ParamChapter::kSafety, safetyParams())
        .add(ParamChapter::kFiveAxis, fiveAxisParams())
        .tellElsewhere(kElsewhere);
    return table;
  }();
  return kTable;
}

std::vector<ParameterInfo> nctParameterList() { return nctParameters().list(); }

bool givesStroke(const std::map<std::string, double>& values) {
  for (const SafetyParam end : {SafetyParam::kStrokeAHigh, SafetyParam::kStrokeALow,
                                SafetyParam::kStrokeBHigh, SafetyParam::kStrokeBLow}) {
    // No other parameter's name begins with one of these.
    const std::string name(nctParameters().row(end).name);
    const auto given = values.lower_bound(name);
    if (given != values.end() && given->first.starts_with(name)) return true;
  }
  return false;
}

}  // namespace proveout::nc
