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
    // lcn-4-G71
    {"A and C between the motions, and D",
     "G18 G8\nG0 X40 Z5\no100 sub\nG0 X10 Z0\nG1 X14 C1\nZ-10 A2\nX24\nZ-20 C0.5\nX30\no100 endsub\nG71 Q100 "
     "X30 Z2 D0.5 I5 R1",
     {"R 40 0 5",
      "R 30 0 2",
      "F 30 0 -19.5",
      "R 31 0 -18.5",
      "R 31 0 1",
      "R 30 0 2",
      "R 25 0 1.625",
      "F 25 0 -19.5",
      "R 26 0 -18.5",
      "R 26 0 0.625",
      "R 25 0 1.625",
      "R 20 0 1.25",
      "F 20 0 -9.5",
      "R 21 0 -8.5",
      "R 21 0 0.25",
      "R 20 0 1.25",
      "R 15 0 0.875",
      "F 15 0 -9.118",
      "R 16 0 -8.118",
      "R 16 0 -0.125",
      "R 15 0 0.875",
      "R 10 0 0.5",
      "F 13 0 0.5",
      "A 13.3536 0 0.3536 c 13 0 0",
      "F 14.3536 0 -0.6464",
      "A 14.5 0 -1 c 14 0 -1",
      "F 14.5 0 -8",
      "A 16 0 -9.5 c 16 0 -8",
      "F 24 0 -9.5",
      "A 24.5 0 -10 c 24 0 -10",
      "F 24.5 0 -19.2929",
      "F 24.7071 0 -19.5",
      "F 30 0 -19.5"}},
    // lcn-4-G70
    {"U, W, formulas and O-words in the contour, by diameters",
     "G18 G7\nG0 X60 Z5\no100 sub\n#1=10\no101 if [#1 GT 5]\nG1 X[#1*2] Z0\no101 else\nG1 X3 Z0\no101 "
     "endif\no102 repeat [2]\nW-5\nU4\no102 endrepeat\nX50 Z[#<_z>-5]\no100 endsub\nG70 Q100 X60 Z2",
     {"R 30 0 5", "R 30 0 2", "R 10 0 0", "F 10 0 -5", "F 12 0 -5", "F 12 0 -10", "F 14 0 -10",
      "F 25 0 -15"}},
    // lcn-4-G71
    {"an incremental contour",
     "G18 G8\nG0 X40 Z5\no100 sub\nG0 X-20 Z-2\nG1 Z-5\nX4 Z-4\nG2 X3 Z-3 I3 K0\nG1 X13\no100 endsub\nG0 X30 "
     "Z2\nG91 G71 Q100 I6 R1\nG90 Z5",
     {"R 40 0 5",   "R 30 0 2",   "F 30 0 -12", "R 31 0 -11", "R 31 0 1",
      "R 30 0 2",   "R 24 0 1.4", "F 24 0 -12", "R 25 0 -11", "R 25 0 0.4",
      "R 24 0 1.4", "R 18 0 0.8", "F 18 0 -12", "R 19 0 -11", "R 19 0 -0.2",
      "R 18 0 0.8", "R 12 0 0.2", "F 12 0 -7",  "R 13 0 -6",  "R 13 0 -0.8",
      "R 12 0 0.2", "R 10 0 0",   "F 10 0 -5",  "F 14 0 -9",  "A 17 0 -12 c 17 0 -9",
      "F 30 0 -12", "F 30 0 5"}},
    // lcn-4-G70
    {"passes with arcs about corners",
     "G18 G8\nG0 X40 Z5\no100 sub\nG0 X10 Z0\nG1 X16\nG3 X20 Z-4 I0 K-4\nG1 Z-10\nX30\no100 endsub\nG70 Q100 "
     "X30 Z2 D1 E0.2 P2",
     {"R 40 0 5", "R 30 0 2", "R 10 0 0.6", "F 16 0 0.6", "A 20.6 0 -4 c 16 0 -4", "F 20.6 0 -9.4",
      "F 30 0 -9.4", "R 30 0 2", "R 10 0 0.2", "F 16 0 0.2", "A 20.2 0 -4 c 16 0 -4", "F 20.2 0 -9.8",
      "F 30 0 -9.8"}},
    // lcn-4-G72
    {"pockets alone, in the face",
     "G18 G8\nG0 X40 Z5\no100 sub\nG0 X30 Z-3\nG1 X24 Z-6\nX20 Z-6\nX18 Z-1\nX12\nX10 Z-8\nX6\nZ0\no100 "
     "endsub\nG72.2 Q100 X32 Z2 I2 R0.5",
     {"R 40 0 5",       "R 32 0 2",       "R 30 0 -3", "F 24 0 -6",    "F 20 0 -6",
      "F 18 0 -1",      "F 12 0 -1",      "F 6 0 -1",  "R 6.5 0 -0.5", "R 11.5 0 -0.5",
      "F 12 0 -1",      "F 11.4286 0 -3", "F 6 0 -3",  "R 6.5 0 -2.5", "R 10.9286 0 -2.5",
      "F 11.4286 0 -3", "F 10.8571 0 -5", "F 6 0 -5",  "R 6.5 0 -4.5", "R 10.3571 0 -4.5",
      "F 10.8571 0 -5", "F 10.2857 0 -7", "F 6 0 -7",  "R 6.5 0 -6.5", "R 9.7857 0 -6.5",
      "F 10.2857 0 -7", "F 10 0 -8",      "F 6 0 -8",  "F 6 0 0",      "F 6 0 2"}},
    // lcn-4-G71
    {"pockets alone",
     "G18 G8\nG0 X40 Z5\no100 sub\nG0 X10 Z0\nG1 Z-5\nX4 Z-8\nZ-12\nX14\nZ-15\nG2 X14 Z-21 I4 K-3\nG1 "
     "Z-24\nX20\no100 endsub\nG71.2 Q100 X20 Z2 I3 R1",
     {"R 40 0 5",   "R 20 0 2",
      "R 10 0 0",   "F 10 0 -5",
      "F 10 0 -12", "R 11 0 -11",
      "R 11 0 -6",  "F 10 0 -5",
      "F 7 0 -6.5", "F 7 0 -12",
      "R 8 0 -11",  "R 8 0 -7.5",
      "F 7 0 -6.5", "F 4 0 -8",
      "F 4 0 -12",  "F 14 0 -12",
      "F 14 0 -15", "F 14 0 -21",
      "R 15 0 -20", "R 15 0 -16",
      "F 14 0 -15", "A 14 0 -21 c 18 0 -18",
      "F 14 0 -24", "F 20 0 -24"}},
    // lcn-4-G71
    {"pockets in levels",
     "G18 G8\nG0 X40 Z5\no100 sub\nG0 X10 Z0\nG1 Z-5\nX4 Z-8\nZ-12\nX14\nZ-15\nG2 X14 Z-21 I4 K-3\nG1 "
     "Z-24\nX20\no100 endsub\nG71 Q100 X20 Z2 I3 R1",
     {"R 40 0 5",   "R 20 0 2",    "F 20 0 -24",  "R 21 0 -23", "R 21 0 1",   "R 20 0 2",
      "R 17 0 1.4", "F 17 0 -24",  "R 18 0 -23",  "R 18 0 0.4", "R 17 0 1.4", "R 14 0 0.8",
      "F 14 0 -12", "R 15 0 -11",  "R 15 0 -0.2", "R 14 0 0.8", "R 11 0 0.2", "F 11 0 -12",
      "R 12 0 -11", "R 12 0 -0.8", "R 11 0 0.2",  "R 10 0 0",   "F 10 0 -5",  "F 8 0 -6",
      "F 8 0 -12",  "R 9 0 -11",   "R 9 0 -7",    "F 8 0 -6",   "F 5 0 -7.5", "F 5 0 -12",
      "R 6 0 -11",  "R 6 0 -8.5",  "F 5 0 -7.5",  "F 4 0 -8",   "F 4 0 -12",  "F 14 0 -12",
      "F 14 0 -15", "F 14 0 -21",  "R 15 0 -20",  "R 15 0 -16", "F 14 0 -15", "A 14 0 -21 c 18 0 -18",
      "F 14 0 -24", "F 20 0 -24"}},
    // lcn-4-G71
    {"pockets left, inside, with D",
     "G18 G8\nG0 X5 Z5\no100 sub\nG0 X20 Z0\nG1 Z-5\nX24 Z-7\nZ-9\nX16\nZ-12\nX10\no100 endsub\nG71.1 Q100 "
     "X8 Z2 D0.3 I4 R1",
     {"R 5 0 5",        "R 8 0 2",       "F 8 0 -11.7",
      "R 7 0 -10.7",    "R 7 0 1",       "R 8 0 2",
      "R 12 0 1.3162",  "F 12 0 -11.7",  "R 11 0 -10.7",
      "R 11 0 0.3162",  "R 12 0 1.3162", "R 16 0 0.6325",
      "F 16 0 -8.7",    "R 15 0 -7.7",   "R 15 0 -0.3675",
      "R 16 0 0.6325",  "R 19.7 0 0",    "F 19.7 0 -5",
      "F 19.7 0 -8.7",  "F 16 0 -8.7",   "A 15.7 0 -9 c 16 0 -9",
      "F 15.7 0 -11.7", "F 10 0 -11.7",  "F 8 0 -11.7"}},
    // lcn-4-G71
    {"pockets left",
     "G18 G8\nG0 X40 Z5\no100 sub\nG0 X10 Z0\nG1 Z-5\nX4 Z-8\nZ-12\nX14\nZ-15\nG2 X14 Z-21 I4 K-3\nG1 "
     "Z-24\nX20\no100 endsub\nG71.1 Q100 X20 Z2 I3 R1",
     {"R 40 0 5",   "R 20 0 2",    "F 20 0 -24",  "R 21 0 -23", "R 21 0 1",   "R 20 0 2",
      "R 17 0 1.4", "F 17 0 -24",  "R 18 0 -23",  "R 18 0 0.4", "R 17 0 1.4", "R 14 0 0.8",
      "F 14 0 -12", "R 15 0 -11",  "R 15 0 -0.2", "R 14 0 0.8", "R 11 0 0.2", "F 11 0 -12",
      "R 12 0 -11", "R 12 0 -0.8", "R 11 0 0.2",  "R 10 0 0",   "F 10 0 -5",  "F 10 0 -12",
      "F 14 0 -12", "F 14 0 -15",  "F 14 0 -21",  "F 14 0 -24", "F 20 0 -24"}},
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
  const std::string back =
      "G18 G8\nG0 X40 Z5\no100 sub\nG0 X10 Z0\nG1 Z-10\nX12 Z-8\nX20 Z-15\no100 endsub\n";
  EXPECT_EQ(runLcn(back + "G71 Q100").error(), "linuxcnc-profile");
  EXPECT_EQ(runLcn(contour + "G71 Q100 I.00001").error(), "linuxcnc-out-of-range");
}

