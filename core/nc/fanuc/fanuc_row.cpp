#include "core/nc/fanuc/fanuc_row.h"

#include "core/nc/fanuc/coverage/rows.h"
#include "core/nc/fanuc/dialect.h"
#include "core/nc/fanuc/lathe/lathe_settings.h"
#include "core/nc/fanuc/parameters/fanuc_parameters.h"
#include "core/nc/fanuc/tables/tables.h"
#include "core/nc/iso/model/code_coverage.h"
#include "core/nc/iso/program/control.h"
#include "core/nc/specification/specification_text.h"

namespace proveout::nc {
namespace {

InterpretSummary runMill(const ProgramSource& source, const ControlSettings& settings, MotionSink& sink,
                         Progress* progress, const ControlHost& host) {
  return IsoControl(fanucMillDialect(settings.parameters), source, settings, sink, progress, host).run();
}

InterpretSummary runLathe(const ProgramSource& source, const ControlSettings& settings, MotionSink& sink,
                          Progress* progress, const ControlHost& host) {
  return IsoControl(fanucLatheDialect(settings.parameters), source, withLiveTools(withLatheAxes(settings)),
                    sink, progress, host)
      .run();
}

/// Codes of Haas that stand in place of others come behind those.
std::vector<CoverageRow> millCoverage() {
  static const CodeIndex kHaas({haasTable(), haasFramesTable(), haasMillTable()});
  std::vector<CoverageRow> rows = coverageOf(fanucMillCodes());
  const std::vector<CoverageRow> haas = coverageOf(kHaas);
  rows.insert(rows.end(), haas.begin(), haas.end());
  return rows;
}
std::vector<CoverageRow> latheCoverage() { return coverageOf(fanucLatheCodes()); }
std::vector<ParameterInfo> fanucSettings() { return fanucParameters().list(); }

}  // namespace

const ControlRow& fanucMillRow() {
  static const ControlRow kRow{
      .id = ControlId::kFanucMill,
      .name = "fanuc-mill",
      .summary = "Fanuc-like controls (0i, 30i; Haas), milling",
      .process = ProcessKind::kMilling,
      .manual = {"fan", specification_text::kFanuc},
      .settings_table = "fanuc",
      .axis_events = true,
      .run = runMill,
      .coverage = millCoverage,
      .coverage_ids = fanucRows,
      .open_reasons = fanucOpenReasons,
      .parameters = fanucSettings,
  };
  return kRow;
}

const ControlRow& fanucLatheRow() {
  static const ControlRow kRow{
      .id = ControlId::kFanucLathe,
      .name = "fanuc-lathe",
      .summary = "Fanuc-like controls (0i, 30i; Haas), turning",
      .process = ProcessKind::kTurning,
      .manual = {"fan", specification_text::kFanuc},
      .settings_table = "fanuc",
      .axis_events = true,
      .run = runLathe,
      .coverage = latheCoverage,
      .coverage_ids = fanucRows,
      .open_reasons = fanucOpenReasons,
      .parameters = fanucSettings,
  };
  return kRow;
}

}  // namespace proveout::nc
