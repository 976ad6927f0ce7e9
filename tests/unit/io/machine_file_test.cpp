// Machine files with a chain of axes: what is read, and what is refused with its key and line.
#include "io/job/machine_file.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "machine_text.h"

namespace proveout {
namespace {

using namespace io_test;

TEST(MachineFile, IsReadAsAChain) {
  const ReadMachine read = readMachineText(kGoodMachine);
  ASSERT_EQ(read.error, "");
  const ControlSettings& settings = read.job.settings;
  ASSERT_TRUE(settings.machine);
  const MachineModel& m = *settings.machine;
  ASSERT_EQ(m.axes.size(), 5u);
  EXPECT_EQ(m.axes[3].name, "A");
  EXPECT_TRUE(m.axes[3].left);
  EXPECT_EQ(m.axes[4].on, 3);
  EXPECT_EQ(m.axes[4].direction, Vec3::UnitZ());  // by its letter
  EXPECT_FALSE(m.axes[4].left);
  EXPECT_TRUE(m.axes[4].clamped);
  EXPECT_EQ(m.spindle.on, 2);
  EXPECT_EQ(m.spindle.gauge, Vec3(0, 0, 20));
  ASSERT_EQ(m.bodies.size(), 1u);
  EXPECT_EQ(m.bodies[0].on, 3);
  // What the control sees of it.
  ASSERT_TRUE(settings.limits[0]);
  EXPECT_EQ(settings.limits[0]->max, 810);
  EXPECT_EQ(settings.rapid_mm_min.x(), 30000);
  ASSERT_EQ(settings.axes.size(), 2u);
  EXPECT_EQ(settings.axes[0].name, "A");
  EXPECT_EQ(settings.axes[0].number, 4);
  EXPECT_EQ(settings.axes[1].number, 5);
  ASSERT_TRUE(settings.axes[0].limit);
  EXPECT_EQ(settings.axes[0].limit->min, -120);
}

TEST(MachineFile, InclinedAxes) {
  const ReadMachine read = readMachineText(inGoodMachine(
      "direction = [1, 0, 0]", "inclination = { from = \"Y\", toward = \"Z\", degrees = -45 }"));
  ASSERT_EQ(read.error, "");
  const Vec3 direction = read.job.settings.machine->axes[3].direction;
  EXPECT_LT((direction - Vec3(0, std::sqrt(0.5), -std::sqrt(0.5))).norm(), 1e-15);
}

TEST(MachineFile, WhatIsWrongIsToldWithKeyAndLine) {
  const struct {
    const char *from, *to;
    int line;
    const char* word;
  } rows[] = {
      {"machine/1", "machine/2", 1, "schema"},
      {"on = \"A\"\ncarries", "on = \"Q\"\ncarries", 22, "'Q'"},
      {"on = \"A\"\ncarries", "on = \"C\"\ncarries", 22, "itself"},
      {"on = \"A\"\ncarries", "on = \"Z\"\ncarries", 22, "tool"},
      {"on = \"X\"", "on = \"Z\"", 9, "itself"},
      {"on = \"Y\"", "on = \"A\"", 12, "part"},
      {"direction = [1, 0, 0]", "direction = [0, 0, 0]", 16, "length 1"},
      {"direction = [1, 0, 0]", "direction = [1, 1, 0]", 16, "length 1"},
      {"direction = [1, 0, 0]", "direction = [1, 0]", 16, "direction"},
      {"direction = [1, 0, 0]", "direction = [nan, 0, 0]", 16, "nan"},
      {"direction = [1, 0, 0]", "direction = \"X\"", 16, "direction"},
      {"direction = [1, 0, 0]", "inclination = { from = \"Y\", toward = \"Y\", degrees = 4 }", 16, "another"},
      {"direction = [1, 0, 0]", "inclination = { from = \"Y\", toward = \"Z\" }", 16, "degrees"},
      {"direction = [1, 0, 0]", "inclination = { from = \"W\", toward = \"Z\", degrees = 1 }", 16, "from"},
      {"travel = [-120, 30]", "travel = [30, -120]", 19, "travel"},
      {"travel = [-120, 30]", "travel = [30, 30]", 19, "travel"},
      {"travel = [-120, 30]", "travel = 30", 19, "travel"},
      {"travel = [-120, 30]", "travel = [-1e9, 30]", 19, "travel"},
      {"travel = [-120, 30]", "travel = [-120, 30, 40]", 19, "travel"},
      {"step = 1.0", "step = 7", 25, "step"},
      {"step = 1.0", "step = 0", 25, "step"},
      {"step = 1.0", "step = -1", 25, "step"},
      {"step = 1.0", "step = nan", 25, "step"},
      {"clamped = true", "clamped = 1", 26, "clamped"},
      {"clamped = true", "clampd = true", 26, "clamped"},
      {"name = \"C\"", "name = \"A\"", 21, "twice"},
      {"name = \"C\"", "name = 5", 21, "name"},
      {"sense = \"left\"", "sense = \"lft\"", 18, "left"},
      {"carries = \"part\"\ndirection", "carries = \"table\"\ndirection", 15, "carries"},
      {"point = [400, 300, -500]", "pont = [400, 300, -500]", 13, "point"},
      {"point = [400, 300, -500]", "point = [400, 300]", 17, "point"},
      {"point = [400, 300, -500]", "point = [400, 300, inf]", 17, "inf"},
      {"rapid = 30000", "rapid = 0", 6, "rapid"},
      {"rapid = 30000", "rapid = 1e12", 6, "rapid"},
      {"rapid = 30000", "acceleration = -3", 6, "acceleration"},
      {"[spindle]\non = \"Z\"", "[spindle]\non = \"W\"", 28, "'W'"},
      {"[spindle]\non = \"Z\"", "[spindle]\non = \"A\"", 28, "tool"},
      {"[spindle]\non = \"Z\"", "[spindle]\non = \"Y\"", 10, "between"},
      {"gauge = [0, 0, 20]", "gauge = [0, 0]", 29, "gauge"},
      {"gauge = [0, 0, 20]", "direction = [0, 0, 0]", 29, "length 1"},
      {"on = \"A\"\nbox", "on = \"K\"\nbox", 32, "'K'"},
      {"box = [[0, 0, -600], [800, 600, -520]]", "box = [[0, 0, 0], [800, 600, -520]]", 33, "above"},
      {"box = [[0, 0, -600], [800, 600, -520]]", "box = [0, 0]", 33, "box"},
      {"box = [[0, 0, -600], [800, 600, -520]]", "mesh = \"nothing.stl\"", 33, "nothing.stl"},
      {"box = [[0, 0, -600], [800, 600, -520]]", "cylinder = { from = [0,0,0], to = [0,0,0], radius = 1 }",
       33, "one point"},
      {"box = [[0, 0, -600], [800, 600, -520]]", "cylinder = { from = [0,0,0], to = [0,0,1], radius = 0 }",
       33, "radius"},
      {"name = \"X\"", "name = \"U\"", 9, "'X'"},
      {"name = \"C\"", "name = \"AXN\"", 21, "axis name"},
  };
  for (const auto& row : rows) {
    const ReadMachine read = readMachineText(inGoodMachine(row.from, row.to));
    EXPECT_TRUE(read.error.starts_with(fmt::format("{} ", row.line))) << row.to << ": " << read.error;
    EXPECT_NE(read.error.find(row.word), std::string::npos) << row.to << ": " << read.error;
    EXPECT_FALSE(read.job.settings.machine) << row.to;
  }
}

TEST(MachineFile, ATextCutAnywhereIsNoCrashAndNoHalfMachine) {
  for (std::size_t length = 0; length < kGoodMachine.size(); length += 7) {
    const ReadMachine read = readMachineText(kGoodMachine.substr(0, length));
    EXPECT_TRUE(length >= kGoodMachine.find("[spindle]") || !read.job.settings.machine) << length;
  }
}

}  // namespace
}  // namespace proveout
