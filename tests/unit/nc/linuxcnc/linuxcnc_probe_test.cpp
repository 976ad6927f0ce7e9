// Probing moves against a body, and what the end of a program sets back.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/nc/iso/program/control.h"
#include "core/nc/linuxcnc/dialect.h"
#include "core/nc/linuxcnc/files/lcn_settings.h"
#include "core/nc/linuxcnc/program/lcn_language.h"
#include "tests/unit/nc/linuxcnc/linuxcnc_run.h"

namespace proveout::test {
namespace {

/// Boxes; the tool is a point.
class Boxes : public Probe {
 public:
  explicit Boxes(std::vector<Box3> boxes) : boxes_(std::move(boxes)) {}
  Result<std::optional<double>> firstContact(const Motion& move, const ArcGeometry*,
                                             const AxisSweep*) override {
    std::optional<double> first;
    for (const Box3& box : boxes_) {
      double in = 0.0, out = 1.0;
      for (int k = 0; k < 3; ++k) {
        const double from = move.from[k], way = move.to[k] - from;
        if (way == 0.0) {
          if (from < box.min[k] || from > box.max[k]) out = -1.0;
          continue;
        }
        const double a = (box.min[k] - from) / way, b = (box.max[k] - from) / way;
        in = std::max(in, std::min(a, b));
        out = std::min(out, std::max(a, b));
      }
      if (in <= out && (!first || in < *first)) first = in;
    }
    return first;
  }

