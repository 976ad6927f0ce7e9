#include "core/nc/nct/parameters/nct_parameters.h"

#include "core/nc/iso/parameters/safety.h"
#include "core/nc/nct/parameters/rows.h"

namespace proveout::nc {

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
        .add(ParamChapter::kFiveAxis, fiveAxisParams());
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