// lcn-4-G70 lcn-4-G71
TEST(LinuxCncRough, TellsWhatIsWrongInTheContour) {
  for (const auto& [lines, why] :
       std::vector<std::pair<std::string, std::string>>{{"G1 Z-10 A2 C2\nX20", "Both A and C"},
                                                        {"G1 Z-10 A20\nX20", "Corner finish failed"},
                                                        {"G1 Z-10 U3 X12", "Cannot use U and X"},
                                                        {"G2 X20 Z-10 R-12", "R above 0"},
                                                        {"G2 X20 Z-10", "either I or K"},
                                                        {"G2 X20 Z-10 R11 I3", "both R and I or K"},
                                                        {"G2 X20 Z-10 I3 K-10", "differs from radius"},
                                                        {"G33 Z-10 K1", "G0 to G3 alone"},
                                                        {"A2", "need a motion"}}) {
    const IsoRun run = runLcn("G18 G8\nG0 X40 Z5\no100 sub\nG0 X10 Z0\n" + lines + "\no100 endsub\nG71 Q100");
    EXPECT_EQ(run.error(), "linuxcnc-profile") << lines;
    EXPECT_NE(run.message().find(why), std::string::npos) << lines << ": " << run.message();
  }
  EXPECT_EQ(runLcn("G18\no100 sub\nG0 X1 Z0\nG1 U3\no100 endsub\nG91 G71 Q100 X30 Z2").error(),
            "linuxcnc-profile");
  const IsoRun noted = runLcn("G18\no100 sub\nG0 X1 Z0 F20 M8\nG90 G1 Z-3\nX9\no100 endsub\nG71 Q100 X9 Z2");
  EXPECT_EQ(noted.error(), "");
  EXPECT_TRUE(noted.tells("linuxcnc-profile"));
}

