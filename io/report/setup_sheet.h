// What a clamping needs, for the person at the machine. Lengths mm.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace proveout {

struct SheetTool {
  int number = 0;
  std::string name;         ///< may be empty
  std::string description;  ///< "ball 3.175", may be empty
  std::optional<double> stick_out;
  std::string length_offset;  ///< "H1 = 52.300"; empty: the program calls none
  std::string radius_offset;  ///< "D1 = 5.000"; empty: the program calls none
};

/// A line of facts: "Blank", "box 80 x 60 x 20, X0.000..80.000 ...".
struct SheetLine {
  std::string label, text;
};

struct SetupSheet {
  std::string setup;    ///< name of the clamping; empty in a job without setups
  std::string program;  ///< name of its main program
  std::vector<SheetLine> lines;
  std::vector<SheetTool> tools;  ///< that the program uses, in the order of their first use
  /// Bytes of PNG files: the workpiece as it is clamped, with fixtures and zero points, and as it is when the
  /// program has run. Empty: there is none.
  std::string before, after;
};

}  // namespace proveout
