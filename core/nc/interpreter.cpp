#include "core/nc/interpreter.h"

#include <fmt/core.h>

#include <algorithm>

#include "core/nc/nct/channels/channels.h"
#include "core/nc/nct/parameters/parameters.h"
#include "core/nc/nct/program/control.h"
#include "core/nc/nct/tables/codes.h"
#include "core/nc/wl4/wl4_codes.h"
#include "core/nc/wl4/wl4_control.h"

namespace proveout {
namespace {

std::string_view statusOf(nc::CodeClass cls, bool built) {
  if (!built) return "refused";
  switch (cls) {
    case nc::CodeClass::kSim:
      return "simulated";
    case nc::CodeClass::kTime:
      return "timed";
    case nc::CodeClass::kState:
      return "tracked";
    case nc::CodeClass::kHost:
      return "noted";
    case nc::CodeClass::kReject:
      return "checked";
  }
  return "refused";
}

std::vector<CoverageRow> nctCoverage() {
  std::vector<CoverageRow> rows;
  const nc::CodeIndex& codes = nc::nctCodes();
  for (const nc::GCode* g : codes.allG()) {
    std::string name = fmt::format("G{}", g->code10 / 10);
    if (g->code10 % 10 != 0) name += fmt::format(".{}", g->code10 % 10);
    rows.push_back({std::move(name), g->group, std::string(codeClassName(g->cls)),
                    std::string(statusOf(g->cls, g->built)), std::string(g->ids), std::string(g->meaning)});
  }
  for (const nc::MCode* m : codes.allM()) {
    rows.push_back({fmt::format("M{}", m->code), -1, std::string(codeClassName(m->cls)),
                    std::string(statusOf(m->cls, true)), std::string(m->ids), std::string(m->meaning)});
  }
  for (const nc::FeatureRow* f : codes.allFeatures()) {
    rows.push_back({std::string(f->code), -1, std::string(codeClassName(f->cls)),
                    std::string(statusOf(f->cls, f->built)), std::string(f->ids), std::string(f->meaning)});
  }
  return rows;
}

bool isWl4(ControlId control) { return control == ControlId::kWl4Mill || control == ControlId::kWl4Lathe; }

}  // namespace

const std::vector<ControlInfo>& controls() {
  static const std::vector<ControlInfo> kControls{
      {ControlId::kNct, "nct", "NCT 2xx/3xx, milling channel", true},
      {ControlId::kWl4Mill, "wl4-mill", "WL4, milling", true},
      {ControlId::kWl4Lathe, "wl4-lathe", "WL4, turning", true, ProcessKind::kTurning},
      {ControlId::kFlexNc, "flexnc", "FlexNC, milling", false},
      {ControlId::kWedm, "wedm", "wire EDM", false},
      {ControlId::kRs274Ngc, "rs274ngc", "RS274/NGC, milling", false},
  };
  return kControls;
}

Result<ControlId> findControl(std::string_view name) {
  std::string known;
  for (const ControlInfo& control : controls()) {
    if (control.name == name) {
      if (control.built) return control.id;
      return inputError(fmt::format("control {} is known but this version cannot run it yet", name));
    }
    known += (known.empty() ? "" : ", ") + std::string(control.name);
  }
  return inputError(fmt::format("unknown control {} (known: {})", name, known));
}

namespace {

InterpretSummary refused(MotionSink& sink, const char* why) {
  InterpretSummary summary;
  summary.end = ProgramEnd::kAlarm;
  summary.errors = 1;
  sink.diagnostic({Severity::kError, "control", why, {}, {}, {}});
  return summary;
}

}  // namespace

InterpretSummary interpret(ControlId control, const ProgramSource& source, const ControlSettings& settings,
                           MotionSink& sink, Progress* progress, const ControlHost& host) {
  if (isWl4(control)) {
    return nc::Wl4Control(control == ControlId::kWl4Lathe, source, settings, sink, progress, host).run();
  }
  if (control != ControlId::kNct)
    return refused(sink, "this control is known but this version cannot run it yet");
  return nc::NctControl(source, settings, sink, progress, host).run();
}

InterpretSummary interpretChannels(ControlId control, const std::vector<ChannelProgram>& channels,
                                   MotionSink& sink, Progress* progress, const ControlHost& host) {
  if (control != ControlId::kNct) return refused(sink, "this control has no channels");
  return nc::NctChannels(channels, sink, progress, host).run();
}

Result<std::vector<CoverageRow>> coverageTable(ControlId control) {
  if (control == ControlId::kNct) return nctCoverage();
  if (isWl4(control)) return nc::wl4Coverage();
  return inputError("this control is known but this version cannot run it yet");
}

std::vector<ParameterInfo> parameterTable(ControlId control) {
  if (isWl4(control)) return nc::wl4ParameterTable(control == ControlId::kWl4Lathe);
  if (control != ControlId::kNct) return {};
  return nc::nctParameterTable();
}

bool limitsTravel(ControlId control, const ControlSettings& settings) {
  const auto& limits = settings.limits;
  if (std::any_of(limits.begin(), limits.end(), [](const auto& limit) { return limit.has_value(); }))
    return true;
  return control == ControlId::kNct && nc::givesStroke(settings.parameters);
}

}  // namespace proveout
