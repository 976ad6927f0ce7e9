// One control in the list of controls: what it is and everything that it can be asked for.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/nc/control/channel_program.h"
#include "core/nc/control/control_host.h"
#include "core/nc/control/control_info.h"
#include "core/nc/control/control_settings.h"
#include "core/nc/control/program_source.h"
#include "core/nc/control/run_summary.h"
#include "core/nc/control/text_settings.h"
#include "core/path/toolpath.h"

namespace proveout::nc {

/// What a control's manual asks for: a line a chapter, "4.3 SIM G2 G3"; see core/nc/specification.
struct ManualRows {
  std::string_view prefix;  ///< of the ids: "nct" in "nct-4.3-G2"
  std::string_view text;    ///< empty: the control has no manual
};

/// A control that is known but not built has nothing behind `manual`. What is null the control does not have.
struct ControlRow {
  ControlId id;
  std::string_view name;     ///< "nct", "wl4-mill", ...
  std::string_view summary;  ///< one line for people
  ProcessKind process = ProcessKind::kMilling;
  ManualRows manual = {};

  std::string_view settings_table = {};  ///< `[control.NAME]` of a job; empty: the control's own name
  bool axis_events = false;              ///< it has the events and drives of ControlSettings

  /// See interpret() and interpretChannels().
  InterpretSummary (*run)(const ProgramSource&, const ControlSettings&, MotionSink&, Progress*,
                          const ControlHost&) = nullptr;
  InterpretSummary (*run_channels)(const std::vector<ChannelProgram>&, MotionSink&, Progress*,
                                   const ControlHost&) = nullptr;
  /// What executes, and the manual's rows with what proves them.
  std::vector<CoverageRow> (*coverage)() = nullptr;
  std::vector<CoverageIdRow> (*coverage_ids)() = nullptr;
  /// Why rows are open, by id.
  std::map<std::string, std::string_view> (*open_reasons)() = nullptr;
  std::vector<ParameterInfo> (*parameters)() = nullptr;
  std::span<const TextSetting> texts = {};  ///< settings that are no numbers
  /// Whether values of these parameters limit the travel of an axis.
  bool (*limits_travel)(const std::map<std::string, double>&) = nullptr;
};

}  // namespace proveout::nc
