#include "core/nc/flexnc/flexnc_row.h"

#include "core/nc/flexnc/flexnc_codes.h"
#include "core/nc/flexnc/flexnc_control.h"
#include "core/nc/flexnc/flexnc_parameters.h"
#include "core/nc/specification/specification_text.h"

namespace proveout::nc {
namespace {

InterpretSummary runFlexNc(const ProgramSource& source, const ControlSettings& settings, MotionSink& sink,
                           Progress* progress, const ControlHost& /*host*/) {
  return FlexControl(source, settings, sink, progress).run();
}

}  // namespace

const ControlRow& flexncRow() {
  static const ControlRow kRow{
      .id = ControlId::kFlexNc,
      .name = "flexnc",
      .summary = "FlexNC / Stankocenter, turning",
      .process = ProcessKind::kTurning,
      .manual = {"fnc", specification_text::kFlexnc},
      .run = runFlexNc,
      .coverage = flexncCoverage,
      .coverage_ids = flexncCoverageIds,
      .parameters = flexncParameterTable,
  };
  return kRow;
}

}  // namespace proveout::nc
