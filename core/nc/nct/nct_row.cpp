#include "core/nc/nct/nct_row.h"

#include <sstream>

#include "core/nc/iso/channels/channels.h"
#include "core/nc/iso/model/code_coverage.h"
#include "core/nc/iso/program/control.h"
#include "core/nc/nct/coverage/coverage_rows.h"
#include "core/nc/nct/dialect.h"
#include "core/nc/nct/parameters/nct_parameters.h"
#include "core/nc/specification/specification_text.h"

namespace proveout::nc {
namespace {

InterpretSummary run(const ProgramSource& source, const ControlSettings& settings, MotionSink& sink,
                     Progress* progress, const ControlHost& host) {
  return IsoControl(nctDialect(), source, settings, sink, progress, host).run();
}

InterpretSummary runChannels(const std::vector<ChannelProgram>& channels, MotionSink& sink,
                             Progress* progress, const ControlHost& host) {
  return IsoChannels(nctDialect(), channels, sink, progress, host).run();
}

std::vector<CoverageRow> coverage() { return coverageOf(nctCodes()); }

std::vector<CoverageIdRow> coverageIds() {
  std::vector<CoverageIdRow> rows;
  for (const CoverageId& row : nctRows())
    rows.push_back({row.id, codeClassName(row.cls), rowStatusName(row.status), row.proof});
  return rows;
}

std::map<std::string, std::string_view> openReasons() {
  std::map<std::string, std::string_view> reasons;
  for (const OpenRows& open : nctOpenRows()) {
    std::istringstream ids{std::string(open.ids)};
    for (std::string id; ids >> id;) reasons[id] = open.reason;
  }
  return reasons;
}

}  // namespace

const ControlRow& nctRow() {
  static const ControlRow kRow{
      .id = ControlId::kNct,
      .name = "nct",
      .summary = "NCT 2xx/3xx, milling channel",
      .process = ProcessKind::kMilling,
      .manual = {"nct", specification_text::kNct},
      .axis_events = true,
      .run = run,
      .run_channels = runChannels,
      .coverage = coverage,
      .coverage_ids = coverageIds,
      .open_reasons = openReasons,
      .parameters = nctParameterList,
      .limits_travel = givesStroke,
  };
  return kRow;
}

}  // namespace proveout::nc
