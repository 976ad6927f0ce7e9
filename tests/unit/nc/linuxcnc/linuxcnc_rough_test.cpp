// Roughing and finishing of LinuxCNC along a contour, against rs274 (2.9).
#include <gtest/gtest.h>

#include "tests/unit/nc/linuxcnc/linuxcnc_cases.h"

namespace proveout::test {
namespace {

// clang-format off: one case a row
struct LcnRoughCase {
  std::string name, text;
  std::vector<std::string> motions;
};
const std::vector<LcnRoughCase> kLcnRoughCases{
    // lcn-4-G71
    {"G71 outside",
     "G18 G8\nG0 X40 Z5\no100 sub\nG0 X10 Z0\nG1 Z-10\nX20 Z-20\nX30\no100 endsub\nG71 Q100 X30 Z2 D1 I4 R1",
     {"R 40 0 5",      "R 30 0 2",      "F 30 0 -19",      "R 31 0 -18",      "R 31 0 1",
      "R 30 0 2",      "R 26 0 1.5789", "F 26 0 -19",      "R 27 0 -18",      "R 27 0 0.5789",
      "R 26 0 1.5789", "R 22 0 1.1579", "F 22 0 -19",      "R 23 0 -18",      "R 23 0 0.1579",
      "R 22 0 1.1579", "R 18 0 0.7368", "F 18 0 -16.5858", "R 19 0 -15.5858", "R 19 0 -0.2632",
      "R 18 0 0.7368", "R 14 0 0.3158", "F 14 0 -12.5858", "R 15 0 -11.5858", "R 15 0 -0.6842",
      "R 14 0 0.3158", "R 11 0 0",      "F 11 0 -9.5858",  "F 20.4142 0 -19", "F 30 0 -19"}},
    // lcn-4-G70
    {"G70",
     "G18 G8\nG0 X40 Z5\no100 sub\nG0 X10 Z0\nG1 Z-10\nX20 Z-20\nX30\no100 endsub\nG70 Q100 X30 Z2",
     {"R 40 0 5", "R 30 0 2", "R 10 0 0", "F 10 0 -10", "F 20 0 -20", "F 30 0 -20"}},
    // lcn-4-G70
    {"G70 in passes",
     "G18 G8\nG0 X40 Z5\no100 sub\nG0 X10 Z0\nG1 Z-10\nX20 Z-20\nX30\no100 endsub\nG70 Q100 X30 Z2 D3 E1 P3",
     {"R 40 0 5", "R 30 0 2", "R 12.3333 0 0", "F 12.3333 0 -9.0335", "F 20.9665 0 -17.6667",
      "F 30 0 -17.6667", "R 30 0 2", "R 11.6667 0 0", "F 11.6667 0 -9.3096", "F 20.6904 0 -18.3333",
      "F 30 0 -18.3333", "R 30 0 2", "R 11 0 0", "F 11 0 -9.5858", "F 20.4142 0 -19", "F 30 0 -19"}},
    // lcn-4-G71
    {"G71 up to where the tool starts",
     "G18 G8\nG0 X40 Z5\no100 sub\nG0 X10 Z0\nG1 Z-10\nX20 Z-20\nX30\no100 endsub\nG71 Q100 I9",
     {"R 40 0 5",   "F 40 0 -20", "R 40.5 0 -19.5", "R 40.5 0 4.5", "R 40 0 5",
      "R 31 0 3.5", "F 31 0 -20", "R 31.5 0 -19.5", "R 31.5 0 3",   "R 31 0 3.5",
      "R 22 0 2",   "F 22 0 -20", "R 22.5 0 -19.5", "R 22.5 0 1.5", "R 22 0 2",
      "R 13 0 0.5", "F 13 0 -13", "R 13.5 0 -12.5", "R 13.5 0 0",   "R 13 0 0.5",
      "R 10 0 0",   "F 10 0 -10", "F 20 0 -20",     "F 30 0 -20",   "F 40 0 -20"}},
    // lcn-4-G71
    {"G71 inside, towards +Z",
     "G18 G8\nG0 X8 Z12\no100 sub\nG0 X30 Z-5\nG1 X25\nZ0\nX20 Z5\no100 endsub\nG71 Q100 X10 Z10 D0 I4 R1",
     {"R 8 0 12",  "R 10 0 10", "R 10 0 -5", "F 10 0 5",  "R 9 0 4",   "R 9 0 -4",  "R 10 0 -5",
      "R 14 0 -5", "F 14 0 5",  "R 13 0 4",  "R 13 0 -4", "R 14 0 -5", "R 18 0 -5", "F 18 0 5",
      "R 17 0 4",  "R 17 0 -4", "R 18 0 -5", "R 22 0 -5", "F 22 0 3",  "R 21 0 2",  "R 21 0 -4",
      "R 22 0 -5", "R 26 0 -5", "R 30 0 -5", "F 25 0 -5", "F 25 0 0",  "F 20 0 5",  "F 10 0 5"}},
    // lcn-4-G72
    {"G72 inwards",
     "G18 G8\nG0 X40 Z5\no100 sub\nG0 X30 Z-20\nG1 X20 Z-10\nX10 Z-5\nX0 Z0\no100 endsub\nG72 Q100 X35 Z2 D0 "
     "I5 R1",
     {"R 40 0 5",        "R 35 0 2",        "F 0 0 2",    "R 1 0 3",    "R 34 0 3",
      "R 35 0 2",        "R 33.8636 0 -3",  "F 6 0 -3",   "R 7 0 -2",   "R 32.8636 0 -2",
      "R 33.8636 0 -3",  "R 32.7273 0 -8",  "F 16 0 -8",  "R 17 0 -7",  "R 31.7273 0 -7",
      "R 32.7273 0 -8",  "R 31.5909 0 -13", "F 23 0 -13", "R 24 0 -12", "R 30.5909 0 -12",
      "R 31.5909 0 -13", "R 30.4545 0 -18", "F 28 0 -18", "R 29 0 -17", "R 29.4545 0 -17",
      "R 30.4545 0 -18", "R 30 0 -20",      "F 20 0 -10", "F 10 0 -5",  "F 0 0 0",
      "F 0 0 2"}},
    // lcn-4-G72
    {"G72 outwards",
     "G18 G8\nG0 X40 Z5\no100 sub\nG0 X10 Z-20\nG1 X15 Z-10\nX30 Z-5\nZ0\no100 endsub\nG72 Q100 X35 Z2 D0 I5 "
     "R1",
     {"R 40 0 5",       "R 35 0 2",     "R 10 0 2",   "F 30 0 2",   "R 29 0 3",   "R 11 0 3",
      "R 10 0 2",       "R 10 0 -3",    "F 30 0 -3",  "R 29 0 -2",  "R 11 0 -2",  "R 10 0 -3",
      "R 10 0 -8",      "F 21 0 -8",    "R 20 0 -7",  "R 11 0 -7",  "R 10 0 -8",  "R 10 0 -13",
      "F 13.5 0 -13",   "R 12.5 0 -12", "R 11 0 -12", "R 10 0 -13", "R 10 0 -18", "F 11 0 -18",
      "R 10.5 0 -17.5", "R 10 0 -18",   "R 10 0 -20", "F 15 0 -10", "F 30 0 -5",  "F 30 0 0",
      "F 30 0 2"}},
    // lcn-4-G71
    {"G71 by diameters, with an arc",
     "G18 G7\nG0 X40 Z5\no100 sub\nG0 X10 Z0\nG1 Z-10\nG2 X20 Z-15 I5 K0\nG1 Z-20\nX30\no100 endsub\nG71 "
     "Q100 X30 Z2 D0 I5",
     {"R 20 0 5", "R 15 0 2", "F 15 0 -20", "R 15.5 0 -19.5", "R 15.5 0 1.5", "R 15 0 2", "R 10 0 1",
      "F 10 0 -15", "R 10.5 0 -14.5", "R 10.5 0 0.5", "R 10 0 1", "R 5 0 0", "F 5 0 -10",
      "A 10 0 -15 c 10 0 -10", "F 10 0 -20", "F 15 0 -20"}},
    // lcn-4-G71
    {"a pocket that the last pass cuts",
     "G18 G8\nG0 X40 Z5\no100 sub\nG0 X10 Z0\nG1 Z-10\nX8 Z-12\nZ-15\nX20\nZ-20\nX30\no100 endsub\nG71 Q100 "
     "X30 Z2 D0 I8 R1",
     {"R 40 0 5",   "R 30 0 2",   "F 30 0 -20",  "R 31 0 -19", "R 31 0 1",   "R 30 0 2",
      "R 22 0 1.2", "F 22 0 -20", "R 23 0 -19",  "R 23 0 0.2", "R 22 0 1.2", "R 14 0 0.4",
      "F 14 0 -15", "R 15 0 -14", "R 15 0 -0.6", "R 14 0 0.4", "R 10 0 0",   "F 10 0 -10",
      "F 8 0 -12",  "F 8 0 -15",  "F 20 0 -15",  "F 20 0 -20", "F 30 0 -20"}},
};
// clang-format on

/// Without the sweep of arcs, which the interpreter does not print.
std::vector<std::string> withoutSweeps(std::vector<std::string> lines) {
  for (std::string& line : lines)
    if (line.starts_with("A ")) line.erase(line.rfind(' '));
  return lines;
}

TEST(LinuxCncRough, GoesWhereTheInterpreterGoes) {
  for (const LcnRoughCase& c : kLcnRoughCases) {
    const IsoRun run = runLcn(c.text);
    EXPECT_EQ(run.error(), "") << c.name << ": " << run.message();
    EXPECT_EQ(withoutSweeps(run.motions()), c.motions) << c.name;
  }
}

TEST(LinuxCncRough, RefusesWhatItCannotCut) {
  const std::string contour = "G18 G8\nG0 X40 Z5\no100 sub\nG0 X10 Z0\nG1 Z-10\nX20 Z-20\nX30\no100 endsub\n";
  for (const char* line :
       {"G71 X30 Z2", "G71 Q7", "G71 Q100 I0", "G71 Q100 I-1", "G17 G71 Q100", "G71 Q100 D-1"})
    EXPECT_EQ(runLcn(contour + line).error(), "linuxcnc-profile") << line;
  const std::string pocket =
      "G18 G8\nG0 X40 Z5\no100 sub\nG0 X10 Z0\nG1 Z-10\nX8 Z-12\nX20 Z-15\no100 endsub\n";
  EXPECT_EQ(runLcn(pocket + "G71.1 Q100").error(), "linuxcnc-profile");
  const std::string back =
      "G18 G8\nG0 X40 Z5\no100 sub\nG0 X10 Z0\nG1 Z-10\nX12 Z-8\nX20 Z-15\no100 endsub\n";
  EXPECT_EQ(runLcn(back + "G71 Q100").error(), "linuxcnc-profile");
  EXPECT_EQ(runLcn(contour + "G71 Q100 I.00001").error(), "linuxcnc-out-of-range");
}

}  // namespace
}  // namespace proveout::test