// lcn-4-G70: compensation begins with the way to the contour; lcn-4-orient.
TEST(LinuxCncRough, FinishesWithCompensation) {
  const std::string contour = "G18 G8\nG0 X40 Z5\no100 sub\nG0 X10 Z0\nG1 Z-10\nX20\no100 endsub\n";
  const IsoRun run = runLcn(contour + "G42.1 D2\nG70 Q100 X30 Z2\nG40 G0 X40");
  EXPECT_EQ(run.error(), "") << run.message();
  const IsoRun by_hand = runLcn(contour + "G0 X30 Z2\nG42.1 D2\nG0 X10 Z0\nG1 Z-10\nX20\nG40 G0 X40");
  EXPECT_EQ(run.motions(), by_hand.motions());
  const IsoRun passes = runLcn(contour + "G42.1 D2\nG70 Q100 X30 Z2 D1 P2\nG40 G0 X40");
  const IsoRun twice = runLcn(contour +
                              "G0 X30 Z2\nG42.1 D2\nG0 X10.5 Z0\nG1 Z-9.5\nX20\nG40 G0 X30 Z2\nG42.1 D2\n"
                              "G0 X10 Z0\nG1 Z-10\nX20\nG40 G0 X40");
  EXPECT_EQ(passes.error(), "") << passes.message();
  EXPECT_EQ(passes.motions(), twice.motions());
  EXPECT_EQ(runLcn(contour + "G42.1 D2\nG71 Q100 X30 Z2").error(), "linuxcnc-comp");
}

