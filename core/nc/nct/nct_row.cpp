#include "core/nc/nct/nct_row.h"

#include <fmt/core.h>

#include <sstream>
#include <utility>

#include "core/nc/iso/channels/channels.h"
#include "core/nc/iso/model/codes.h"
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

std::string_view statusOf(CodeClass cls, bool built) {
  if (!built) return "refused";
  switch (cls) {
    case CodeClass::kSim:
      return "simulated";
    case CodeClass::kTime:
      return "timed";
    case CodeClass::kState:
      return "tracked";
    case CodeClass::kHost:
      return "noted";
    case CodeClass::kReject:
      return "checked";
  }
  return "refused";
}

/// `code`: a row of the tables, whatever its kind.
template <class Code>
CoverageRow coverageRow(std::string name, int group, const Code& code, bool built) {
  return {std::move(name),
          group,
          std::string(codeClassName(code.cls)),
          std::string(statusOf(code.cls, built)),
          std::string(code.ids),
          std::string(code.meaning)};
}

std::vector<CoverageRow> coverage() {
  std::vector<CoverageRow> rows;
  const CodeIndex& codes = nctCodes();
  for (const GCode* g : codes.allG()) {
    std::string name = fmt::format("G{}", g->code10 / 10);
    if (g->code10 % 10 != 0) name += fmt::format(".{}", g->code10 % 10);
    rows.push_back(coverageRow(std::move(name), g->group, *g, g->built));
  }
  for (const MCode* m : codes.allM()) rows.push_back(coverageRow(fmt::format("M{}", m->code), -1, *m, true));
  for (const FeatureRow* f : codes.allFeatures())
    rows.push_back(coverageRow(std::string(f->code), -1, *f, f->built));
  return rows;
}

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
