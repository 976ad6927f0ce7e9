// Entry point of the virtual controls: program text in, motions and events out.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/nc/control_host.h"
#include "core/nc/control_settings.h"
#include "core/nc/program_source.h"
#include "core/path/toolpath.h"

namespace proveout {

enum class ControlId { kNct, kWl4Mill, kWl4Lathe, kFlexNc, kWedm, kRs274Ngc };

struct ControlInfo {
  ControlId id;
  std::string_view name;     ///< "nct", "wl4-mill", ...
  std::string_view summary;  ///< one line for people
  bool built;                ///< false: known, but this version cannot run it
  bool turns = false;        ///< the part turns about Z: X of the path is a radius
};
/// All controls that the program knows by name.
const std::vector<ControlInfo>& controls();
/// The control of that name. Error: unknown name (lists the known ones) or a control that is not built yet.
Result<ControlId> findControl(std::string_view name);

/// How interpretation ended.
enum class ProgramEnd {
  kEndOfProgram,  ///< M2, M30, or the end of the main program's text
  kUntil,         ///< settings.until reached
  kAlarm,         ///< an error of the program
  kBlockLimit,    ///< settings.block_limit reached; also reported as an error
  kCancelled,     ///< progress.cancel()
};

struct InterpretSummary {
  ProgramEnd end = ProgramEnd::kEndOfProgram;
  std::uint64_t blocks = 0;   ///< executed blocks
  std::uint64_t motions = 0;  ///< motions sent to the sink
  int errors = 0;
  int warnings = 0;
  double cycle_s = 0.0;    ///< everything: motions, dwells, tool changes
  double cutting_s = 0.0;  ///< feed motions
  double rapid_s = 0.0;    ///< rapid motions
  bool ok() const { return errors == 0 && end != ProgramEnd::kCancelled; }
};

/// Runs the main program of `source` once. Everything goes to `sink` in program order, diagnostics too
/// (bad settings are diagnostics without a place). Never throws for bad input. `progress` may be null. What
/// `host` points to must live as long as the call.
InterpretSummary interpret(ControlId control, const ProgramSource& source, const ControlSettings& settings,
                           MotionSink& sink, Progress* progress = nullptr, const ControlHost& host = {});

inline constexpr int kMaxChannels = 8;

/// What one channel of a control runs.
struct ChannelProgram {
  const ProgramSource* source = nullptr;  ///< its main program and what that calls
  /// With the channel's number, 1 to kMaxChannels. Parameters that belong to the whole control are those of
  /// the first channel.
  ControlSettings settings;
};

/// Runs the programs of several channels together, in the order of simulated time, as interpret() does for
/// one. The sink gets one path in order of start times. An error in a channel stops all at its time; so does
/// `until`, where the first channel has it. Cycle time is the end of the last channel; the other times are
/// sums. Errors: no channel, too many, or two of one number.
InterpretSummary interpretChannels(ControlId control, const std::vector<ChannelProgram>& channels,
                                   MotionSink& sink, Progress* progress = nullptr,
                                   const ControlHost& host = {});

/// One row of what a control supports, taken from the tables that execute.
struct CoverageRow {
  std::string code;     ///< "G2", "M98", "F"
  int group = -1;       ///< modal group, 0 one-shot, -1 none
  std::string cls;      ///< "SIM", "TIME", "STATE", "HOST", "REJECT"
  std::string status;   ///< "simulated", "timed", "tracked", "noted", "refused"
  std::string ids;      ///< coverage ids that it serves, separated by blanks
  std::string meaning;  ///< one line
};
/// Error: the control is not built.
Result<std::vector<CoverageRow>> coverageTable(ControlId control);

/// A parameter that ControlSettings::parameters may set.
struct ParameterInfo {
  std::string_view name;
  double default_value;
  double min, max;
  std::string_view meaning;
  int count = 0;  ///< > 0: axis or spindle parameter; NAME.1 to NAME.count, NAME alone means all
};
std::vector<ParameterInfo> parameterTable(ControlId control);

}  // namespace proveout
