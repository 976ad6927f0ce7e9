// Machine files with a chain of axes: what is read, and what is refused with its key and line.
#include "io/job/machine_file.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/machine/machine_chain.h"
#include "io/job/job.h"

namespace proveout {
namespace {

namespace fs = std::filesystem;

/// Line numbers of the tests below count from 1 in this text.
const std::string kGood =
    "schema = \"proveout.machine/1\"\n"         // 1
    "name = \"trunnion\"\n"                     // 2
    "[[axis]]\n"                                // 3
    "name = \"X\"\n"                            // 4
    "travel = [-10, 810]\n"                     // 5
    "rapid = 30000\n"                           // 6
    "[[axis]]\n"                                // 7
    "name = \"Y\"\n"                            // 8
    "on = \"X\"\n"                              // 9
    "[[axis]]\n"                                // 10
    "name = \"Z\"\n"                            // 11
    "on = \"Y\"\n"                              // 12
    "[[axis]]\n"                                // 13
    "name = \"A\"\n"                            // 14
    "carries = \"part\"\n"                      // 15
    "direction = [1, 0, 0]\n"                   // 16
    "point = [400, 300, -500]\n"                // 17
    "sense = \"left\"\n"                        // 18
    "travel = [-120, 30]\n"                     // 19
    "[[axis]]\n"                                // 20
    "name = \"C\"\n"                            // 21
    "on = \"A\"\n"                              // 22
    "carries = \"part\"\n"                      // 23
    "point = [400, 300, -460]\n"                // 24
    "step = 1.0\n"                              // 25
    "clamped = true\n"                          // 26
    "[spindle]\n"                               // 27
    "on = \"Z\"\n"                              // 28
    "gauge = [0, 0, 20]\n"                      // 29
    "[[body]]\n"                                // 30
    "name = \"cradle\"\n"                       // 31
    "on = \"A\"\n"                              // 32
    "box = [[0, 0, -600], [800, 600, -520]]\n"  // 33
    "watch = [\"spindle\", \"holder\"]\n";      // 34

struct Read {
  Job job;
  Diagnostics diagnostics;
  std::string error;
};

Read readText(const std::string& text) {
  const fs::path path = fs::temp_directory_path() / fmt::format("machine-{}.toml", ::getpid());
  std::ofstream(path) << text;
  Read out;
  loadMachine(path.string(), out.job, out.diagnostics);
  fs::remove(path);
  for (const Diagnostic& d : out.diagnostics.all()) {
    if (out.error.empty()) out.error = fmt::format("{} {}: {}", d.where.line, d.code, d.message);
  }
  return out;
}

std::string replaced(const std::string& from, const std::string& to) {
  const std::size_t at = kGood.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return std::string(kGood).replace(at, from.size(), to);
}

TEST(MachineFile, IsReadAsAChain) {
  const Read read = readText(kGood);
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
  const Read read = readText(
      replaced("direction = [1, 0, 0]", "inclination = { from = \"Y\", toward = \"Z\", degrees = -45 }"));
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
    const Read read = readText(replaced(row.from, row.to));
    EXPECT_TRUE(read.error.starts_with(fmt::format("{} ", row.line))) << row.to << ": " << read.error;
    EXPECT_NE(read.error.find(row.word), std::string::npos) << row.to << ": " << read.error;
    EXPECT_FALSE(read.job.settings.machine) << row.to;
  }
}

TEST(MachineFile, ATextCutAnywhereIsNoCrashAndNoHalfMachine) {
  for (std::size_t length = 0; length < kGood.size(); length += 7) {
    const Read read = readText(kGood.substr(0, length));
    EXPECT_TRUE(length >= kGood.find("[spindle]") || !read.job.settings.machine) << length;
  }
}

}  // namespace
}  // namespace proveout
