// What is wrong with a turned part is told at the block and the datum that is wrong; right programs are
// quiet.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "program_runner.h"

namespace proveout::test {
namespace {

using nlohmann::json;

/// A corner insert with its holder.
std::string corner(int number, double radius, int angle, int edge,
                   const std::string& more = "orientation = 3\n") {
  std::ostringstream out;
  out << "[[tool]]\nnumber = " << number << "\ntype = \"insert\"\nnose_radius = " << radius
      << "\ninsert_angle = " << angle << "\nlead_angle = 93\nedge_length = " << edge << "\n"
      << more;
  return out.str();
}
const std::string kOutside = "orientation = 3\nholder = [[10, 2], [90, 2], [90, 22], [10, 22]]\n";
const std::string kGauged = kOutside + "gauge = [50, 30]\n";

/// 1 roughing, 2 finishing, 3 blade of 4, 4 thread, 5 blade for parting, 6 boring bar, 7 button, 8 a tool
/// that stands behind the part, 9 drill, 10 a slim insert.
std::string tools(const std::string& finishing = kOutside) {
  return corner(1, 0.8, 55, 15, "orientation = 3\nholder = [[14, 2], [90, 2], [90, 27], [14, 27]]\n") +
         corner(2, 0.4, 55, 11, finishing) +
         "[[tool]]\nnumber = 3\ntype = \"insert\"\nshape = \"groove\"\nwidth = 4\nnose_radius = 0.2\n"
         "orientation = 3\nedge_length = 12\nside_relief = 1\n"
         "holder = [[12, 0.5], [90, 0.5], [90, 25], [12, 25]]\n"
         "[[tool]]\nnumber = 4\ntype = \"insert\"\nshape = \"thread\"\ninsert_angle = 60\ntip_flat = 0.2\n"
         "orientation = 8\nedge_length = 2.2\nholder = [[2.2, -1.4], [90, -1.4], [90, 18], [2.2, 18]]\n"
         "[[tool]]\nnumber = 5\ntype = \"insert\"\nshape = \"groove\"\nwidth = 3\nnose_radius = 0.1\n"
         "orientation = 3\nedge_length = 30\nside_relief = 0.5\n"
         "holder = [[30, 0.5], [90, 0.5], [90, 20], [30, 20]]\n" +
         corner(6, 0.4, 55, 5, "orientation = 2\nholder = [[-9, 1], [-3, 1], [-3, 60], [-9, 60]]\n") +
         "[[tool]]\nnumber = 7\ntype = \"insert\"\nshape = \"round\"\nnose_radius = 3\norientation = 8\n"
         "holder = [[6.5, -2], [80, -2], [80, 18], [6.5, 18]]\n" +
         corner(8, 0.4, 55, 11, "orientation = 2\nholder = [[-90, 2], [-10, 2], [-10, 22], [-90, 22]]\n") +
         "[[tool]]\nnumber = 9\ntype = \"drill\"\ndiameter = 20\n" + corner(10, 0.4, 35, 11, kOutside);
}

using Data = std::map<std::string, double>;

/// A bar of 50 with what the operator has entered; `changed` replaces single data, NaN leaves them out.
std::string job(const Data& changed, const std::string& finishing, const std::string& more) {
  Data data = {{"RT.1", 0.8}, {"TIP.1", 3},  {"RT.2", 0.4},  {"TIP.2", 3}, {"RT.3", 0.2},
               {"TIP.3", 3},  {"RT.6", 0.4}, {"TIP.6", 2},   {"RT.7", 3},  {"TIP.7", 8},
               {"RT.8", 0.4}, {"TIP.8", 2},  {"RT.10", 0.4}, {"TIP.10", 3}};
  for (const auto& [key, value] : changed) data[key] = value;
  std::ostringstream out;
  out << "schema = \"proveout.job/1\"\nname = \"part\"\nprogram = \"part.nc\"\n[control]\nname = "
         "\"wl4-lathe\"\n[control.wl4-lathe]\n";
  for (const auto& [key, value] : data) {
    if (!std::isnan(value)) out << key << " = " << value << "\n";
  }
  out << "[machine]\nrapid = 10000\n[stock]\nshape = \"cylinder\"\nbase = [0, 0, -130]\ndiameter = "
         "50\nlength = 131\n"
      << tools(finishing) << more
      << "[simulation]\nresolution = 0.4\n[output]\nviews = []\nformats = [\"stl\"]\n";
  return out.str();
}

std::string program(const std::string& body) { return "%T\nG54 G90 G95\n" + body + "M5\nM2\n%\n"; }

/// Runs a lathe job; `report` is empty where none was written.
struct LatheRun {
  LatheRun(const std::string& body, const Data& data = {}, const std::string& finishing = kOutside,
           const std::string& more = {}) {
    bench.write("part.nc", program(body));
    bench.write("job.toml", job(data, finishing, more));
    outcome = bench.run("run job.toml --out out");
    if (bench.exists("out/report.json")) report = json::parse(readFile(bench.path("out/report.json")));
  }
  Workbench bench;
  Outcome outcome;
  json report;
};

constexpr double kAbsent = NAN;
const std::string kFinishing =
    "T2 M6\nG97 S1000 M3\nG0 X60 Z5\nG41 G0 X40 Z2\nG1 Z-20 F0.1\nX46 Z-26\nZ-40\nX54\nG40 G0 X80 Z20\n";
const std::string kStep = "T2 M6\nG97 S1000 M3\nG0 X40 Z2\nG1 Z-20 F0.1\nX54\nG0 X80 Z20\n";

struct Defect {
  const char* name;
  const char* kind;     ///< of the finding that tells it
  int line;             ///< of its block; 0: any
  const char* message;  ///< part of it
  std::string body;
  Data data;
  std::string finishing = kOutside, more = {};
};
void PrintTo(const Defect& defect, std::ostream* out) { *out << defect.name; }

class TurnedDefect : public testing::TestWithParam<Defect> {};

TEST_P(TurnedDefect, IsToldAtItsBlock) {
  const Defect& defect = GetParam();
  const LatheRun run(defect.body, defect.data, defect.finishing, defect.more);
  ASSERT_FALSE(run.report.is_null()) << run.outcome.err;
  const json& findings = run.report["findings"];
  const bool told = std::any_of(findings.begin(), findings.end(), [&](const json& f) {
    const bool there = defect.line == 0 || (f.contains("source") && f["source"]["line"] == defect.line);
    return f["kind"] == defect.kind && f["severity"] != "note" && there &&
           f["message"].get<std::string>().find(defect.message) != std::string::npos;
  });
  EXPECT_TRUE(told) << findings.dump(1);
}

const std::string kThread = "T4 M6\nG97 S600 M3\nG0 X48 Z8\nM5\nG32 Z-20 F2\nG0 X54\nX80 Z20\n";

const Defect kDefects[] = {
    {"nose_absent", "tool_data", 8, "RT.2 is 0 (not given?)", kFinishing, {{"RT.2", kAbsent}}},
    {"nose_and_tip_absent",
     "tool_data",
     8,
     "TIP.2 is 0",
     kFinishing,
     {{"RT.2", kAbsent}, {"TIP.2", kAbsent}}},
    {"nose_too_large",
     "tool_data",
     8,
     "RT.2 is 0.8, the nose radius of the insert 0.4",
     kFinishing,
     {{"RT.2", 0.8}}},
    {"nose_too_small", "tool_data", 8, "RT.2 is 0.2", kFinishing, {{"RT.2", 0.2}}},
    {"tip_wrong", "tool_data", 9, "TIP.2 is 2, the orientation of the insert 3", kFinishing, {{"TIP.2", 2}}},
    {"tip_absent", "tool_data", 8, "TIP.2 is 0", kFinishing, {{"TIP.2", kAbsent}}},
    {"center_programmed", "nose_deviation", 0, "0.4 mm beyond", kStep, {{"POINT_S.2", 1}}},
    {"nose_not_compensated",
     "nose_deviation",
     7,
     "short of",
     "T2 M6\nG97 S1000 M3\nG0 X40 Z2\nG1 Z-20 F0.1\nX46 Z-26\nX54\nG0 X80 Z20\n",
     {}},
    {"data_of_another_tool",
     "tool_data",
     9,
     "the data of tool 2 count while tool 1 cuts",
     "T1 M6\nG97 S1000 M3\nT2\n" + kFinishing.substr(kFinishing.find("G0 X60")),
     {}},
    {"corrector_left",
     "tool_data",
     10,
     "D2 is 0.3",
     "T2 M6\nG97 S1000 M3\nG0 X60 Z5\nG41 D2 G0 X40 Z2\nG1 Z-20 F0.1\nX46 Z-26\nZ-40\nX54\nG40 G0 X80 Z20\n",
     {},
     kOutside,
     "[offsets.radius]\n2 = 0.3\n"},
    {"shift_in_x", "tool_data", 6, "off by X+0.3 mm", kStep, {{"DXW.2", 50.3}, {"DZW.2", 30}}, kGauged},
    {"shift_in_z", "tool_data", 6, "off by Z-0.5 mm", kStep, {{"DXW.2", 50}, {"DZW.2", 29.5}}, kGauged},
    {"shift_absent", "tool_data", 0, "off by", kStep, {{"DXW.2", 49.0}, {"DZW.2", kAbsent}}, kGauged},
    {"spindle_stopped",
     "spindle_off",
     7,
     "stands still",
     "T2 M6\nG97 S1000 M3\nG0 X40 Z2\nM5\nG1 Z-20 F0.1\nX54\n",
     {}},
    {"spindle_never_started", "spindle_off", 5, "stands still", "T2 M6\nG0 X40 Z2\nG1 Z-20 F0.1\nX54\n", {}},
    {"thread_with_spindle_stopped", "spindle_off", 7, "stands still", kThread, {}},
    {"layer_deeper_than_the_edge",
     "insert_contact",
     6,
     "does not cut here",
     "T2 M6\nG97 S1000 M3\nG0 X20 Z2\nG1 Z-20 F0.1\nX54\nG0 X80 Z20\n",
     {}},
    {"feed_above_the_nose",
     "feed_rate",
     6,
     "more than its nose radius",
     "T2 M6\nG97 S1000 M3\nG0 X46 Z2\nG1 Z-20 F2\nX54\nG0 X80 Z20\n",
     {}},
    {"feed_of_nothing",
     "cycle_time",
     6,
     "44 min",
     "T2 M6\nG97 S1000 M3\nG0 X46 Z2\nG1 Z-20 F0.0005\nX54\n",
     {}},
    {"cut_after_parting",
     "cut_off_piece",
     12,
     "cut off before",
     "T5 M6\nG97 S700 M3\nG0 X54 Z-50\nG1 X-0.6 F0.05\nG0 X54\nX80 Z20\nT2 M6\nS1000\nG0 X46 Z2\nG1 Z-20 "
     "F0.1\nX54\nG0 X80 Z20\n",
     {}},
    {"rapid_in_the_bar",
     "rapid_contact",
     6,
     "2 mm deep",
     "T2 M6\nG97 S1000 M3\nG0 X46 Z2\nG0 Z-20\nX54\nX80 Z20\n",
     {}},
    {"rapid_in_a_cycle",
     "rapid_contact",
     6,
     "2.5 mm deep",
     "T2 M6\nG97 S1000 M3\nG0 X60 Z-10\nG70 X45 Z-40 F0.2 #1=0 #2=0\nG0 X80 Z20\n",
     {}},
    {"holder_in_the_bar",
     "holder_contact",
     6,
     "10 mm deep",
     "T2 M6\nG97 S1000 M3\nG0 X54 Z-40\nG1 X10 F0.1\nG0 X54\nX80 Z20\n",
     {}},
    {"back_of_the_insert",
     "insert_contact",
     7,
     "does not cut here",
     "T2 M6\nG97 S1000 M3\nG0 X54 Z-20\nG1 X50 F0.2\nX40 Z-21\nZ-40\nX54\nG0 X80 Z20\n",
     {}},
    {"wrong_side_of_the_axis",
     "axis_crossing",
     7,
     "beyond the spindle axis",
     "T2 M6\nG97 S1000 M3\nG0 X54 Z2\nX-40\nG1 Z-20 F0.1\nX-54\nG0 Z2\n",
     {}},
    {"drill_off_the_axis",
     "axis_crossing",
     6,
     "off it",
     "T9 M6\nG97 S400 M3\nG0 X2 Z5\nG1 Z-10 F0.1\nG0 Z5\n",
     {}},
};
INSTANTIATE_TEST_SUITE_P(Run, TurnedDefect, testing::ValuesIn(kDefects),
                         [](const auto& test) { return std::string(test.param.name); });

std::string spline(int lines) {
  std::ostringstream out;
  out.precision(8);
  for (int i = 0; i < lines; ++i)
    out << "G1 X" << 44.0 + 2.0 * std::sin(i / 150.0) << " Z" << -0.02 * i << "\n";
  return out.str();
}

struct RightProgram {
  const char* name;
  std::string body;
  Data data;
  std::string finishing = kOutside;
};
void PrintTo(const RightProgram& right, std::ostream* out) { *out << right.name; }

class RightTurning : public testing::TestWithParam<RightProgram> {};

/// Notes may stand: that a piece was parted off.
TEST_P(RightTurning, IsQuiet) {
  const RightProgram& right = GetParam();
  const LatheRun run(right.body, right.data, right.finishing);
  EXPECT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
  for (const json& finding : run.report["findings"])
    EXPECT_EQ(finding["severity"], "note") << finding.dump(1);
}

const std::string kStart = "G97 S1000 M3\n", kEnd = "G0 X80\nZ20\n";

const RightProgram kRight[] = {
    {"tool_behind_the_part",
     "T8 M6\nG97 S1000 M4\nG0 X-60 Z2\nX-46\nG1 Z-40 F0.2\nX-52\nG0 Z2\nX-44\nG1 Z-20\nX-46\nZ-25\nG0 "
     "X-80\nZ20\n",
     {}},
    {"faced_from_behind", "T8 M6\nG97 S1000 M4\nG0 X-60 Z2\nZ0\nG1 X0.8 F0.1\nG0 Z3\nX-80\n", {}},
    {"facing_to_x0", "T2 M6\n" + kStart + "G0 X54 Z0\nG1 X0 F0.1\nG0 Z3\nX80\n", {}},
    {"facing_past_the_axis", "T2 M6\n" + kStart + "G0 X54 Z0\nG1 X-0.8 F0.1\nG0 Z3\nX80\n", {}},
    {"button_plunges", "T7 M6\n" + kStart + "G0 X54 Z-30\nG1 X40 F0.1\nG0 X54\nZ-60\nG1 X40\n" + kEnd, {}},
    {"button_turning", "T7 M6\n" + kStart + "G0 X46 Z5\nG1 Z-40 F0.3\nG0 X54\n" + kEnd, {}},
    {"groove_turning",
     "T3 M6\n" + kStart +
         "G0 X54 Z-30\nG1 X46 F0.08\nZ-50 F0.15\nX47 Z-49.5\nG0 X54\nZ-30.5\nG1 X42\nZ-49.5\nX47 Z-49\n" +
         kEnd,
     {}},
    {"descent_of_45_degrees",
     "T10 M6\n" + kStart + "G0 X52 Z-20\nG41 G1 X50 F0.2\nX44 Z-23\nZ-40\nX54\nG40 G0 X56\n" + kEnd,
     {}},
    {"drilling_and_boring",
     "T9 M6\nG97 S400 M3\nG0 X0 Z5\nG1 Z-40 F0.2\nG0 Z5\nX80 Z30\nT6 M6\nS900\nG42 G0 X24 Z2\nG1 Z-30 "
     "F0.15\nX19\nG40 "
     "G0 X18\nZ5\n" +
         kEnd,
     {}},
    {"spline_of_2000_lines",
     "T10 M6\n" + kStart + "G0 X52 Z2\nG41 G0 X44\nG1 Z0 F0.1\n" + spline(2000) + "X54\nG40 G0 X80 Z20\n",
     {}},
    {"finishing", kFinishing, {}},
    {"finishing_by_the_center", kFinishing, {{"POINT_S.2", 1}, {"TIP.2", kAbsent}}},
    {"center_is_the_control_point", kFinishing, {{"TIP.2", 9}}, "orientation = 9\n"},
    {"shifts_and_gauge", kStep, {{"DXW.2", 50}, {"DZW.2", 30}}, kGauged},
    {"parting", "T5 M6\n" + kStart + "G0 X54 Z-50\nG1 X-0.6 F0.05\nG0 X54\n" + kEnd, {}},
    {"thread",
     "T4 M6\nG97 S600 M3\nG0 X49 Z8\nG32 Z-20 F2\nG0 X54\nZ8\nX48\nG32 Z-20 F2\nG0 X54\n" + kEnd,
     {}},
    {"chamfers_and_radii",
     "T2 M6\n" + kStart +
         "G0 X54 Z2\nG41 G0 X30\nG1 X40 Z-3 F0.1\nZ-20\nG3 X44 Z-22 R2\nG1 X54\nG40 G0 X56\n" + kEnd,
     {}},
};
INSTANTIATE_TEST_SUITE_P(Run, RightTurning, testing::ValuesIn(kRight),
                         [](const auto& test) { return std::string(test.param.name); });

/// Radius of the part at a height, from its mesh: the largest x + y there.
double radiusAt(const LatheRun& run, double z) {
  const std::string stl = readFile(run.bench.path("out/part.stl"));
  double most = 0.0;
  const auto* bytes = stl.data() + 84;
  for (std::size_t k = 0; 84 + 50 * k + 50 <= stl.size(); ++k) {
    float v[9];
    std::copy_n(bytes + 50 * k + 12, sizeof v, reinterpret_cast<char*>(v));
    for (int i = 0; i < 3; ++i) {
      // Edges of a straight cylinder end where it ends: any triangle that crosses the height counts.
      const float *a = v + 3 * i, *b = v + 3 * ((i + 1) % 3);
      if ((a[2] - z) * (b[2] - z) > 0.0) continue;
      most = std::max<double>(most, std::max(std::hypot(a[0], a[1]), std::hypot(b[0], b[1])));
    }
  }
  return most;
}

// The control leads the nose centre by its radius; the engine has to put the centre there, not the corner.
TEST(TurnedPart, TheNoseCenterIsWhereTheProgramMovesIt) {
  const LatheRun by_center(kFinishing, {{"POINT_S.2", 1}, {"TIP.2", kAbsent}});
  EXPECT_NEAR(radiusAt(by_center, -10.0), 20.0, 2e-3);
  EXPECT_NEAR(radiusAt(by_center, -35.0), 23.0, 2e-3);
  const LatheRun by_corner(kFinishing);
  EXPECT_NEAR(by_center.report["stock"]["final_mm3"].get<double>(),
              by_corner.report["stock"]["final_mm3"].get<double>(), 1e-3);
  const LatheRun without(kStep, {{"POINT_S.2", 1}});
  EXPECT_NEAR(radiusAt(without, -10.0), 19.6, 2e-3);
}

TEST(TurnedPart, TheSameFromBehind) {
  const LatheRun front("T2 M6\nG97 S1000 M3\nG0 X54 Z2\nX44\nG1 Z-30 F0.1\nX54\nG0 X80 Z20\n");
  const LatheRun behind("T8 M6\nG97 S1000 M4\nG0 X-54 Z2\nX-44\nG1 Z-30 F0.1\nX-54\nG0 X-80 Z20\n");
  EXPECT_EQ(front.report["stock"]["final_mm3"], behind.report["stock"]["final_mm3"]);
  EXPECT_EQ(behind.outcome.exit_code, 0) << behind.outcome.err;
}

// The wedge that the leading edge, 3 degrees off, cuts on its way out along X.
TEST(TurnedPart, ContactsAreAsDeepAsWhatIsCutOff) {
  const LatheRun run("T2 M6\nG97 S1000 M3\nG0 X40 Z2\nG1 Z-20 F0.1\nG0 X54\nX80 Z20\n");
  ASSERT_EQ(run.report["findings"].size(), 1u);
  const double lean = 3.0 * std::acos(-1.0) / 180.0, r = 0.4;
  // Below the tangent point of the nose, r (1 - sin 3) above the corner, up to the bar's radius of 25.
  const double depth = (5.0 - r * (1.0 - std::sin(lean))) * std::sin(lean) - r * (1.0 - std::cos(lean));
  EXPECT_NEAR(run.report["findings"][0]["depth_mm"].get<double>(), depth, 5e-3);
}

/// A round insert whose point is its centre; what it says of its nose.
std::string noseWords(const std::string& moves) {
  const Workbench bench;
  bench.write("t.nc", "%T\nG54 G90 G95 G97 S800 M3\nT1 M6\n" + moves + "M5\nM2\n%\n");
  bench.write("t.toml",
              "schema = \"proveout.job/1\"\nprogram = \"t.nc\"\n[control]\nname = \"wl4-lathe\"\n"
              "[control.wl4-lathe]\nRT.1 = 3\nTIP.1 = 9\n[stock]\nshape = \"cylinder\"\nbase = [0, 0, -80]\n"
              "diameter = 60\nlength = 80\n[[tool]]\nnumber = 1\ntype = \"insert\"\nshape = \"round\"\n"
              "nose_radius = 3\norientation = 9\n[output]\nviews = []\n");
  const Outcome outcome = bench.run("run t.toml --out t-out");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return has(outcome.err, "nose_deviation") ? outcome.err : std::string();
}

TEST(RoundInsert, APlungeIsMeantToBeAsWideAsItsNose) {
  EXPECT_EQ(noseWords("G0 X80 Z-30\nG1 X56 F0.1\nG0 X80\nZ5\n"), "");
  EXPECT_EQ(noseWords("G0 X80 Z-30\nG1 X64 F0.1\nX58\nG0 X62\nG1 X54\nX80\nG0 Z5\n"), "") << "in pecks, out at feed";
  EXPECT_EQ(noseWords("G0 X40 Z10\nG1 Z-1 F0.1\nG0 Z10\nX80\n"), "") << "into the face";
  EXPECT_NE(noseWords("G0 X80 Z5\nX62\nG1 Z-20 F0.1\nG0 X80\nZ5\n"), "") << "a diameter";
  EXPECT_NE(noseWords("G0 X80 Z2\nG1 X0 F0.1\nG0 X80\nZ5\n"), "") << "a face, and back over it";
}

}  // namespace
}  // namespace proveout::test