// lcn-4-G70: the last motion of the cycle goes on; the sub may lie anywhere, and is run once a cycle.
TEST(LinuxCncRough, GoesOnBehindTheCycle) {
  const IsoRun run = runLcn(
      "G18 G8\n#100=0\nG71 Q100 X14 Z2 I4 R1\nX30\n(debug,#100)\nM2\no100 sub\n#100=[#100+1]\n"
      "G0 X10 Z0\nG1 Z-10 C0.5\nX14\no100 endsub");
  EXPECT_EQ(run.error(), "") << run.message();
  EXPECT_EQ(run.motions().back(), "F 30 0 -10");
  EXPECT_TRUE(run.path.diagnostics.all().empty()) << run.path.diagnostics.all().front().message;
  bool told = false;
  for (const auto& [before, e] : run.path.events)
    if (const auto* message = e.as<event::Message>()) told = told || message->text == "1.000000";
  EXPECT_TRUE(told);
}

// lcn-4-G71: a contour that ends as deep as it begins is cut from where the tool is (rs274 follows it at
// once).
TEST(LinuxCncRough, CutsFromWhereTheToolIs) {
  const IsoRun run =
      runLcn("G18 G8\nG0 X40 Z5\no100 sub\nG0 X10 Z0\nG1 Z-10\no100 endsub\nG71 Q100 X16 Z2 I4");
  EXPECT_EQ(run.error(), "") << run.message();
  EXPECT_EQ(run.motions()[2], "F 16 0 -10");
  EXPECT_EQ(run.motions().back(), "F 16 0 -10");
}

// lcn-3-arctol: arcs of contours have the tolerance of the program's units, as all arcs.
TEST(LinuxCncRough, ArcsInInchesHaveTheirOwnTolerance) {
  const auto run = [](const char* centre) {
    return runLcn(std::string("G20 G18 G8\nG0 X4 Z1\no100 sub\nG0 X1 Z0\nG1 Z-1\nG2 X2 Z-2 I") + centre +
                  " K0\nG1 X3\no100 endsub\nG71 Q100 X4 Z1 D0 I0.5 R0.1");
  };
  EXPECT_EQ(run("1.0018").error(), "");
  EXPECT_EQ(run("1.01").error(), "linuxcnc-profile");
}

}  // namespace
}  // namespace proveout::test
