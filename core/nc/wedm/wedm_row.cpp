#include "core/nc/wedm/wedm_row.h"

#include "core/nc/specification/specification_text.h"
#include "core/nc/wedm/wedm_codes.h"
#include "core/nc/wedm/wedm_control.h"

namespace proveout::nc {
namespace {

InterpretSummary runWedm(const ProgramSource& source, const ControlSettings& settings, MotionSink& sink,
                         Progress* progress, const ControlHost& /*host*/) {
  return WedmControl(source, settings, sink, progress).run();
}

}  // namespace

const ControlRow& wedmRow() {
  static const ControlRow kRow{
      .id = ControlId::kWedm,
      .name = "wedm",
      .summary = "wire EDM",
      .process = ProcessKind::kWire,
      .manual = {"wedm", specification_text::kWedm},
      .run = runWedm,
      .coverage = wedmCoverage,
      .coverage_ids = wedmCoverageIds,
      .open_reasons = wedmOpenReasons,
      .parameters = wedmParameterTable,
  };
  return kRow;
}

}  // namespace proveout::nc
