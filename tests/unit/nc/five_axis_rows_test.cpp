// What chapter 25 says of length along the tool, turns of space, dynamic zero, tilted planes, the tool's
// direction and variables beside its codes: statement by statement. Positions are those of the manual's
// equations on the test machines, and those that rules give by hand.
//
// Rows: nct-25.2-PATH nct-25.2-V nct-25.2-ALONE nct-25.3-ABS nct-25.3-TWO nct-25.4-LIN nct-25.4-G0
// nct-25.4-END nct-25.4-V0 nct-25.4-MECH nct-25.7-2039 nct-25.8-2039 nct-25.8-2064 nct-25.8-2088
// nct-25.9-2039 nct-25.9-2064 nct-25.9-2088 nct-25.10-2088 nct-25.11-ALONE nct-25.11-HH nct-25.11-TT
// nct-25.11-HT nct-25.11-MID nct-25.13-ORDER nct-25.19-5061 nct-25.19-151001 nct-25.19-151101
// nct-25.19-151xxx
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include "core/nc/kinematics/five_axis_model.h"
#include "tests/support/five_axis_runs.h"

namespace proveout {
namespace five_axis_rows_test {
namespace {

using namespace test;  // NOLINT

const double kHalf = std::sqrt(0.5);

std::string errorOf(const std::string& text, const ControlSettings& settings) {
  return runOf(text, settings).error;
}

void expectRefused(const std::string& text, const ControlSettings& settings, std::string_view code) {
  const std::string error = errorOf(text, settings);
  EXPECT_TRUE(error.starts_with(code)) << text << ": " << error;
}

/// The end of a line is where the machine is at these positions of its axes.
void expectMachine(const Outcome& out, const ControlSettings& settings, std::uint32_t line, const Vec3& xyz,
                   double first, double second) {
  EXPECT_EQ(out.error, "");
  const ToolPose want = poseOf(settings, xyz, first, second), found = endOf(out, line);
  EXPECT_LT((found.tip - want.tip).norm(), kPrinted) << line << ": " << found.tip.transpose();
  EXPECT_LT((found.axis - want.axis).norm(), 1e-6) << line << ": " << found.axis.transpose();
}

/// Material below a plane through a point.
class PlaneProbe : public Probe {
 public:
  PlaneProbe(const Vec3& point, const Vec3& normal) : point_(point), normal_(normal.normalized()) {}
  Result<std::optional<double>> firstContact(const Motion& move, const ArcGeometry*,
                                             const AxisSweep*) override {
    const double from = normal_.dot(move.from - point_), to = normal_.dot(move.to - point_);
    if (from < 0.0 || to > 0.0) return std::optional<double>();
    return std::optional<double>(from / (from - to));
  }

