#include "core/nc/linuxcnc/linuxcnc_row.h"

#include "core/nc/iso/model/code_coverage.h"
#include "core/nc/iso/program/control.h"
#include "core/nc/linuxcnc/coverage/rows.h"
#include "core/nc/linuxcnc/dialect.h"
#include "core/nc/linuxcnc/files/lcn_settings.h"
#include "core/nc/linuxcnc/parameters/linuxcnc_parameters.h"
#include "core/nc/specification/specification_text.h"

namespace proveout::nc {
namespace {

std::string lcnMainText(const ProgramSource& source) {
  const Result<ProgramText> main = source.mainProgram();
  return main.ok() ? main->bytes : std::string();
}

InterpretSummary runLinuxCnc(const ProgramSource& source, const ControlSettings& settings, MotionSink& sink,
                             Progress* progress, const ControlHost& host) {
  const ControlSettings all = withLcnMachine(settings, lcnMainText(source));
  return IsoControl(linuxCncDialect(all.parameters), source, all, sink, progress, host).run();
}

std::vector<CoverageRow> linuxCncCoverage() { return coverageOf(linuxCncCodes()); }
std::vector<ParameterInfo> linuxCncSettings() { return linuxCncParameters().list(); }

}  // namespace

const ControlRow& linuxCncRow() {
  static const ControlRow kRow{
      .id = ControlId::kLinuxCnc,
      .name = "linuxcnc",
      .summary = "LinuxCNC, GRBL, Mach3, milling",
      .process = ProcessKind::kMilling,
      .manual = {"lcn", specification_text::kLinuxCnc},
      .axis_events = true,
      .run = runLinuxCnc,
      .coverage = linuxCncCoverage,
      .coverage_ids = linuxCncRows,
      .open_reasons = linuxCncOpenReasons,
      .parameters = linuxCncSettings,
      .texts = linuxCncTexts(),
  };
  return kRow;
}

}  // namespace proveout::nc
