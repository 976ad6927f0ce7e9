// The virtual controls by name: what each supports.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/path/process_kind.h"

namespace proveout {

struct ControlSettings;

enum class ControlId { kNct, kWl4Mill, kWl4Lathe, kFlexNc, kWedm, kFanucMill, kFanucLathe, kLinuxCnc };

struct ControlInfo {
  ControlId id;
  std::string_view name;     ///< "nct", "wl4-mill", ...
  std::string_view summary;  ///< one line for people
  bool built;                ///< false: known, but this version cannot run it
  ProcessKind process = ProcessKind::kMilling;
  std::string_view settings_table;  ///< `[control.NAME]` of a job: several controls may share one
};
/// All controls that the program knows by name.
const std::vector<ControlInfo>& controls();
/// The control of that name. Error: unknown name (lists the known ones) or a control that is not built yet.
Result<ControlId> findControl(std::string_view name);

/// Names of the controls that this version runs.
std::vector<std::string> builtControlNames();

/// One row of what a control supports, taken from the tables that execute.
struct CoverageRow {
  std::string code;     ///< "G2", "M98", "F"
  int group = -1;       ///< modal group, 0 one-shot, -1 none
  std::string cls;      ///< "SIM", "TIME", "STATE", "HOST", "REJECT"
  std::string status;   ///< "simulated", "timed", "tracked", "noted", "refused"
  std::string ids;      ///< coverage ids that it serves, separated by blanks
  std::string meaning;  ///< one line
};
/// One row of the control's manual that is asked for.
struct CoverageIdRow {
  std::string_view id;      ///< "nct-4.3-G2"
  std::string_view cls;     ///< as in CoverageRow
  std::string_view status;  ///< "done", "partly", "missing", "deferred"
  std::string_view proof;   ///< the test that names it; empty: none
};
/// "simulated" of SIM, and so on: the status of a class.
std::string_view coverageStatus(std::string_view cls);
/// With the status of its class; what is not served is refused, whatever its class.
CoverageRow coverageRow(std::string code, int group, std::string_view cls, std::string_view ids,
                        std::string_view meaning, bool served = true);
/// Error: the control is not built.
Result<std::vector<CoverageRow>> coverageTable(ControlId control);

/// A parameter that ControlSettings::parameters may set.
struct ParameterInfo {
  std::string_view name;
  double default_value;
  double min, max;
  std::string_view meaning;
  int count = 0;  ///< > 0: axis or spindle parameter; NAME.1 to NAME.count, NAME alone means all
  std::string_view choices = {};  ///< words that a job gives in place of 0, 1, ..., separated by blanks
};
std::vector<ParameterInfo> parameterTable(ControlId control);

/// Whether the settings, or the control's own parameters among them, limit the travel of an axis.
bool limitsTravel(ControlId control, const ControlSettings& settings);

}  // namespace proveout