 private:
  std::vector<Box3> boxes_;
};

struct ProbeRun {
  Toolpath path;
  ProbeRun(const std::string& lines, Probe& probe) {
    MemoryProgramSource source("main.ngc", "G21 F100\n" + lines + "\nM2\n");
    ToolpathBuilder sink(path);
    ControlHost host;
    host.probe = &probe;
    interpret(ControlId::kLinuxCnc, source, runAtZero(), sink, nullptr, host);
  }
  std::string error() const {
    for (const Diagnostic& d : path.diagnostics.all())
      if (d.severity == Severity::kError) return d.message;
    return {};
  }
  Lines told() const {
    Lines all;
    for (const auto& [before, e] : path.events)
      if (const auto* message = e.as<event::Message>()) all.push_back(message->text);
    return all;
  }
};

// A table below -10, with a rib on it, and a bar over both.
std::vector<Box3> body() {
  return {{Vec3(-100, -100, -20), Vec3(100, 100, -10)},
          {Vec3(20, -100, -20), Vec3(30, 100, -4)},
          {Vec3(-100, -100, 30), Vec3(100, 100, 40)}};
}

// lcn-3-G38.2
TEST(LinuxCncProbe, StopsWhereContactBegins) {
  Boxes boxes(body());
  const ProbeRun run(
      "G38.2 Z-15\n(debug,#5063 #5070 #<_z>)\nG0 Z0\nG38.3 X50\n(debug,#5061 #5070)\nG38.2 Y5 Z5", boxes);
  EXPECT_EQ(run.told(), (Lines{"-10.000000 1.000000 -10.000000", "50.000000 0.000000"}));
  EXPECT_EQ(run.error(), "G38.2 move finished without making contact");
}

// lcn-3-G38.5: straight back, and along the face past its end.
TEST(LinuxCncProbe, StopsWhereContactEnds) {
  Boxes boxes(body());
  const ProbeRun back("G38.2 Z-15\nG38.4 Z5\n(debug,#5063 #5070 #<_z>)\nG0 Z5", boxes);
  EXPECT_EQ(back.error(), "");
  EXPECT_EQ(back.told(), (Lines{"-10.000000 1.000000 -10.000000"}));
  // Up along the rib's wall, whose top is at -4: the touch in X is what holds.
  const ProbeRun along("G0 Z-6\nG38.2 X50\nG38.5 Z4\n#1=[ABS[#5063+4] LT 0.0001]\n(debug,#5061 #1 #5070)",
                       boxes);
  EXPECT_EQ(along.error(), "");
  EXPECT_EQ(along.told(), (Lines{"20.000000 1.000000 1.000000"}));
  // On its way it meets the bar: the first loss counts.
  const ProbeRun first("G0 Z-6\nG38.2 X50\nG38.4 Z60\n#1=[ABS[#5063+4] LT 0.0001]\n(debug,#1 #5070)", boxes);
  EXPECT_EQ(first.told(), (Lines{"1.000000 1.000000"})) << first.error();
}

// lcn-3-G38.5
TEST(LinuxCncProbe, TellsContactThatNeverEndsOrNeverWas) {
  Boxes boxes(body());
  const ProbeRun stays("G0 Z-6\nG38.2 X50\nG38.4 Z-9", boxes);
  EXPECT_EQ(stays.error(), "G38.4 move finished without breaking contact");
  const ProbeRun quiet("G0 Z-6\nG38.2 X50\nG38.5 Z-9\n(debug,#5063 #5070)", boxes);
  EXPECT_EQ(quiet.error(), "");
  EXPECT_EQ(quiet.told(), (Lines{"-9.000000 0.000000"}));
  const ProbeRun clear("G38.4 Z5", boxes);
  EXPECT_EQ(clear.error(), "Probe is already clear when starting G38.4 or G38.5 move");
  const ProbeRun at_once("G38.5 Z5\n(debug,#5063 #5070)", boxes);
  EXPECT_EQ(at_once.error(), "");
  EXPECT_EQ(at_once.told(), (Lines{"0.000000 1.000000"}));
}

/// A channel behind the end of its program.
struct Ended {
  Toolpath path;
  ToolpathBuilder sink{path};
  MemoryProgramSource source;
  ControlSettings settings;
  nc::IsoControl control;
  explicit Ended(const std::string& lines)
      : source("main.ngc", lines),
        settings(nc::withLcnMachine(runAtZero(), lines)),
        control(nc::linuxCncDialect(settings.parameters), source, settings, sink, nullptr, {}) {
    EXPECT_TRUE(control.start());
    while (control.advance() == nc::IsoControl::Turn::kOn) {
    }
  }
  nc::IsoContext& context() { return control.context(); }
  int code(int group) { return context().state.active[static_cast<std::size_t>(group)]; }
  double number(int parameter) {
    return static_cast<nc::LinuxCncLanguage*>(context().language)->variables().number(parameter);
  }
};

// lcn-5-M2: what the interpreter's source sets back.
TEST(LinuxCncEnd, SetsBack) {
  for (const char* end : {"M2", "M30"}) {
    Ended run(std::string("G21 G19 G91 G55 G95 S300 M3 M8 F0.1\nG10 L2 P2 X7\nG55 G0 X3\nG81 Y1 X-1 R2\n") +
              end + "\n");
    nc::IsoState& s = run.context().state;
    EXPECT_EQ(s.work_system, 1) << end;
    EXPECT_EQ(run.code(nc::kGroupPlane), 170);
    EXPECT_EQ(run.code(nc::kGroupDistance), 900);
    EXPECT_EQ(run.code(nc::kGroupFeedMode), 940);
    EXPECT_EQ(run.code(nc::kGroupMotion), 10);
    EXPECT_EQ(s.feed, 0.0);
    EXPECT_EQ(s.spindle_direction, 0);
    EXPECT_FALSE(static_cast<nc::LinuxCncLanguage*>(run.context().language)->coolant());
    EXPECT_EQ(s.workPlane().w, 2);
    // Where the tool stands is told in G54 now.
    EXPECT_NEAR(run.context().position.xyz.x(), run.context().machine.xyz.x(), 1e-12);
  }
  Ended comp("G21 F100 G41.1 D2 G1 X10\nY10\nM2\n");
  EXPECT_EQ(comp.code(nc::kGroupRadiusComp), 400);
  EXPECT_EQ(comp.path.motions.back().to, Vec3(9, 10, 0));
}

// lcn-5-M2: what it leaves.
TEST(LinuxCncEnd, Leaves) {
  Ended run("G20 G7 G90.1 G98 G61 G43.1 Z1 S300\nG92 X2\nG10 L2 P3 X4\nG28.1\n#31=5\nM2\n");
  EXPECT_EQ(run.code(nc::kGroupUnits), 200);
  EXPECT_EQ(run.code(nc::kGroupLathe), 70);
  EXPECT_EQ(run.code(nc::kGroupArcCentre), 901);
  EXPECT_EQ(run.code(nc::kGroupReturn), 980);
  EXPECT_EQ(run.code(nc::kGroupCutting), 610);
  EXPECT_EQ(run.code(nc::kGroupLengthComp), 431);
  EXPECT_NEAR(run.context().state.length.xyz.z(), 25.4, 1e-12);
  EXPECT_EQ(run.context().state.spindle_rpm, 300.0);
  EXPECT_EQ(run.number(31), 5.0);
  // G92 stays in force: X reads 2, as a diameter.
  EXPECT_NEAR(run.context().position.xyz.x(), 25.4, 1e-12);
}

}  // namespace
}  // namespace proveout::test
