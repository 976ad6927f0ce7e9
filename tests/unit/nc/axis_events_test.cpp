// Axes that the machine builder's M codes tie together: the manual's machine of two beams (20.2), exchanged
// and reversed axes, a head that turns, gantry and tandem. Positions are those that the manual's rules give
// by hand.
//
// Rows: nct-20.2-sync nct-20.2-park nct-20.2-MSY nct-20.2-CHAIN nct-20.2-WAIT nct-20.2-SLAVE
// nct-20.3-exchange nct-20.3-MMI nct-20.3-INHERIT nct-20.4-mirror nct-20.4-G53 nct-20.5-head nct-20.6-gantry
// nct-20.6-1008 nct-20.7-tandem nct-20.8-inclined
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/nc/registry/interpreter.h"
#include "core/path/posed_way.h"
#include "tests/support/five_axis_runs.h"
#include "tests/support/linear_axis.h"
#include "tests/support/test_machines.h"

namespace proveout {
namespace {

using test::linearAxisOf;

constexpr double kSame = 1e-9;

MachineEvent eventOf(int code) {
  MachineEvent event;
  event.code = code;
  return event;
}

MachineEvent releaseOf(int code) {
  MachineEvent event = eventOf(code);
  event.release = {AxisMode::kCouple, AxisMode::kPark, AxisMode::kExchange, AxisMode::kReverse,
                   AxisMode::kHead};
  return event;
}

/// The manual's machine: the second tool stands on V and W. M41 couples, M42 exchanges Y and Z, M43 reverses
/// X, M44 and M45 park V and Y, M46 turns the head, M40 ends all of it.
ControlSettings manualMachine() {
  ControlSettings settings;
  settings.axes = {linearAxisOf("V", 4), linearAxisOf("W", 5), linearAxisOf("U", 6, "X")};
  settings.start = Vec3::Zero();
  settings.work_given[0] = true;
  settings.length_offsets[1] = settings.length_offsets[101] = {0.0, 0.0};
  settings.length_offsets[7] = {100.0, 0.0};
  settings.radius_offsets[1] = {5.0, 0.0};
  settings.events = {eventOf(41), eventOf(42), eventOf(43),  eventOf(44),
                     eventOf(45), eventOf(46), releaseOf(40)};
  settings.events[0].couple = {{"Y", "V"}, {"Z", "W"}};
  settings.events[0].opposite = {"V"};
  settings.events[1].exchange = {"Y", "Z"};
  settings.events[2].reverse = {"X"};
  settings.events[3].park = {"V"};
  settings.events[4].park = {"Y"};
  settings.events[5].head = HeadPosition::kHorizontal;
  return settings;
}

/// What a run leaves, and questions about it.
struct Outcome : test::Outcome {
  bool warns(std::string_view code) const {
    const auto& all = path.diagnostics.all();
    return std::any_of(all.begin(), all.end(), [&](const Diagnostic& d) { return d.code == code; });
  }
  /// End of the last motion of a line, from 1; where there is none, far away.
  Vec3 end(std::uint32_t line) const {
    Vec3 to = Vec3::Constant(1e9);
    for (const Motion& m : path.motions) {
      if (m.source.line == line) to = m.to;
    }
    return to;
  }
  Vec3 end() const { return path.motions.empty() ? Vec3(Vec3::Constant(1e9)) : path.motions.back().to; }
  double seconds(std::uint32_t line) const {
    double sum = 0.0;
    for (const Motion& m : path.motions) sum += m.source.line == line ? m.time_s : 0.0;
    return sum;
  }
  std::vector<Motion> of(std::uint32_t line) const {
    std::vector<Motion> motions;
    std::copy_if(path.motions.begin(), path.motions.end(), std::back_inserter(motions),
                 [&](const Motion& m) { return m.source.line == line; });
    return motions;
  }
};

Outcome runOf(const std::string& text, const ControlSettings& settings) {
  return {test::runOf(text, settings)};
}

/// Value of a variable behind the program: it becomes a machine position of X.
double valueOf(const std::string& text, const std::string& variable, const ControlSettings& settings) {
  const Outcome out = runOf(text + "\n#1=" + variable + "\nG40 G90 G53 X[#1+5000]", settings);
  EXPECT_EQ(out.error, "") << text;
  return out.end().x() - 5000.0;
}

void expectEnd(const Outcome& out, std::uint32_t line, const Vec3& to) {
  EXPECT_EQ(out.error, "");
  const Vec3 found = out.end(line);
  EXPECT_LT((found - to).norm(), kSame) << "line " << line << ": " << found.transpose();
}

const std::string kBeforeM41 = "G54 G0 X0 Y0 V0\nG43 Z10 H1\nG43 W10 H101\n";

TEST(CoupledAxes, GoAsInTheManualsExample) {
  const ControlSettings settings = manualMachine();
  const std::string coupled = kBeforeM41 + "M41\n";
  const auto v = [&](const std::string& text) { return valueOf(coupled + text, "#5004", settings); };
  const auto w = [&](const std::string& text) { return valueOf(coupled + text, "#5005", settings); };
  EXPECT_NEAR(v(""), 0.0, kSame);
  EXPECT_NEAR(w(""), 10.0, kSame);
  std::string text = "G1 Z-5 F600";
  EXPECT_NEAR(w(text), -5.0, kSame);  // N2102 MSY = 0
  text += "\nG1 X100";
  EXPECT_NEAR(v(text), 0.0, kSame);
  // MSY = 1: half of the arc, then all of it.
  const double half = 100.0 * std::sqrt(0.5);
  EXPECT_NEAR(v(text + fmt::format("\nG3 X{0:.12f} Y{0:.12f} R100", half)), -half, 1e-6);
  text += "\nG3 X0 Y100 R100";
  EXPECT_NEAR(v(text), -100.0, kSame);
  EXPECT_NEAR(valueOf(coupled + text, "#5024", settings), -100.0, kSame);  // of the machine too
  EXPECT_NEAR(v(text + "\nG1 Y0"), 0.0, kSame);
  EXPECT_NEAR(w(text + "\nG1 Y0"), -5.0, kSame);
}

TEST(CoupledAxes, LeaveThePathOfTheMasterAlone) {
  const std::string text = "G1 Z-5 F600\nG41 G1 X100 D1\nG3 X0 Y100 R100\nG1 Y0\nG40 X-20\n";
  const Outcome alone = runOf(kBeforeM41 + "\n" + text, manualMachine());
  const Outcome coupled = runOf(kBeforeM41 + "M41\n" + text + "M40", manualMachine());
  EXPECT_EQ(coupled.error, "");
  ASSERT_EQ(alone.path.motions.size(), coupled.path.motions.size());
  for (std::size_t k = 0; k < alone.path.motions.size(); ++k) {
    const Motion &a = alone.path.motions[k], &b = coupled.path.motions[k];
    EXPECT_LT((a.to - b.to).norm(), kSame) << k;
    EXPECT_EQ(a.arc >= 0, b.arc >= 0) << k;
    EXPECT_NEAR(a.time_s, b.time_s, 1e-9) << k << ": F is the speed of the programmed axes";
  }
}

TEST(CoupledAxes, AreNotLevelled) {
  const std::string text = "G0 Y5 V30\nM41\nG0 Y15\n";
  EXPECT_NEAR(valueOf(text, "#5004", manualMachine()), 20.0, kSame);
  EXPECT_NEAR(valueOf(text + "M40\nG0 Y0", "#5004", manualMachine()), 20.0, kSame);  // released, it stays
  EXPECT_NEAR(valueOf(text + "M40\nG0 Y0 V7\nM41\nG91 Y1", "#5004", manualMachine()), 6.0, kSame);
}

TEST(CoupledAxes, ASlaveMayBeAMasterItself) {
  ControlSettings settings = manualMachine();
  settings.events[0].couple = {{"V", "W"}, {"Y", "V"}};  // in any order
  settings.events[0].opposite = {"V", "W"};
  const std::string text = "G0 Y1 V0 W2\nM41\nG0 Y4\n";
  EXPECT_NEAR(valueOf(text, "#5004", settings), -3.0, kSame);
  EXPECT_NEAR(valueOf(text, "#5005", settings), 5.0, kSame);
}

TEST(CoupledAxes, ASlaveIsNotProgrammed) {
  for (const char* block : {"G0 V1", "G1 X1 V1 F100", "G53 V1", "G28 V0", "G91 G0 W1"}) {
    const Outcome out = runOf(std::string("M41\n") + block, manualMachine());
    EXPECT_EQ(out.error.find("nct-slave-axis: axis "), 0u) << block << ": " << out.error;
    const Outcome free = runOf(std::string("M41\nM40\n") + block, manualMachine());
    EXPECT_EQ(free.error, "") << block;
  }
  EXPECT_EQ(runOf("M41\nG0 Y1 Z1", manualMachine()).error, "");
}

/// A slave that moves the tool as well: the tool goes twice as far along X, and a circle becomes an ellipse.
TEST(CoupledAxes, OfOneToolAddUp) {
  ControlSettings settings = manualMachine();
  settings.events[0].couple = {{"X", "U"}};
  settings.events[0].opposite.clear();
  const Outcome out = runOf("M41\nG1 X10 F600\nG3 X0 Y10 R10", settings);
  expectEnd(out, 2, {20, 0, 0});
  EXPECT_NEAR(out.seconds(2), 1.0, 1e-9);  // 10 mm at 10 mm/s
  expectEnd(out, 3, {0, 10, 0});
  ASSERT_GT(out.of(3).size(), 5u);
  for (const Motion& m : out.of(3)) {
    const double x = 0.5 * m.to.x();
    EXPECT_NEAR(std::hypot(x, m.to.y()), 10.0, 1e-3);
  }
  EXPECT_NEAR(out.seconds(3), 0.5 * kPi * 10.0 / 10.0, 1e-6);
}

TEST(CoupledAxes, WaitForOtherChannels) {
  const std::vector<std::string> texts = {
      "G0 Y1\nG4 P2\nM502 P12\nM41\nM503 P12\nG0 Y11\n#1=#5004\nG53 X[#1+5000]\nM30\n",
      "M502 P12\nM503 P12\nG0 X3\nM30\n"};
  Outcome out;
  ToolpathBuilder sink(out.path);
  std::vector<std::unique_ptr<MemoryProgramSource>> sources;
  std::vector<ChannelProgram> programs;
  for (const std::string& text : texts) {
    sources.push_back(std::make_unique<MemoryProgramSource>("p.nc", text));
    programs.push_back({sources.back().get(), manualMachine()});
    programs.back().settings.channel = static_cast<int>(programs.size());
    programs.back().settings.parameters = {{"N2201", 500}, {"N2202", 599}};
  }
  out.summary = interpretChannels(ControlId::kNct, programs, sink);
  EXPECT_EQ(out.summary.errors, 0);
  // The other channel goes on behind the coupling only.
  std::size_t coupling = 1000;
  for (const Toolpath::EventAt& at : out.path.events) {
    const auto* function = std::get_if<event::Function>(&at.event.what);
    if (function != nullptr && function->code == "M41") coupling = at.before;
  }
  bool seen = false;
  for (std::size_t k = 0; k < out.path.motions.size(); ++k) {
    const Motion& m = out.path.motions[k];
    if (m.channel == 2) {
      seen = true;
      EXPECT_GE(k, coupling);
    }
    if (m.channel == 1 && m.source.line == 8) {
      EXPECT_NEAR(m.to.x(), 5000.0 - 10.0, kSame);
    }
  }
  EXPECT_TRUE(seen);
}

TEST(CoupledAxes, TakeOneMasterAtATime) {
  ControlSettings settings = manualMachine();
  settings.events[1] = eventOf(42);
  settings.events[1].couple = {{"Z", "V"}};
  EXPECT_NE(runOf("M41\nM42", settings).error.find("axis V follows Y already"), std::string::npos);
  settings.events[1].couple = {{"V", "Y"}};
  EXPECT_NE(runOf("M41\nM42", settings).error.find("would follow itself"), std::string::npos);
  EXPECT_EQ(runOf("M41\nM41\nG0 Y1", settings).error, "");
}

TEST(ParkedAxes, AreComputedButNotMoved) {
  const std::string text = "G0 X0 Y0 V0\nM44\nM41\nG0 Y10\n";
  EXPECT_NEAR(valueOf(text, "#5004", manualMachine()), -10.0, kSame);          // computed
  EXPECT_NEAR(valueOf(text + "M40\n", "#5004", manualMachine()), 0.0, kSame);  // it has never moved
  // The master parked: the slave goes all the same, and of the arc the tool makes only the part along X.
  const std::string master = "G0 X0 Y0 V0\nM41\nM45\nG1 X10 Y5 F600\nG3 X0 Y15 R10 F600\n";
  EXPECT_NEAR(valueOf(master, "#5004", manualMachine()), -15.0, kSame);
  EXPECT_NEAR(valueOf(master + "M40\n", "#5002", manualMachine()), 0.0, kSame);
  const Outcome out = runOf(master, manualMachine());
  expectEnd(out, 4, {10, 0, 0});
  EXPECT_NEAR(out.seconds(4), std::hypot(10.0, 5.0) / 10.0, 1e-9);
  expectEnd(out, 5, {0, 0, 0});
  EXPECT_NEAR(out.seconds(5), 0.5 * kPi, 1e-6);
  for (const Motion& m : out.of(5)) EXPECT_EQ(m.to.y(), 0.0);
  // Half of the time, not half of the way: the arc's middle is at X7.07.
  double time = 0.0;
  for (const Motion& m : out.of(5)) {
    time += m.time_s;
    EXPECT_NEAR(m.to.x(), 10.0 * std::cos(time), 1e-3);
  }
}

TEST(ExchangedAxes, MoveByEachOthersWords) {
  const Outcome out =
      runOf("G0 X0 Y0 Z0\nM42\nG0 Y5\nG0 Z7\nG17 G2 X10 Y15 I10 J0 F600\nM40\nG0 Z1", manualMachine());
  expectEnd(out, 3, {0, 0, 5});
  expectEnd(out, 4, {0, 7, 5});
  expectEnd(out, 5, {10, 7, 15});
  expectEnd(out, 7, {10, 7, 1});
  ASSERT_EQ(out.of(5).size(), 1u);
  // Clockwise in X and Y of the program: the arc's middle lies to the upper left.
  const Motion arc = out.of(5).front();
  ASSERT_GE(arc.arc, 0);
  const ArcGeometry& geometry = out.path.arcs[static_cast<std::size_t>(arc.arc)];
  const Vec3 middle = arcPoint(arcFrame(arc.from, arc.to, geometry), geometry, 0.5);
  const double r = 10.0 * std::sqrt(0.5);
  EXPECT_LT((middle - Vec3(10 - r, 7, 5 + r)).norm(), 1e-6) << middle.transpose();
}

TEST(ExchangedAxes, MayGoTheOtherWay) {
  ControlSettings settings = manualMachine();
  settings.events[1].reverse = {"Z"};  // the axis: it moves by Y
  const Outcome out = runOf("G0 X0 Y0 Z0\nM42\nG0 Y5 Z2\nG2 X10 Y15 R10 F600", settings);
  expectEnd(out, 3, {0, 2, -5});
  expectEnd(out, 4, {10, 2, -15});
  ASSERT_EQ(out.of(4).size(), 1u);
  const Motion arc = out.of(4).front();
  const ArcGeometry& geometry = out.path.arcs[static_cast<std::size_t>(arc.arc)];
  const Vec3 middle = arcPoint(arcFrame(arc.from, arc.to, geometry), geometry, 0.5);
  const double r = 10.0 * std::sqrt(0.5);
  EXPECT_LT((middle - Vec3(10 - r, 2, -5 - r)).norm(), 1e-6) << middle.transpose();
}

TEST(ExchangedAxes, KeepTheirOffsets) {
  ControlSettings settings = manualMachine();
  settings.work_offsets[1] = {1, 10, 20};
  settings.work_given[1] = true;
  // The zero of G55 is that of the axes: Y now moves the axis whose zero is 20.
  EXPECT_NEAR(valueOf("M42\nG55 G0 Y3\n", "#5022", settings), 23.0, kSame);
  const Outcome out = runOf("G55 G0 X0 Y0 Z0\nM42\nG0 Y3 Z4", settings);
  expectEnd(out, 3, {1, 14, 23});
  // A length on Z appears on Y, and the control says what the manual advises.
  const std::string length = "G0 Z0\nG43 Z0 H7\nM42\n";
  EXPECT_NEAR(valueOf(length, "#5082", settings), 100.0, kSame);
  EXPECT_NEAR(valueOf(length, "#5083", settings), 0.0, kSame);
  EXPECT_NEAR(valueOf(length + "G0 Y2\n", "#5022", settings), 102.0, kSame);
  EXPECT_TRUE(runOf(length, settings).warns("nct-axis-length"));
  EXPECT_FALSE(runOf("G43 Z0 H7\nG49\nM42", settings).warns("nct-axis-length"));
}

TEST(ExchangedAxes, OneToolOverAnother) {
  ControlSettings settings = manualMachine();
  settings.events[1].exchange = {"Y", "V"};
  const Outcome out = runOf("M42\nG1 Y5 X1 F600\nV3\nG3 X0 Y6 R1", settings);
  expectEnd(out, 2, {1, 0, 0});
  expectEnd(out, 3, {1, 3, 0});
  expectEnd(out, 4, {0, 3, 0});
}

TEST(ReversedAxes, GoAgainstTheirDirection) {
  ControlSettings settings = manualMachine();
  settings.work_offsets[1] = {50, 0, 0};
  settings.work_given[1] = true;
  const Outcome out =
      runOf("G55 G0 X0 Y0\nM43\nG0 X10\nG91 X5\nG90 G2 X25 Y10 R10 F600\nM40\nG0 X1", settings);
  expectEnd(out, 3, {40, 0, 0});
  expectEnd(out, 4, {35, 0, 0});
  expectEnd(out, 5, {25, 10, 0});
  const Motion arc = out.of(5).front();
  const ArcGeometry& geometry = out.path.arcs[static_cast<std::size_t>(arc.arc)];
  const Vec3 middle = arcPoint(arcFrame(arc.from, arc.to, geometry), geometry, 0.5);
  const double r = 10.0 * std::sqrt(0.5);  // in the program the centre is at X25 Y0
  EXPECT_LT((middle - Vec3(50 - (25 - r), r, 0)).norm(), 1e-6) << middle.transpose();
  expectEnd(out, 7, {51, 10, 0});
}

TEST(ReversedAxes, GoToPlacesOfTheMachineAsEver) {
  ControlSettings settings = manualMachine();
  settings.reference_points[0] = Vec3(300, 0, 0);
  settings.reference_points[1] = Vec3(200, 0, 0);
  const Outcome out = runOf("M43\nG53 X7\nG0 X7\nG28 X10\nG30 P2 X20\nG0 X1", settings);
  expectEnd(out, 2, {7, 0, 0});
  expectEnd(out, 3, {-7, 0, 0});
  ASSERT_EQ(out.of(4).size(), 2u);
  EXPECT_EQ(out.of(4)[0].to.x(), -10.0);  // the point between is one of the program
  expectEnd(out, 4, {300, 0, 0});
  expectEnd(out, 5, {200, 0, 0});
  expectEnd(out, 6, {-1, 0, 0});
}

/// The manual's template: the program is the same for both positions of the head.
TEST(Head, TurnsTheProgramWithIt) {
  ControlSettings settings = manualMachine();
  settings.machine = test::plainMachine();
  for (const char* name : {"V", "W", "U"}) {
    MachineAxis axis;
    axis.name = name;
    axis.side = AxisSide::kNothing;
    settings.machine->axes.push_back(axis);
  }
  settings.work_offsets[1] = {10, 20, 30};
  settings.work_given[1] = true;
  settings.gauge_lengths[1] = 100.0;
  settings.tool = 1;
  const std::string part = "G43 Z50 H7\nG0 X3 Y4\nG1 Z-2 F600\nG2 X13 Y14 I10 J0\nG0 Z50\nG49 G53 Z200\n";
  const Outcome out = runOf("G54\n" + part + "M46\nG55\n" + part + "M40\nG54\n" + part, settings);
  EXPECT_EQ(out.error, "");
  // Upright: the tip is at the program's own coordinates.
  expectEnd(out, 4, {3, 4, -2});
  expectEnd(out, 5, {13, 14, -2});
  // Lying: X against its direction, Y up, the tool along Y; its tip lies at the zero of G55 by the length.
  expectEnd(out, 12, {10 - 3, 20 - 2, 30 + 4});
  expectEnd(out, 13, {10 - 13, 20 - 2, 30 + 14});
  const Motion arc = out.of(13).front();
  ASSERT_GE(arc.arc, 0);
  ASSERT_GE(arc.axis, 0);
  EXPECT_EQ(out.path.axes[static_cast<std::size_t>(arc.axis)].to, Vec3::UnitY());
  const ArcGeometry& geometry = out.path.arcs[static_cast<std::size_t>(arc.arc)];
  const Vec3 middle = arcPoint(arcFrame(arc.from, arc.to, geometry), geometry, 0.5);
  const double r = 10.0 * std::sqrt(0.5);
  EXPECT_LT((middle - Vec3(10 - (13 - r), 18, 30 + 4 + r)).norm(), 1e-6) << middle.transpose();
  // And upright again.
  expectEnd(out, 20, {3, 4, -2});
  EXPECT_LT(out.path.motions.back().axis, 0);
}

/// Compensation, cycles, corners, rotation and mirroring too: the path is the upright one, turned.
TEST(Head, TurnsAllThatAProgramDoes) {
  ControlSettings settings = manualMachine();
  settings.work_offsets[1] = {10, 20, 30};
  settings.work_given[1] = true;
  const std::string part =
      "G43 Z50 H1\nG0 X-20 Y-20\nG1 Z-2 F600\nG41 D1 X0 Y0\nY30,C4\nX40,R5\nG2 X50 Y20 I0 J-10\nG1 Y0\n"
      "X0\nG40 X-20 Y-20\nG83 X5 Y6 Z-12 R2 Q4 F100\nX9\nG80\nG68 X0 Y0 R30\nG1 X3 Y4 F500\nG3 X13 Y14 R10\n"
      "G69\nG51.1 X2\nG1 X7 Y1\nG2 X17 Y11 R10 Z3\nG50.1 X0\nG18 G3 X27 Z13 R30\nG17 G91 G0 Z20\nG90 G52 X1 "
      "Y2 "
      "Z3\nG0 X0 Y0\nG52 X0 Y0 Z0\n";
  const Outcome upright = runOf("G54\n" + part, settings), lying = runOf("M46 G55\n" + part, settings);
  EXPECT_EQ(upright.error, "");
  EXPECT_EQ(lying.error, "");
  const auto turned = [](const Vec3& p) { return Vec3(10 - p.x(), 20 + p.z(), 30 + p.y()); };
  const auto middle = [](const Outcome& run, const Motion& m) {
    if (m.arc < 0) return Vec3(0.5 * (m.from + m.to));
    const ArcGeometry& arc = run.path.arcs[static_cast<std::size_t>(m.arc)];
    return arcPoint(arcFrame(m.from, m.to, arc), arc, 0.5);
  };
  // The first motion of each starts where the machine stands.
  ASSERT_EQ(upright.path.motions.size(), lying.path.motions.size());
  ASSERT_GT(upright.path.motions.size(), 40u);
  for (std::size_t k = 2; k < upright.path.motions.size(); ++k) {
    const Motion &a = upright.path.motions[k], &b = lying.path.motions[k];
    EXPECT_EQ(a.kind, b.kind) << k;
    EXPECT_LT((turned(a.to) - b.to).norm(), 1e-7) << k << ", line " << a.source.line;
    EXPECT_LT((turned(middle(upright, a)) - middle(lying, b)).norm(), 1e-7)
        << k << ", line " << a.source.line;
    EXPECT_NEAR(a.time_s, b.time_s, 1e-9) << k;
  }
}

TEST(Head, HasAPlaceOfItsOwn) {
  ControlSettings settings = manualMachine();
  settings.events[5].gauge = Vec3(0, -30, 40);
  const Outcome out = runOf("M46\nG0 X0 Y0 Z1", settings);
  expectEnd(out, 2, {0, -29, 40});
}

TEST(Head, RefusesAxesThatAreExchangedAlready) {
  EXPECT_NE(runOf("M42\nM46", manualMachine()).error.find("release that before the head turns"),
            std::string::npos);
  EXPECT_NE(runOf("M46\nM42", manualMachine()).error.find("the horizontal head has exchanged"),
            std::string::npos);
  EXPECT_EQ(runOf("M46\nM46\nM40\nM42", manualMachine()).error, "");
}

TEST(AxisModes, ChangeOnlyWhereNothingHangsOnThem) {
  for (const char* before : {"G41 D1 G1 X5 F600", "G81 Z-1 R1 F100", "G68.2 I0 J0 K90"}) {
    for (const char* code : {"M42", "M43", "M46"}) {
      const Outcome out = runOf(fmt::format("{}\nX9\n{}", before, code), manualMachine());
      EXPECT_EQ(out.error.find("nct-axis-mode: " + std::string(code)), 0u)
          << before << " " << code << out.error;
    }
  }
  EXPECT_EQ(runOf("M42\nG68.2 I0 J0 K90", manualMachine()).error.find("nct-axis-mode: "), 0u);
  EXPECT_EQ(runOf("M42\nM40\nG68.2 I0 J0 K90", manualMachine()).error, "");
}

TEST(AxisModes, WithoutThemAProgramKeepsItsPath) {
  const std::string text = "G0 X1 Y2 Z3\nG43 Z5 H7\nG1 X9 F300\nG2 X19 Y12 R10\nG49\nG28 X0\n";
  ControlSettings none = manualMachine();
  none.events.clear();
  const Outcome a = runOf(text, none), b = runOf(text + "M42\nM40\n", manualMachine());
  ASSERT_EQ(a.path.motions.size(), b.path.motions.size());
  for (std::size_t k = 0; k < a.path.motions.size(); ++k)
    EXPECT_EQ(a.path.motions[k].to, b.path.motions[k].to);
}

TEST(AxisModes, CodesOfTheControlStayItsOwn) {
  ControlSettings settings = manualMachine();
  settings.events[0].code = 3;
  EXPECT_NE(runOf("G0 X1", settings).error.find("M3 means something to the control already"),
            std::string::npos);
}

TEST(Drives, OfOneAxisAreOneAxis) {
  for (const bool gantry : {true, false}) {
    ControlSettings settings = manualMachine();
    settings.events.clear();
    settings.start = {12, 0, 0};
    settings.axes[2] = linearAxisOf("U", 6);
    (gantry ? settings.gantry : settings.tandem) = {{"X", "U"}};
    // Level with the master from power-on.
    EXPECT_NEAR(valueOf("", "#5026", settings), 12.0, kSame);
    EXPECT_NEAR(valueOf("G0 X30 Y4\nG1 X40 F600\nG3 X30 Y14 R10", "#5026", settings), 30.0, kSame);
    EXPECT_EQ(runOf("G0 U1", settings).error.find("nct-slave-axis: axis U follows X"), 0u);
    const Outcome out = runOf("G1 X22 F600", settings);
    EXPECT_NEAR(out.seconds(1), 1.0, 1e-9);
    settings.events = {releaseOf(40), eventOf(41)};
    settings.events[1].couple = {{"Y", "V"}};
    EXPECT_EQ(runOf("M41\nM40\nG0 U1", settings).error.find("nct-slave-axis: "), 0u) << "nothing parts them";
  }
}

/// No drive lags behind: alarm 1008 does not come, and N0200, which levels the second drive, is noted.
TEST(DrivesOfOneAxis, AreAlwaysLevel) {
  ControlSettings settings = manualMachine();
  settings.events.clear();
  settings.axes[2].parallel.clear();
  settings.gantry = {{"X", "U"}};
  settings.parameters["N0200.6"] = 0.02;
  const Outcome out = runOf("G0 X30\nG1 X40 F600\nG28 X0", settings);
  EXPECT_EQ(out.error, "");
  EXPECT_TRUE(out.warns("nct-noted"));
  EXPECT_FALSE(out.warns("nct-1008"));
  EXPECT_NEAR(valueOf("G0 X30\nG1 X40 F600", "#5026", settings), 40.0, kSame);
}

/// N2101 to N2105 say a part of what [[machine.event]], gantry and tandem say: they are refused with that
/// key.
TEST(TiedAxes, AreNotSetByParameters) {
  const struct {
    const char *name, *instead;
  } rows[] = {{"N2101", "couple = "},       {"N2101.5", "gantry = "},       {"N2102.MSY.5", "opposite = "},
              {"N2102.PSN.5", "gantry = "}, {"N2103", "[[machine.event]]"}, {"N2104.5", "exchange = "},
              {"N2105.MMI.5", "reverse = "}};
  for (const auto& row : rows) {
    ControlSettings settings = manualMachine();
    settings.parameters[row.name] = 1;
    const std::string error = runOf("G0 X1", settings).error;
    EXPECT_NE(error.find(std::string("parameter ") + row.name), std::string::npos) << error;
    EXPECT_NE(error.find("is not set by its number"), std::string::npos) << error;
    EXPECT_NE(error.find(row.instead), std::string::npos) << error;
  }
  // Nor does a program set or read them.
  EXPECT_NE(runOf("G10 L52\nN2104 P5 R4\nG11", manualMachine()).error, "");
  EXPECT_NE(runOf("#1=PRM[2101,5]", manualMachine()).error, "");
}

TEST(InclinedAxes, AreRefused) {
  ControlSettings settings;
  settings.machine = test::plainMachine();
  settings.machine->axes[1].direction = Vec3(0, 0.6, 0.8);
  EXPECT_EQ(runOf("G0 X1", settings).error.find("nct-inclined-axis: axes Y and Z stand at 36.8699 degrees"),
            0u);
  settings.machine->axes[2].direction = Vec3(0, -0.8, 0.6);
  EXPECT_EQ(runOf("G0 X1", settings).error, "");
}

TEST(OtherControls, TieNoAxesTogether) {
  Toolpath path;
  ToolpathBuilder sink(path);
  const auto summary =
      interpret(ControlId::kWl4Mill, MemoryProgramSource("main.nc", "G0 X1\nM30\n"), manualMachine(), sink);
  EXPECT_EQ(summary.errors, 1);
}

/// A table that turns before the head does and after it: each way is by the head that stands there.
TEST(Head, WaysOfATableAreByTheOneInHand) {
  ControlSettings settings = manualMachine();
  AxisSettings table = linearAxisOf("A", 7);
  table.kind = AxisKind::kRotary;
  table.carries = RotaryCarries::kPart;
  settings.axes.push_back(table);
  const Outcome out = runOf("G0 Z40\nG1 F500 Y10 A30\nM46\nG1 X10 Y70 Z20 A75", settings);
  ASSERT_EQ(out.error, "");
  int posed = 0;
  for (const Motion& m : out.path.motions) {
    if (m.axis < 0 || out.path.axes[static_cast<std::size_t>(m.axis)].pose == nullptr) continue;
    ++posed;
    const ToolPose end = posedWayOf(out.path, m).at(1.0);
    EXPECT_LT((end.tip - m.to).norm(), kSame) << m.source.line;
    EXPECT_LT((end.axis - out.path.axes[static_cast<std::size_t>(m.axis)].to).norm(), kSame) << m.source.line;
  }
  EXPECT_EQ(posed, 2);
}

}  // namespace
}  // namespace proveout