 private:
  Vec3 point_, normal_;
};

/// A run with a probe, and what variables say at its end.
struct Read : Outcome {
  std::vector<double> values;
};
Read readOf(const std::string& text, const std::vector<int>& variables, const ControlSettings& settings,
            Probe* probe = nullptr) {
  Read out;
  std::string program = text + "\nFOPEN1 <values.txt>\n";
  for (const int v : variables) program += fmt::format("DPRNT[V#{}[54]]\n", v);
  program += "FCLOS\nM30\n";
  MemoryOutput output;
  ControlHost host;
  host.probe = probe;
  host.output = &output;
  ToolpathBuilder sink(out.path);
  out.summary =
      interpret(ControlId::kNct, MemoryProgramSource("main.nc", program), settings, sink, nullptr, host);
  for (const Diagnostic& d : out.path.diagnostics.all()) {
    if (d.severity == Severity::kError && out.error.empty()) out.error = d.code + ": " + d.message;
  }
  for (const auto& [name, bytes] : output.files()) {
    std::istringstream lines(bytes);
    for (std::string line; std::getline(lines, line);) {
      std::erase(line, ' ');
      if (line.starts_with("V")) out.values.push_back(std::stod(line.substr(1)));
    }
  }
  return out;
}
void expectValues(const Read& read, const std::vector<double>& values) {
  EXPECT_EQ(read.error, "");
  ASSERT_EQ(read.values.size(), values.size());
  for (std::size_t k = 0; k < values.size(); ++k) EXPECT_NEAR(read.values[k], values[k], 1.1e-4) << k;
}

// 25.2

/// V = M1 M2 H + M1 M2 I + M1 J - (I + J), with the manual's figure and machines whose axes do not meet.
TEST(LengthAlongToolRows, VIsTheManualsEquation) {
  const auto v = [](const MachineModel& machine, double first, double second, double length) {
    return nc::fiveAxisModelOf(machine).lengthVector({first, second}, length);
  };
  const auto expectV = [](const Vec3& found, const Vec3& want) {
    EXPECT_LT((found - want).norm(), kPrinted) << found.transpose();
  };
  const MachineModel ca = headHead('A', {0, 0, 150}, {0, 20, 30});
  expectV(v(ca, 0, 45, 100), {0, -176.7767, 26.7767});
  expectV(v(ca, 60, 30, 100), {90.9327, -72.5, 66.5064});
  expectV(v(ca, 60, 45, 100), {135.7726, -98.3883, 26.7767});
  expectV(v(machineCB(), 0, 15, 100), {64.7048, 0, 91.4815});
  expectV(v(headHead('B', {10, 0, 150}, {0, 25, 60}), 60, 30, 120), {40.1795, 111.9134, 78.8269});
  MachineModel ht = plainMachine();
  addHead(ht, "B", Vec3::UnitY(), {10, 0, 150});
  addTable(ht, "C", Vec3::UnitZ(), {400, 300, -500});
  expectV(v(ht, -40, 0, 120), {-175.8922, 0, 63.2599});
  // The machine goes by it: the tip is at the programmed place.
  const ControlSettings settings = settingsOf(ca, Vec3::Zero());
  const Outcome out = runOf("G54 G0 X0 Y0 Z300\nG43.1 H1 X10 Y20 Z30 A45", settings);
  expectTip(out, 2, {10, 20, 30});
  expectMachine(out, settings, 2, Vec3(10, 20 - 176.7767, 30 + 26.7767), 0, 45);
}

/// On a line the control point goes straight, and the tip does not.
TEST(LengthAlongToolRows, TheControlPointGoesStraight) {
  const ControlSettings hh = machineOf('H');
  const Outcome line =
      runOf("G54 G0 X0 Y0 Z100 B0 C0\nG43.1 X60 Y-60 Z-10 B30 H1\nG1 Y60 B45 F1200\nX10", hh);
  ASSERT_EQ(line.error, "");
  const Vec3 from(185, -60, 56.5064), to(236.7767, 60, 16.7767);
  const ToolPose half = poseAt(line, 3, 0.5), want = poseOf(hh, 0.5 * (from + to), 0, 37.5);
  expectPose(half, want.tip, want.axis, "middle");
  expectPose(half, {58.6980, 0, -11.6968}, want.axis, "middle of 25.14's contrast");
  // Where no rotary axis moves the tip goes along with it.
  EXPECT_LT((poseAt(line, 4, 0.5).tip - Vec3(35, 60, -10)).norm(), kPrinted);
  // The same of tables, without a length along the tool.
  const ControlSettings tt = machineOf('T');
  const Outcome table =
      runOf("G0 X60 Y16.9615 Z110.6218 A-30 C-90\nG1 X-60 Y-7.0711 Z111.9239 A-45 F1200", tt);
  ASSERT_EQ(table.error, "");
  EXPECT_LT((poseAt(table, 2, 0.5).tip - Vec3(59.4867, 0, -10.5989)).norm(), 2e-4);
}

/// An arc while the head turns by the same angle: control point and tip go about one centre.
TEST(LengthAlongToolRows, TheControlPointGoesOnTheArc) {
  const ControlSettings settings = machineOf('H');
  const std::string start = "G54 G0 X50 Y0 Z300 B40 C0\nG43.1 X50 Y0 Z0 H1\n";
  const Outcome plain = runOf(start + "G3 X0 Y50 R50 F500", settings);
  ASSERT_EQ(plain.error, "");
  EXPECT_EQ(motionOf(plain, 3)->shape(), MotionShape::kArc);
  EXPECT_LT((poseAt(plain, 3, 0.5).tip - Vec3(50 * kHalf, 50 * kHalf, 0)).norm(), kPrinted);
  const Outcome cone = runOf(start + "G3 X0 Y50 R50 C90 F500", settings);
  expectTip(cone, 3, {0, 50, 0});
  for (const Motion& m : cone.path.motions) {
    if (m.source.line != 3) continue;
    EXPECT_NEAR(m.to.head<2>().norm(), 50.0, 1e-6);
  }
  // The head rises on the way too: the control point goes on the quarter between the ends that it has.
  const Outcome leaning = runOf(start + "G3 X0 Y50 R50 C90 B30 F500", settings);
  expectTip(leaning, 3, {0, 50, 0});
  const nc::FiveAxisModel model = nc::fiveAxisModelOf(*settings.machine);
  const Vec3 from = Vec3(50, 0, 0) + model.lengthVector({0, 40}, 100),
             to = Vec3(0, 50, 0) + model.lengthVector({90, 30}, 100), chord = to - from;
  const Vec2 center = 0.5 * (from + to + Vec3(-chord.y(), chord.x(), 0)).head<2>();  // of a quarter
  Vec3 last = Vec3(50, 0, 0);
  for (const Motion& m : leaning.path.motions) {
    if (m.source.line != 3) continue;
    EXPECT_LT((m.from - last).norm(), 1e-9);
    last = m.to;
    EXPECT_LT((m.to - m.from).norm(), 5.0) << "a jump";
    // The control point from the tip, its angles those of the piece's end.
    const AxisSweep& sweep = leaning.path.axes[static_cast<std::size_t>(m.axis)];
    double c = 0.0, b = 0.0;
    for (int k = 0; k < sweep.rotary_count; ++k) {
      const RotaryPosition& r = sweep.rotary[static_cast<std::size_t>(k)];
      (r.name.data() == std::string_view("C") ? c : b) = r.to;
    }
    const double share = c / 90.0;
    const Vec3 control = m.to + model.lengthVector({c, b}, 100);
    EXPECT_NEAR(b, 40.0 - 10.0 * share, 1e-9);
    EXPECT_NEAR((control.head<2>() - center).norm(), (from.head<2>() - center).norm(), 1e-6);
  }
  EXPECT_LT((last - Vec3(0, 50, 0)).norm(), 1e-6);
  // Zeros that go with a table: the ends are those of the manual's zero.
  const ControlSettings tables = settingsOf(trunnion('A'), Vec3(450, 300, -420));
  const Outcome table =
      runOf("G10 L21 P1 X50 Y0 Z40\nG43 H1 G0 Z50\nG54.2 P1 X0 Y0 Z0\nG2 X10 Y10 R20 C30 F500", tables);
  const Vec3 zero = nc::fiveAxisModelOf(*tables.machine).dynamicZero({0, 30}, {50, 0, 40}, {});
  expectMachine(table, tables, 4, zero + Vec3(10, 10, 100), 0, 30);
}

TEST(LengthAlongToolRows, ArcsThatNoControlPointCanGoAreRefused) {
  const std::string start = "G54 G0 X50 Y0 Z300 B40 C0\nG43.1 X50 Y0 Z0 H1\n";
  for (const char* circle : {"G3 I-50 B30 F500", "G3 X50 Y-0.001 I-50 B30 F500"})
    expectRefused(start + circle, machineOf('H'), "nct-rotary-in-arc");
  expectRefused("G54 G0 X0 Y0 Z0\nG43 H1 Z50\nG68.2 I90 J30 K0\nG53.1\nG0 X0 Y0\nG2 X20 R20 B50 F100",
                machineOf('H'), "nct-rotary-in-arc");
}

/// Example 3: nothing moves, whatever N3212.FOS is and wherever the head stands; the coordinates change.
TEST(LengthAlongToolRows, AloneItChangesTheCoordinates) {
  for (const double fos : {0.0, 1.0}) {
    ControlSettings settings = settingsOf(machineCA(), Vec3::Zero());
    settings.parameters["N3212.FOS"] = fos;
    const Read upright =
        readOf("G54 G49 G0 G90 X0 Y0 Z100 A0 C0\nG43.1 H1", {5001, 5002, 5003, 5083}, settings);
    expectValues(upright, {0, 0, 0, 100});
    const Read leaning =
        readOf("G54 G49 G0 G90 X0 Y0 Z100 A45 C60\nG43.1 H1", {5001, 5002, 5003, 5081, 5082, 5083}, settings);
    expectValues(leaning, {-61.2372, 35.3553, 29.2893, 61.2372, -35.3553, 70.7107});
    for (const Motion& m : leaning.path.motions) EXPECT_NE(m.source.line, 2u);
  }
}

// 25.3

TEST(SpaceRotationRows, ShiftsAreAbsoluteAndOneAxisIsNamed) {
  const ControlSettings settings = settingsOf(plainMachine(), Vec3::Zero());
  const Outcome out =
      runOf("G0 X7 Y7 Z7\nG91 G68.1 X10 Y20 Z30 I0 J0 K1 R30\nG68.1 X5 Y0 Z0 I0 J1 K0 R45\nG90 G0 X1 Y2 Z3",
            settings);
  expectTip(out, 4, Vec3(15.7796, 25.6463, 31.4142 - 100));
  for (const char* wrong : {"G68.1 I1 J1 K0 R30", "G68.1 I2 R30", "G68.1 K-1 R30", "G68.1 J0.5 R30"})
    expectRefused(wrong, settings, "nct-2002");
  for (const char* missing : {"G68.1 R30", "G68.1 I0 J0 K0 R30", "G68.1 X1 K1"})
    expectRefused(missing, settings, "nct-2004");
}

TEST(SpaceRotationRows, NoMoreThanTwo) {
  const ControlSettings settings = settingsOf(plainMachine(), Vec3::Zero());
  const std::string one = "G68.1 X1 K1 R10\n";
  expectRefused(one + one + one, settings, "nct-tilt");
  EXPECT_EQ(errorOf(one + one + "G69.1\n" + one + one + "G0 X1", settings), "");
  expectRefused(one + "G68.2 I10", settings, "nct-tilt");
  expectRefused("G68.2 I10\n" + one, settings, "nct-tilt");
}

// 25.4

const std::string kRow = "G10 L21 P1 X50 Y0 Z40\n";

/// The zero for any position of the tables, from values measured at any: read as #5501 to #5503.
TEST(DynamicZeroRows, IsMeasuredAtAnyPosition) {
  const struct {
    const char* table;
    double a, c;
    Vec3 zero;
  } rows[] = {{"", 0, 0, {450, 300, -420}},
              {"", 0, 90, {400, 250, -420}},
              {"", 30, 0, {450, 340, -430.7180}},
              {"", 30, 90, {400, 296.6987, -405.7180}},
              {" A0 C20", 0, 0, {450, 300, -420}},
              {" A0 C20", 30, 70, {417.1010, 299.3101, -407.2257}},
              {" A10 C20", 0, 0, {450, 306.9459, -420.6077}},
              {" A10 C20", 30, 70, {410.5740, 313.2202, -407.4538}}};
  const ControlSettings settings = settingsOf(trunnion('A'), kTableZero);
  for (const auto& row : rows) {
    const std::string text =
        fmt::format("G10 L21 P1 X50 Y0 Z40{}\nG0 G54.2 P1 A{} C{}", row.table, row.a, row.c);
    expectValues(readOf(text, {5500, 5501, 5502, 5503}, settings),
                 {1, row.zero.x(), row.zero.y(), row.zero.z()});
  }
  // Head-table: the table alone counts.
  expectValues(readOf(kRow + "G0 G54.2 P1 B30 C90", {5501, 5502, 5503}, machineOf('M')), {400, 250, -460});
}

/// The zero is that of the end of the block's own rotary words.
TEST(DynamicZeroRows, IsThatOfTheEndOfTheBlock) {
  const ControlSettings settings = settingsOf(trunnion('A'), Vec3(450, 300, -420));
  for (const char* mode : {"G0", "G1 F500"}) {
    const Outcome out =
        runOf(kRow + fmt::format("G43 H1 G0 Z50\nG54.2 P1 {} X1 Y2 Z3 A30 C90", mode), settings);
    expectMachine(out, settings, 3, Vec3(401, 298.6987, -402.7180 + 100), 30, 90);
  }
}

TEST(DynamicZeroRows, ALineLeavesTheTableBetweenItsEnds) {
  const ControlSettings settings = settingsOf(trunnion('B'), kTableZero);
  const Outcome out =
      runOf("G10 L21 P1 X0 Y0 Z40\nG43 H1 G0 Z50\nG54.2 P1 G1 X-50 Y0 Z0 B0 F1000\nX50 B30", settings);
  expectMachine(out, settings, 3, {350, 300, -320}, 0, 0);
  expectMachine(out, settings, 4, {410, 300, -330.7180}, 30, 0);
  const Vec3 from(-50, 0, 0), to(43.3013, 0, -25), middle = poseAt(out, 4, 0.5).tip;
  EXPECT_LT((endOf(out, 3).tip - from).norm(), kPrinted);
  EXPECT_LT((endOf(out, 4).tip - to).norm(), kPrinted);
  EXPECT_LT((middle - Vec3(0, 0, -2.7259)).norm(), kPrinted);
  EXPECT_NEAR((middle - from).cross((to - from).normalized()).norm(), 10.308, 1e-3);
}

/// Where G2 is in force the call moves in rapid, and G2 is in force behind it.
TEST(DynamicZeroRows, TheCallMovesInRapid) {
  ControlSettings settings = settingsOf(trunnion('A'), Vec3(450, 300, -420));
  const std::string head = kRow + "G43 H1 G0 X0 Y0 Z50\nG2 X10 Y10 R20 F500\n";
  const auto kindOf = [](const Outcome& out, std::uint32_t line) { return motionOf(out, line)->kind; };
  const Outcome words = runOf(head + "G54.2 P1 X0 Y0 Z0\nX5 Y5 R20", settings);
  ASSERT_EQ(words.error, "");
  EXPECT_EQ(kindOf(words, 4), MotionKind::kRapid);
  expectMachine(words, settings, 4, {450, 300, -320}, 0, 0);
  EXPECT_EQ(motionOf(words, 5)->shape(), MotionShape::kArc);
  const Outcome alone = runOf(kRow + "G43 H1 G0 X0 Y0 Z50\nA30\nG2 X10 Y10 R20 F500\nG54.2 P1", settings);
  ASSERT_EQ(alone.error, "");
  EXPECT_EQ(alone.path.motions.back().kind, MotionKind::kRapid);
  expectMachine(alone, settings, 5, {460, 350, -430.7180 + 150}, 30, 0);
  const Outcome fed = runOf(kRow + "G43 H1 G0 X0 Y0 Z50\nA30\nG1 X10 F500\nG54.2 P1", settings);
  EXPECT_EQ(fed.path.motions.back().kind, MotionKind::kFeed);
  // By transformation the call alone moves nothing.
  settings.parameters["N3212.FOS"] = 1.0;
  const Outcome stands = runOf(kRow + "G43 H1 G0 X0 Y0 Z50\nA30\nG54.2 P1", settings);
  for (const Motion& m : stands.path.motions) EXPECT_NE(m.source.line, 4u);
}

TEST(DynamicZeroRows, NeedsATableByTheMachineAndByTheParameter) {
  expectRefused("G54.2 P1", machineOf('H'), "nct-machine-data");
  expectRefused("G54.2 P1", settingsOf(plainMachine(), Vec3::Zero()), "nct-machine-data");
  for (const double kind : {0.0, 1.0}) {
    ControlSettings settings = machineOf('T');
    settings.parameters["N3200"] = kind;
    expectRefused("G54.2 P1", settings, "nct-machine-data");
  }
  EXPECT_EQ(errorOf("G54.2 P1", machineOf('T')), "");
  EXPECT_EQ(errorOf("G54.2 P1", machineOf('M')), "");
}

// 25.7 to 25.10

TEST(TiltedPlaneRows, AlarmsOfTheDefinitions) {
  const struct {
    const char *row, *program, *alarm;
  } rows[] = {
      {"25.7-2039", "G68.2 P1 Q321 I10\nG68.2 P1 Q322 I10", "nct-2039"},
      {"25.7-2039", "G68.2 P1 Q12 I10", "nct-2039"},
      {"25.7-2039", "G68.2 P1 I10 J20 K30", "nct-2039"},
      {"25.8-2039", "G68.2 P2 Q4 X1", "nct-2039"},
      {"25.8-2039", "G68.2 P2 Q1.5 X1", "nct-2039"},
      {"25.8-2039", "G68.2 P2 X1", "nct-2039"},
      {"25.8-2064", "G68.2 P2 Q1\nG68.2 P2 Q2 X1\nG0 X1", "nct-2064"},
      {"25.8-2064", "G68.2 P2 Q2 X1\nG68.2 P2 Q3 Y1\nG53.1", "nct-2064"},
      {"25.8-2064", "G68.2 P2 Q1\nG68.2 P2 Q3 Y1\nG69.1", "nct-2064"},
      {"25.8-2088", "G68.2 P2 Q1 X5\nG68.2 P2 Q2 X5\nG68.2 P2 Q3 Y1", "nct-2088"},
      {"25.8-2088", "G68.2 P2 Q1\nG68.2 P2 Q2 X1 Y1\nG68.2 P2 Q3 X3 Y3", "nct-2088"},
      {"25.8-2088", "G68.2 P2 Q1\nG68.2 P2 Q2 X100\nG68.2 P2 Q3 X200 Y0.001", "nct-2088"},
      {"25.9-2039", "G68.2 P3 Q0 I1", "nct-2039"},
      {"25.9-2039", "G68.2 P3 Q3 I1", "nct-2039"},
      {"25.9-2039", "G68.2 P3 I1", "nct-2039"},
      {"25.9-2064", "G68.2 P3 Q1 I1\nG0 X1", "nct-2064"},
      {"25.9-2064", "G68.2 P3 Q2 K1\nG53.1", "nct-2064"},
      {"25.9-2088", "G68.2 P3 Q1 I1\nG68.2 P3 Q2 I-3", "nct-2088"},
      {"25.9-2088", "G68.2 P3 Q1 I0 J0 K0\nG68.2 P3 Q2 K1", "nct-2088"},
      {"25.9-2088", "G68.2 P3 Q1 I1\nG68.2 P3 Q2", "nct-2088"},
      {"25.10-2088", "G68.2 P4 I90 J90", "nct-2088"},
      {"25.10-2088", "G68.2 P4 I90 J-90 K10", "nct-2088"},
      {"25.10-2088", "G68.2 P4 I-90 J90", "nct-2088"},
  };
  for (const auto& row : rows) {
    const std::string error = errorOf(row.program, machineOf('H'));
    EXPECT_TRUE(error.starts_with(row.alarm)) << row.row << " " << row.program << ": " << error;
  }
}

// 25.11

TEST(ToolDirectionRows, StandsAloneBehindItsPlane) {
  const std::string plane = "G54 G0 X0 Y0\nG43 H1 Z50\nG68.2 I0 J30 K0\n";
  for (const char* beside : {"G53.1 H1", "G53.1 M3", "G53.1 F100", "G0 G53.1", "G53.1 G90"})
    expectRefused(plane + beside, machineOf('H'), "nct-own-block");
  expectRefused(plane + "G53.1 X5", machineOf('H'), "nct-2017");
  expectRefused("G53.1", machineOf('H'), "nct-2019");
  expectRefused("G68.1 K1 R30\nG53.1", machineOf('H'), "nct-2019");
  expectRefused(plane + "G69.1\nG53.1", machineOf('H'), "nct-2019");
  EXPECT_EQ(errorOf(plane + "N40 G53.1", machineOf('H')), "");
}

/// The manual's program on its three machines: where the axes are, and that plane, zero and length follow
/// the rotary axes behind it. With N3212.FOS = 0 the tip is at its place at both ends, and not between.
TEST(ToolDirectionRows, PlaneZeroAndLengthFollow) {
  const struct {
    const char* row;
    char machine;
    const char* angles;
    double first, second;
    Vec3 loaded, turned, middle, in_plane, at_zero;
  } rows[] = {
      {"25.11-HH",
       'H',
       "I90 J45 K0",
       0,
       45,
       {0, 0, 100},
       {176.7767, 0, 26.7767},
       {-7.2825, 0, -17.5815},
       {-100, 35.3553, -106.0660},
       {276.7767, 100, 76.7767}},
      {"25.11-TT",
       'T',
       "I90 J45 K0",
       45,
       90,
       {400, 300, -320},
       {400, 356.5685, -343.4315},
       {0, 0, -6.0896},
       {-100, 35.3553, -106.0660},
       {500, 321.2132, -237.3654}},
      {"25.11-HT",
       'M',
       "I0 J45 K0",
       -45,
       90,
       {400, 300, -320},
       {223.2233, 300, -393.2233},
       {5.1495, 5.1495, -17.5815},
       {-100, -106.0660, 35.3553},
       {323.2233, 200, -343.2233}},
  };
  for (const auto& row : rows) {
    ControlSettings settings = machineOf(row.machine);
    settings.start = Vec3(0, 0, 50);
    const std::string text =
        fmt::format("N10 G17 G54 G0 X0 Y0\nN20 G43 Z0 H1\nN30 G68.2 X100 Y100 Z50 {}\nN40 G53.1", row.angles);
    const Outcome out = runOf(text + "\nN50 X0 Y0 Z0", settings);
    expectMachine(out, settings, 2, row.loaded, 0, 0);
    expectMachine(out, settings, 4, row.turned, row.first, row.second);
    expectTip(out, 4, {0, 0, 0});
    EXPECT_LT((poseAt(out, 4, 0.5).tip - row.middle).norm(), kPrinted)
        << row.row << poseAt(out, 4, 0.5).tip.transpose();
    expectMachine(out, settings, 5, row.at_zero, row.first, row.second);
    expectTip(out, 5, {100, 100, 50});
    expectValues(readOf(text, {5001, 5002, 5003}, settings),
                 {row.in_plane.x(), row.in_plane.y(), row.in_plane.z()});
  }
}

/// From N40 on the program's axes have these directions of the machine.
TEST(ToolDirectionRows, ThePlaneTurnsWithTheTables) {
  const struct {
    char machine;
    const char* angles;
    double first, second;
    Vec3 at_zero, x, y, z;
  } rows[] = {
      {'H', "I90 J45 K0", 0, 45, {276.7767, 100, 76.7767}, {0, 1, 0}, {-kHalf, 0, kHalf}, {kHalf, 0, kHalf}},
      {'T', "I90 J45 K0", 45, 90, {500, 321.2132, -237.3654}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
      {'M',
       "I0 J45 K0",
       -45,
       90,
       {323.2233, 200, -343.2233},
       {0, -1, 0},
       {kHalf, 0, kHalf},
       {-kHalf, 0, kHalf}},
  };
  for (const auto& row : rows) {
    const ControlSettings settings = machineOf(row.machine);
    const Outcome out = runOf(fmt::format("G17 G54 G0 X0 Y0\nG43 Z0 H1\nG68.2 X100 Y100 Z50 {}\nG53.1\n"
                                          "X10 Y0 Z0\nX0 Y10\nY0 Z10",
                                          row.angles),
                              settings);
    expectMachine(out, settings, 5, row.at_zero + 10 * row.x, row.first, row.second);
    expectMachine(out, settings, 6, row.at_zero + 10 * row.y, row.first, row.second);
    expectMachine(out, settings, 7, row.at_zero + 10 * row.z, row.first, row.second);
  }
}

/// A rotary word behind it is not described: the plane stays on the workpiece, and a warning says so.
TEST(ToolDirectionRows, ARotaryWordBehindItIsTold) {
  const std::string head = "G54 G0 X0 Y0\nG43 H1 Z50\nG68.2 I0 J30 K0\nG53.1\nG0 X0 Y0 Z0\n";
  const auto told = [&](const std::string& text, char machine) {
    const Outcome out = runOf(head + text, machineOf(machine));
    EXPECT_EQ(out.error, "");
    const auto& all = out.path.diagnostics.all();
    return std::count_if(all.begin(), all.end(),
                         [](const Diagnostic& d) { return d.code == "nct-tool-beside-plane"; });
  };
  EXPECT_EQ(told("G1 X20 F100", 'H'), 0);
  EXPECT_EQ(told("G1 X20 B50 F100\nX30 B60", 'H'), 1);
  EXPECT_EQ(told("G1 X20 A10 F100", 'T'), 1);
  const Outcome out = runOf(head + "G1 X20 Y5 A10 F100", machineOf('T'));
  expectTip(out, 6, {20, 5 * std::cos(degToRad(30.0)), 5 * 0.5});
}

/// Total ties go to the larger angle of the first axis; heads that lean reach half of the directions; a tool
/// along X is as any other.
TEST(ToolDirectionRows, ChoiceAtTies) {
  const Outcome tie = runOf("G54 G0 X0 Y0 B0 C0\nG43 Z0 H1\nG68.2 I0 J45 K0\nG53.1", machineOf('H'));
  ASSERT_EQ(tie.error, "");
  EXPECT_NEAR(rotaryAt(tie, 4, "C"), 90.0, 1e-9);
  EXPECT_NEAR(rotaryAt(tie, 4, "B"), -45.0, 1e-9);
  MachineModel leaning = plainMachine();
  addHead(leaning, "B", Vec3::UnitY(), {0, 0, 200});
  addHead(leaning, "C", {0, kHalf, kHalf}, {0, 0, 200});
  const nc::FiveAxisModel model = nc::fiveAxisModelOf(leaning);
  for (const double y : {-0.9, -0.1, 0.0, 0.1, 0.9}) {
    const double across = std::sqrt(1.0 - y * y);
    EXPECT_EQ(model.positionsFor(Vec3(0.6 * across, y, 0.8 * across), {}).count > 0, y >= 0.0) << y;
  }
}

TEST(ToolDirectionRows, AHorizontalTool) {
  MachineModel lying = plainMachine();
  addHead(lying, "C", Vec3::UnitZ(), Vec3::Zero());
  addHead(lying, "B", Vec3::UnitY(), Vec3::Zero());
  lying.spindle.direction = Vec3::UnitX();
  const ControlSettings settings = settingsOf(lying, Vec3::Zero());
  const nc::FiveAxisModel model = nc::fiveAxisModelOf(lying);
  const Vec3 t(0.8138, 0.4698, -0.3420);
  EXPECT_LT((model.toolVector({30, 20}) - t).norm(), kPrinted);
  const nc::FiveAxisModel::Positions back = model.positionsFor(model.toolVector({30, 20}), {});
  ASSERT_EQ(back.count, 2);
  for (int k = 0; k < back.count; ++k)
    EXPECT_LT((model.toolVector(back.at[static_cast<std::size_t>(k)]) - t).norm(), kPrinted);
  EXPECT_LT((model.lengthVector({30, 20}, 100) - 100.0 * t).norm(), 1e-2);
  const Outcome out = runOf("G54 G0 X0 Y0 Z0\nG43.1 H1 X10 Y20 Z30 C30 B20", settings);
  expectTip(out, 2, {10, 20, 30});
  EXPECT_LT((endOf(out, 2).axis - t).norm(), kPrinted);
}

// 25.13

/// A program's own transforms, then the tilted plane, then the base rotation of the zero, then the zero.
TEST(TiltedPlaneRows, TransformsThenThePlaneThenTheBaseRotation) {
  ControlSettings settings = settingsOf(plainMachine(), Vec3(7, 8, 9));
  settings.work_rotations_deg[0] = Vec3(0, 0, 90);
  const auto tipOf = [&](const std::string& transform, const Vec3& p) {
    const Outcome out = runOf("G68.2 X200 Y0 Z50 I90 J30 K0\n" + transform +
                                  fmt::format("\nG54 G0 X{} Y{} Z{}", p.x(), p.y(), p.z()),
                              settings);
    EXPECT_EQ(out.error, "") << transform;
    return Vec3(endOf(out, 3).tip + Vec3(0, 0, 100));
  };
  // (10, 20, 30) of the plane is (197.6795, 10, 85.9808) of the workpiece, and a quarter turn on from there.
  const Vec3 want(-10, 197.6795, 85.9808);
  const struct {
    const char* transform;
    Vec3 p;
  } rows[] = {{"", {10, 20, 30}},
              {"G52 X1 Y2 Z3", {9, 18, 27}},
              {"G17 G68 X0 Y0 R90", {20, -10, 30}},
              {"G51 X0 Y0 Z0 P2", {5, 10, 15}},
              {"G51.1 X0", {-10, 20, 30}}};
  for (const auto& row : rows)
    EXPECT_LT((tipOf(row.transform, row.p) - want).norm(), kPrinted)
        << row.transform << ": " << tipOf(row.transform, row.p).transpose();
}

// 25.19, and measuring moves on tilted planes

const std::string kInPlane =
    "G17 G54 G0 X0 Y0\nG43 Z0 H1\nG68.2 X100 Y100 Z50 I90 J45 K0\nG53.1\nX0 Y0 Z20\nG31 Z-20 F500";

/// The contact on the plane itself, told in all systems.
TEST(MeasuringRows, TheSkipPositionInEverySystem) {
  PlaneProbe surface({100, 100, 50}, {kHalf, 0, kHalf});
  const struct {
    double pcs, tlc;
    Vec3 work, other, machine;
  } rows[] = {
      {0, 0, {276.7767, 100, 76.7767}, {0, -106.0660, 143.9340}, {276.7767, 100, 76.7767}},
      {0, 1, {100, 100, 50}, {0, 0, 0}, {100, 100, 50}},
      {1, 0, {0, -106.0660, 143.9340}, {276.7767, 100, 76.7767}, {276.7767, 100, 76.7767}},
      {1, 1, {0, 0, 0}, {100, 100, 50}, {100, 100, 50}},
  };
  for (const auto& row : rows) {
    ControlSettings settings = machineOf('H');
    settings.parameters["N1755.PCS"] = row.pcs;
    settings.parameters["N1755.TLC"] = row.tlc;
    const Read read = readOf(kInPlane + "\n",
                             {5061, 5062, 5063, 100151, 100152, 100153, 151001, 151002, 151003, 151101,
                              151102, 151103, 5001, 5002, 5003, 5041, 5042, 5043},
                             settings, &surface);
    const Vec3 &w = row.work, &o = row.other, &m = row.machine;
    expectValues(read, {w.x(), w.y(), w.z(), w.x(), w.y(), w.z(), o.x(), o.y(), o.z(), m.x(), m.y(), m.z(), 0,
                        0, 0, w.x(), w.y(), w.z()});
    EXPECT_LT((endOf(read, 6).tip - Vec3(100, 100, 50)).norm(), kPrinted);
  }
}

/// Without a contact the end of the block is told; the next block goes on from there.
TEST(MeasuringRows, WithoutAContactTheEndIsTold) {
  PlaneProbe far_away({0, 0, -1000}, {0, 0, 1});
  ControlSettings settings = machineOf('H');
  settings.parameters["N1755.PCS"] = settings.parameters["N1755.TLC"] = 1;
  const Read read = readOf(kInPlane + "\nG91 X5", {5061, 5062, 5063, 5001, 5003}, settings, &far_away);
  expectValues(read, {0, 0, -20, 5, -20});
}

/// On tables that have turned the contact is told where the plane is now.
TEST(MeasuringRows, OnTurnedTables) {
  PlaneProbe surface({100, 100, 50}, {kHalf, 0, kHalf});
  ControlSettings settings = machineOf('T');
  const Read read = readOf(kInPlane, {5001, 5002, 5003, 151101, 151102, 151103}, settings, &surface);
  expectValues(read, {0, 0, 0, 500, 321.2132, -237.3654});
}

/// Where the tip is held, as without, as long as nothing turns.
TEST(MeasuringRows, UnderTipControl) {
  PlaneProbe wall({30, 0, 0}, {-1, 0, 0});
  const std::string held = "G54 G0 X0 Y0 Z0 B30 C0\nG43.4 H1 X0 Y0 Z0\n";
  ControlSettings settings = machineOf('H');
  settings.parameters["N1755.TLC"] = 1;
  const Read read = readOf(held + "G31 X50 F500", {5061, 5062, 5063, 5001}, settings, &wall);
  expectValues(read, {30, 0, 0, 30});
  expectRefused(held + "G31 X50 B20 F500", settings, "nct-probe-turn");
  expectRefused("G54 G0 X0 Y0 Z0\nG43.5 H1 X0 Y0 Z0\nG31 X50 I1 J0 K1 F500", settings, "nct-probe-turn");
  expectRefused("G54 G0 X0 Y0 Z0\nG43.5 H1 X0 Y0 Z0\nG31 I1 J0 K1 F500", settings, "nct-probe-turn");
}

/// Zeros of the rotary axes leave rounding behind, and no turn: compensation goes on.
TEST(DynamicZeroRows, RoundingTurnsNothing) {
  const Outcome out = runOf(
      "G10 L21 P1 X50 Y0 Z40 A0.1 C0.7\nG54.2 P1 G0 X0 Y0 Z0 A0.2 C0.3\nG41 G1 X10 Y10 D1 "
      "F100\nX20\nY20\nG40 X0",
      settingsOf(trunnion('A'), Vec3(450, 300, -420)));
  EXPECT_EQ(out.error, "");
}

/// The length that is switched on in the block of G31 counts in what it tells.
TEST(MeasuringRows, ALengthOfTheSameBlockCounts) {
  PlaneProbe wall({30, 0, 0}, {-1, 0, 0});
  ControlSettings settings = machineOf('H');
  settings.parameters["N1755.TLC"] = 1;
  const Read read =
      readOf("G54 G0 X0 Y0 Z100 B0 C0\nG43.1 G31 X50 Z0 H1 F500", {5061, 5063}, settings, &wall);
  expectValues(read, {30, 0});
}

/// G37 corrects H by a contact along the tool, and refuses another direction.
TEST(MeasuringRows, ToolLengthOnATiltedPlane) {
  ControlSettings settings = machineOf('H');
  settings.parameters["N3004"] = 10;
  settings.parameters["N3005"] = 5;
  const std::string head = "G17 G54 G0 X0 Y0\nG43 Z0 H1\nG68.2 X100 Y100 Z50 I90 J45 K0\nG53.1\nX0 Y0 Z20\n";
  PlaneProbe gauge(Vec3(100, 100, 50) - 0.2 * Vec3(kHalf, 0, kHalf), {kHalf, 0, kHalf});
  const Read read = readOf(head + "G37 Z0 F100", {10001}, settings, &gauge);
  expectValues(read, {99.8});
  expectRefused(head + "G37 X0 F100", settings, "nct-length-beside-tool");
  expectRefused("G54 G0 X0 Y0 B40\nG43.1 H1 Z50\nG37 Z0 F100", settings, "nct-length-beside-tool");
  expectRefused("G54 G0 X0 Y0 B40\nG43.1 H1 Z50\nG37 B0 F100", settings, "nct-2035");
  EXPECT_EQ(errorOf("G54 G0 X0 Y0 B0\nG43.1 H1 Z50\nG37 Z0 F100", settings), "");
}

/// Planes with a rotary axis and coordinates that follow the rotary axes exclude each other.
TEST(VirtualPlaneRows, AndFiveAxesExcludeEachOther) {
  const std::string polar = "G54 G0 X20 Y0 Z0\nG43 H1 Z50\nG17 X20 C0\nG12.1\n";
  for (const char* code :
       {"G43.1 H1", "G43.4 H1", "G43.5 H1", "G68.1 K1 R10", "G68.2 I10", "G53.1", "G53.6 H1"})
    expectRefused(polar + code, machineOf('T'), "nct-virtual-forbidden");
  expectRefused("G54 G0 X20 Y0 Z0\nG43.4 H1 Z50\nG17 X20 C0\nG12.1", machineOf('T'), "nct-virtual-frame");
  expectRefused("G54 G0 X20 Y0 Z0\nG43.4 H1 Z50\nG17 X20 C0\nG7.1 C20", machineOf('T'), "nct-virtual-frame");
  expectRefused(kRow + "G54.2 P1 G0 X20 C0\nG17 X20 C0\nG12.1", machineOf('T'), "nct-virtual-frame");
}

}  // namespace
}  // namespace five_axis_rows_test
}  // namespace proveout
