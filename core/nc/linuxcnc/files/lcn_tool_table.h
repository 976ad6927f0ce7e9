// The tool table of LinuxCNC: a line a tool, "T1 P1 Z50 D10 ;drill".
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace proveout::nc {

/// Lengths mm, angles degrees. What a line does not give is 0 to the control.
struct LcnTool {
  int number = 0, pocket = 0;
  std::array<std::optional<double>, 9> offset;  ///< X Y Z A B C U V W
  std::optional<double> diameter, front, back;
  std::optional<int> orientation;  ///< 0 to 9
  std::string comment;
};

/// Reads the text of a table; `scale`: mm of a machine unit. Lines that are none are told in `faults`,
/// "line 3: ...".
std::vector<LcnTool> readLcnToolTable(std::string_view text, double scale, std::vector<std::string>& faults);

}  // namespace proveout::nc
