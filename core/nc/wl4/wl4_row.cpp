#include "core/nc/wl4/wl4_row.h"

#include "core/nc/specification/specification_text.h"
#include "core/nc/wl4/wl4_codes.h"
#include "core/nc/wl4/wl4_control.h"

namespace proveout::nc {
namespace {

template <bool kLathe>
InterpretSummary run(const ProgramSource& source, const ControlSettings& settings, MotionSink& sink,
                     Progress* progress, const ControlHost& host) {
  return Wl4Control(kLathe, source, settings, sink, progress, host).run();
}

template <bool kLathe>
std::vector<ParameterInfo> parameters() {
  return wl4ParameterTable(kLathe);
}

}  // namespace

const ControlRow& wl4MillRow() {
  static const ControlRow kRow{
      .id = ControlId::kWl4Mill,
      .name = "wl4-mill",
      .summary = "WL4, milling",
      .process = ProcessKind::kMilling,
      .manual = {"wl4", specification_text::kWl4},
      .run = run<false>,
      .coverage = wl4Coverage,
      .coverage_ids = wl4CoverageIds,
      .parameters = parameters<false>,
  };
  return kRow;
}

const ControlRow& wl4LatheRow() {
  static const ControlRow kRow{
      .id = ControlId::kWl4Lathe,
      .name = "wl4-lathe",
      .summary = "WL4, turning",
      .process = ProcessKind::kTurning,
      .manual = {"wl4", specification_text::kWl4},
      .run = run<true>,
      .coverage = wl4Coverage,
      .coverage_ids = wl4CoverageIds,
      .parameters = parameters<true>,
  };
  return kRow;
}

}  // namespace proveout::nc
