// What the files of a LinuxCNC machine and the job's texts make of the settings of a run.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/nc/control/control_row.h"
#include "core/nc/control/control_settings.h"
#include "core/nc/linuxcnc/files/lcn_ini.h"
#include "core/nc/linuxcnc/files/lcn_tool_table.h"

namespace proveout::nc {

/// The settings of `[control.linuxcnc]` that are no numbers.
std::span<const TextSetting> linuxCncTexts();

/// A code that stands for a subroutine.
struct LcnRemap {
  std::string sub;      ///< name of its file without extension, small letters
  bool python = false;  ///< it, or what runs before or behind it, is Python
};

/// What the files say beside the settings of the family.
struct LcnMachine {
  LcnIni ini;
  std::vector<LcnTool> tools;
  bool has_tools = false;                    ///< the job names a tool table
  bool changes_with_spindle_on = false;      ///< M6 does not stop the spindle
  std::vector<std::pair<int, double>> kept;  ///< of the .var file, machine units
  std::map<std::string, LcnRemap> remaps;    ///< by code: "M6", "G84.2"
  std::map<std::string, double> inputs;      ///< answers of M66: "P0", "E1"
  std::map<std::string, double> pins;        ///< #<_hal[pin]>, small letters
  std::vector<std::string> startup;          ///< lines that run in front of the program
  bool keeps_length = true;                  ///< features: the offset stays at M6
  std::vector<std::string> faults;           ///< of the texts: "tool_table: line 3: .."
};
LcnMachine readLcnMachine(const ControlSettings& settings);

/// Letters A, B, C that stand as words in a program: "AC".
std::string lcnRotaryWords(std::string_view program);

/// The setting under which a run is told of axes that only the program names.
inline constexpr const char* kLcnAssumedAxes = "assumed_axes";

/// The settings with what the INI file and `axes` say, where the job does not say it itself: units, axes,
/// limits of travel, tolerance of arcs, lathe.
/// `program`: the text of the main program. Its rotary axes are A, B, C turning the part, where neither job
/// nor machine name any axis beside X, Y, Z.
ControlSettings withLcnMachine(const ControlSettings& settings, std::string_view program);

}  // namespace proveout::nc
