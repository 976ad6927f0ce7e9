// What the end of a program leaves behind in a Fanuc-like mill. Proves fan-1-reset fan-1-poweron
#include <gtest/gtest.h>

#include <memory>

#include "core/nc/fanuc/dialect.h"
#include "core/nc/iso/program/control.h"

namespace proveout::nc {
namespace {

/// A control that has run a program to its end.
class FanucEnded {
 public:
  explicit FanucEnded(const std::string& program, std::map<std::string, double> parameters = {})
      : source_("main.nc", program) {
    settings_.parameters = std::move(parameters);
    settings_.start = Vec3::Zero();
    control_ = std::make_unique<IsoControl>(fanucMillDialect(settings_.parameters), source_, settings_, sink_,
                                            nullptr, ControlHost{});
    EXPECT_TRUE(control_->run().ok()) << program;
  }
  IsoContext& c() { return control_->context(); }
  int code(IsoGroup group) { return c().state.active[static_cast<std::size_t>(group)]; }

 private:
  MemoryProgramSource source_;
  ControlSettings settings_;
  Toolpath path_;
  ToolpathBuilder sink_{path_};
  std::unique_ptr<IsoControl> control_;
};

// fan-1-reset
TEST(FanucReset, TheEndClearsSomeAndLeavesSome) {
  FanucEnded run(
      "O1\nG20 G91 G18 G1 X1. F10. G95 G98\nG52 X5.\nG92 Y7.\nG68 X0 Z0 R30.\n"
      "G43 H1 Y1.\nM30\n");
  EXPECT_EQ(run.code(kGroupUnits), 210);
  EXPECT_EQ(run.code(kGroupDistance), 900);
  EXPECT_EQ(run.code(kGroupPlane), 170);
  EXPECT_EQ(run.code(kGroupMotion), 0);
  EXPECT_EQ(run.code(kGroupFeedMode), 940);
  EXPECT_EQ(run.code(kGroupRotation), 690);
  EXPECT_EQ(run.code(kGroupLengthComp), 490);
  EXPECT_EQ(run.c().registers.frames.shift52.xyz.x(), 0.0);
  EXPECT_NE(run.c().registers.frames.shift92.xyz.y(), 0.0);
}

TEST(FanucReset, ShiftsStayOrGoAsTheJobSays) {
  const std::string program = "O1\nG21 G52 X5.\nG92 Y7.\nM30\n";
  FanucEnded keep(program, {{"g52_at_end", 1.0}});
  EXPECT_EQ(keep.c().registers.frames.shift52.xyz.x(), 5.0);
  FanucEnded clear(program, {{"g92_at_end", 0.0}});
  EXPECT_EQ(clear.c().registers.frames.shift92.xyz.y(), 0.0);
}

// fan-1-poweron
TEST(FanucReset, TheEndGoesBackToTheSettingsOfPowerOn) {
  FanucEnded run("O1\nG21 G90 G17 G0 X1.\nM30\n", {{"power_on_units", 1.0},
                                                   {"power_on_plane", 19.0},
                                                   {"power_on_motion", 1.0},
                                                   {"power_on_distance", 1.0}});
  EXPECT_EQ(run.code(kGroupUnits), 200);
  EXPECT_EQ(run.code(kGroupPlane), 190);
  EXPECT_EQ(run.code(kGroupMotion), 10);
  EXPECT_EQ(run.code(kGroupDistance), 910);
  EXPECT_EQ(run.c().state.axes.plane_u, 1);
}

}  // namespace
}  // namespace proveout::nc
