// Machine files that are no machine: each is told with its line, its key and what to do, and gives nothing.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "io/job/machine_file.h"
#include "machine_text.h"

namespace proveout {
namespace {

using namespace io_test;

/// A change of the good machine, and what the first message says of it.
struct Bad {
  const char *from, *to;
  int line;
  const char* key;     ///< or the value that is wrong
  const char* advice;  ///< what a person does about it
};

/// `what` names the text in messages of the test.
void expectTold(const std::string& text, int line, const char* key, const char* advice, const char* what) {
  const ReadMachine read = readMachineText(text);
  EXPECT_TRUE(read.diagnostics.hasErrors()) << what;
  EXPECT_TRUE(read.error.starts_with(fmt::format("{} ", line))) << line << ", " << what << ": " << read.error;
  EXPECT_NE(read.error.find(key), std::string::npos) << key << ", " << what << ": " << read.error;
  EXPECT_NE(read.error.find(advice), std::string::npos) << advice << ", " << what << ": " << read.error;
}

void expectEachTold(std::initializer_list<Bad> rows) {
  for (const Bad& row : rows)
    expectTold(inGoodMachine(row.from, row.to), row.line, row.key, row.advice, row.to);
}

TEST(BadMachineFile, KeysOfTheWhole) {
  expectEachTold({
      {"schema = \"proveout.machine/1\"", "schema = 1", 1, "schema", "a text in quotes"},
      {"schema = \"proveout.machine/1\"", "schema = \"\"", 1, "schema", "must not be empty"},
      {"schema = \"proveout.machine/1\"", "schema = \"proveout.job/1\"", 1, "schema", "proveout.machine/1"},
      {"schema = \"proveout.machine/1\"", "shcema = \"proveout.machine/1\"", 27, "spindle", "schema = "},
      {"schema = \"proveout.machine/1\"\n", "", 26, "spindle", "begins with schema = \"proveout.machine/1\""},
      {"name = \"trunnion\"", "name = 5", 2, "name", "a text in quotes"},
      {"name = \"trunnion\"", "name = \"\"", 2, "name", "must not be empty"},
      {"name = \"trunnion\"", "nam = \"trunnion\"", 2, "'nam'", "did you mean 'name'?"},
      {"name = \"trunnion\"", "rapid = -1", 2, "rapid", "above 0"},
      {"name = \"trunnion\"", "rapid = nan", 2, "rapid", "above 0"},
      {"name = \"trunnion\"", "limits = { X = [1, 0] }", 2, "X", "below the high one"},
      {"name = \"trunnion\"", "start = [1, 2]", 2, "start", "[x, y, z]"},
      {"name = \"trunnion\"", "axis = 5\n[spam]", 4, "axis", "redefine"},
      {"[[axis]]\nname = \"X\"", "[axis]\nname = \"X\"", 7, "axis", "redefine"},
      {"[spindle]\n", "[[spindle]]\n", 27, "spindle", "must be a table"},
      {"[[body]]\n", "[body]\n", 30, "body", "write [[body]]"},
      {"[spindle]\n", "[spindel]\n", 1, "needs the key 'spindle'", "needs the key"},
      {"[[body]]\n", "[[bdoy]]\n", 30, "'bdoy'", "did you mean 'body'?"},
  });
  expectTold("schema = \"proveout.machine/1\"\n", 1, "axis", "needs the key 'axis'", "no axes");
  expectTold("schema = \"proveout.machine/1\"\naxis = []\n[spindle]\non = \"bed\"\n", 2, "axis X",
             "has X, Y and Z", "an empty list");
  expectTold("schema = \"proveout.machine/1\"\naxis = 5\n", 2, "axis", "must be a list", "a number");
  expectTold("schema = \"proveout.machine/1\"\n[axis]\nname = \"X\"\n", 2, "axis", "write [[axis]]",
             "a table");
  std::string many = "schema = \"proveout.machine/1\"\n";
  for (int k = 0; k < 10; ++k) many += fmt::format("[[axis]]\nname = \"U{}\"\n", k);
  expectTold(many, 2, "axis", "9 are allowed", "ten axes");
}

TEST(BadMachineFile, NamesAndNumbersOfAxes) {
  expectEachTold({
      {"name = \"X\"\n", "", 3, "'name'", "needs the key"},
      {"name = \"X\"\n", "name = \"\"\n", 4, "name", "must not be empty"},
      {"name = \"C\"\n", "name = \"c\"\n", 21, "axis name 'c'", "X Y Z U V W A B or C"},
      {"name = \"C\"\n", "name = \"CCCC\"\n", 21, "axis name 'CCCC'", "two letters or digits"},
      {"name = \"C\"\n", "name = \"C-1\"\n", 21, "axis name 'C-1'", "two letters or digits"},
      {"name = \"C\"\n", "name = \"Q\"\n", 21, "axis name 'Q'", "X Y Z U V W A B or C"},
      {"name = \"C\"\n", "name = \"C\\u0000\"\n", 21, "name", "zero byte"},
      {"name = \"C\"\n", "name = [\"C\"]\n", 21, "name", "a text in quotes"},
      {"name = \"Z\"\n", "name = \"Y\"\n", 11, "axis Y", "given twice"},
      {"step = 1.0", "number = 0", 25, "number", "from 1 to 32"},
      {"step = 1.0", "number = 33", 25, "number", "from 1 to 32"},
      {"step = 1.0", "number = 5.0", 25, "number", "a whole number"},
      {"step = 1.0", "number = 4", 25, "same number 4", "give each its own"},
      {"step = 1.0", "number = 3", 25, "same number 3", "give each its own"},
      {"step = 1.0", "number = \"5\"", 25, "number", "a whole number"},
      {"rapid = 30000", "number = 2", 7, "same number 2", "give each its own"},
      {"sense = \"left\"", "number = 32", 20, "number 33", "give it a number"},
      {"name = \"C\"\n", "name = \"C\"\nname = \"C\"\n", 22, "name", "redefine"},
      {"step = 1.0", "kind = \"turning\"", 25, "kind", "linear, rotary"},
      {"step = 1.0", "kind = true", 25, "kind", "a text in quotes"},
      {"rapid = 30000", "kind = \"rotary\"", 6, "axis X", "linear main axis"},
      {"rapid = 30000", "carries = \"nothing\"", 6, "axis X", "moves the tool or the part"},
  });
}

TEST(BadMachineFile, WhatAxesStandOn) {
  expectEachTold({
      {"on = \"X\"", "on = 1", 9, "on", "a text in quotes"},
      {"on = \"X\"", "on = \"\"", 9, "on", "must not be empty"},
      {"on = \"X\"", "on = \"x\"", 9, "'x'", "did you mean 'X'?"},
      {"on = \"X\"", "on = \"BED\"", 9, "'BED'", "did you mean 'bed'?"},
      {"on = \"X\"", "on = \"Y\"", 9, "axis Y", "itself"},
      {"on = \"X\"", "onn = \"X\"", 9, "'onn'", "did you mean 'on'?"},
      {"travel = [-10, 810]", "on = \"Z\"", 5, "itself", "itself"},
      {"on = \"A\"\ncarries", "carries", 20, "axes A and C", "neither stands on the other"},
      {"carries = \"part\"\ndirection", "carries = \"nothing\"\ndirection", 17, "point",
       "rotary axes that do"},
      {"carries = \"part\"\ndirection", "carries = 1\ndirection", 15, "carries", "a text in quotes"},
      {"carries = \"part\"\npoint", "point", 22, "axis C moves the tool", "the part"},
      {"on = \"Y\"\n", "", 3, "axis X", "leave it out"},
  });
}

TEST(BadMachineFile, DirectionsAndPoints) {
  expectEachTold({
      {"direction = [1, 0, 0]", "direction = [inf, 0, 0]", 16, "direction", "at least -2 and at most 2"},
      {"direction = [1, 0, 0]", "direction = [1e300, 0, 0]", 16, "direction", "at least -2 and at most 2"},
      {"direction = [1, 0, 0]", "direction = [\"1\", 0, 0]", 16, "direction: x", "must be a number"},
      {"direction = [1, 0, 0]", "direction = []", 16, "direction", "[x, y, z]"},
      {"direction = [1, 0, 0]", "direction = [1, 0, 0, 0]", 16, "direction", "[x, y, z]"},
      {"direction = [1, 0, 0]", "direction = { x = 1 }", 16, "direction", "[x, y, z]"},
      {"direction = [1, 0, 0]", "direction = [0.998, 0, 0]", 16, "direction", "has length 1"},
      {"direction = [1, 0, 0]", "directon = [1, 0, 0]", 16, "'directon'", "did you mean 'direction'?"},
      {"direction = [1, 0, 0]",
       "direction = [1, 0, 0]\ninclination = { from = \"Y\", toward = \"Z\", degrees = 1 }", 17,
       "inclination", "not both"},
      {"direction = [1, 0, 0]", "inclination = 45", 16, "inclination", "must be a table"},
      {"direction = [1, 0, 0]", "inclination = {}", 16, "'from'", "needs the key"},
      {"direction = [1, 0, 0]", "inclination = { from = \"Y\", degrees = 1 }", 16, "'toward'",
       "needs the key"},
      {"direction = [1, 0, 0]", "inclination = { from = \"Y\", toward = \"Z\", degrees = 361 }", 16,
       "degrees", "at most 360"},
      {"direction = [1, 0, 0]", "inclination = { from = \"Y\", toward = \"Z\", degrees = nan }", 16,
       "degrees", "at most 360"},
      {"direction = [1, 0, 0]", "inclination = { from = \"Y\", toward = \"z\", degrees = 1 }", 16, "toward",
       "did you mean 'Z'?"},
      {"direction = [1, 0, 0]", "inclination = { from = \"Y\", to = \"Z\", degrees = 1 }", 16, "'toward'",
       "needs the key"},
      {"direction = [1, 0, 0]", "inclination = { from = \"Y\", toward = \"Z\", degrees = 1, deg = 2 }", 16,
       "'deg'", "did you mean 'degrees'?"},
      {"rapid = 30000", "direction = [0, 0, 1]", 10, "X, Y and Z", "no motion leads out of it"},
      {"point = [400, 300, -500]\n", "", 13, "'point'", "needs the key"},
      {"point = [400, 300, -500]", "point = 5", 17, "point", "[x, y, z]"},
      {"point = [400, 300, -500]", "point = [1e7, 0, 0]", 17, "point: x", "at most 1000000"},
      {"point = [400, 300, -500]", "point = [400, 300, nan]", 17, "point: z", "at most 1000000"},
      {"rapid = 30000", "point = [0, 0, 0]", 6, "point", "a key of rotary axes"},
      {"sense = \"left\"", "sense = 1", 18, "sense", "a text in quotes"},
      {"sense = \"left\"", "sense = \"Left\"", 18, "sense", "did you mean 'left'?"},
      {"rapid = 30000", "sense = \"left\"", 6, "sense", "a key of rotary axes"},
      {"rapid = 30000", "clamped = true", 6, "clamped", "a key of rotary axes"},
      {"rapid = 30000", "step = 5", 6, "step", "a key of rotary axes"},
  });
}

TEST(BadMachineFile, TravelSpeedAndTeeth) {
  expectEachTold({
      {"travel = [-120, 30]", "travel = []", 19, "travel", "[low, high]"},
      {"travel = [-120, 30]", "travel = [nan, 30]", 19, "travel low", "at least -1000000"},
      {"travel = [-120, 30]", "travel = [-inf, 30]", 19, "travel low", "at least -1000000"},
      {"travel = [-120, 30]", "travel = [\"a\", 30]", 19, "travel low", "must be a number"},
      {"travel = [-120, 30]", "travel = [10, 30]", 13, "start 0", "travel, 10 to 30"},
      {"travel = [-120, 30]", "travel = [-120, 30]\nstart = 31", 20, "start 31", "travel, -120 to 30"},
      {"travel = [-120, 30]", "travel = [-120, 30]\nreference = 31", 20, "reference 31",
       "travel, -120 to 30"},
      {"travel = [-120, 30]", "travel = [-120, 30]\ntravel = [1, 2]", 20, "travel", "redefine"},
      {"travel = [-120, 30]", "tavel = [-120, 30]", 19, "'tavel'", "did you mean 'travel'?"},
      {"rapid = 30000", "rapid = inf", 6, "rapid", "at most 10000000"},
      {"rapid = 30000", "rapid = [1, 2, 3]", 6, "rapid", "must be a number"},
      {"rapid = 30000", "rapid = \"fast\"", 6, "rapid", "must be a number"},
      {"rapid = 30000", "rapid = 1979-05-27", 6, "rapid", "must be a number"},
      {"rapid = 30000", "acceleration = nan", 6, "acceleration", "at least 0"},
      {"rapid = 30000", "acceleration = 1e10", 6, "acceleration", "at most 1000000000"},
      {"rapid = 30000", "start = 5", 6, "start", "of the machine"},
      {"rapid = 30000", "reference = 5", 6, "reference", "'reference_points' of the machine"},
      {"rapid = 30000", "limits = [0, 5]", 6, "'limits'", "the keys are"},
      {"step = 1.0", "step = 361", 25, "step", "at most 360"},
      {"step = 1.0", "step = 0.7", 25, "step", "without a rest"},
      {"step = 1.0", "step = \"1\"", 25, "step", "must be a number"},
      {"step = 1.0", "step = 1.0\nstart = 0.5", 26, "start", "whole steps"},
      {"clamped = true", "clamped = \"true\"", 26, "clamped", "true or false"},
  });
}

TEST(BadMachineFile, Spindle) {
  expectEachTold({
      {"on = \"Z\"\n", "", 27, "'on'", "needs the key"},
      {"[spindle]\non = \"Z\"", "[spindle]\non = 3", 28, "on", "a text in quotes"},
      {"[spindle]\non = \"Z\"", "[spindle]\non = \"z\"", 28, "'z'", "did you mean 'Z'?"},
      {"[spindle]\non = \"Z\"", "[spindle]\non = \"bed\"", 3, "axis X", "between bed and spindle"},
      {"gauge = [0, 0, 20]", "gauge = 20", 29, "gauge", "[x, y, z]"},
      {"gauge = [0, 0, 20]", "gauge = [0, 0, nan]", 29, "gauge: z", "at most 1000000"},
      {"gauge = [0, 0, 20]", "guage = [0, 0, 20]", 29, "'guage'", "did you mean 'gauge'?"},
      {"gauge = [0, 0, 20]", "direction = \"Z\"", 29, "direction", "[x, y, z]"},
      {"gauge = [0, 0, 20]", "direction = [0, 0, 1.01]", 29, "direction", "length 1"},
      {"gauge = [0, 0, 20]", "direction = [0, nan, 1]", 29, "direction: y", "at most 2"},
      {"gauge = [0, 0, 20]", "gauge = [0, 0, 20]\ngauge = [0, 0, 20]", 30, "gauge", "redefine"},
  });
}

constexpr const char* kBox = "box = [[0, 0, -600], [800, 600, -520]]";

TEST(BadMachineFile, Bodies) {
  expectEachTold({
      {"name = \"cradle\"\n", "", 30, "'name'", "needs the key"},
      {"name = \"cradle\"", "name = 7", 31, "name", "a text in quotes"},
      {"name = \"cradle\"", "name = \"tool\"", 31, "'tool'", "another name"},
      {"on = \"A\"\nbox", "on = [1]\nbox", 32, "on", "a text in quotes"},
      {"on = \"A\"\nbox", "on = \"a\"\nbox", 32, "'a'", "did you mean 'A'?"},
      {"on = \"A\"\nbox", "onn = \"A\"\nbox", 32, "'onn'", "did you mean 'on'?"},
      {kBox, "", 30, "mesh", "one of mesh, box and cylinder"},
      {kBox, "box = [[0, 0, 0], [1, 1, 1]]\nmesh = \"m.stl\"", 34, "mesh", "one of mesh, box and cylinder"},
      {kBox, "box = 5", 33, "box", "[[x, y, z], [x, y, z]]"},
      {kBox, "box = [[0, 0, 0]]", 33, "box", "[[x, y, z], [x, y, z]]"},
      {kBox, "box = [[0, 0, 0], [1, 1]]", 33, "box", "[x, y, z]"},
      {kBox, "box = [[0, 0, 0], [1, 1, nan]]", 33, "box: z", "at most 1000000"},
      {kBox, "box = [[0, 0, 0], [1, 1, 0]]", 33, "second point", "above the first one"},
      {kBox, "bx = [[0, 0, 0], [1, 1, 1]]", 30, "mesh", "one of mesh, box and cylinder"},
      {kBox, "cylinder = 5", 33, "cylinder", "must be a table"},
      {kBox, "cylinder = { to = [0, 0, 1], radius = 1 }", 33, "'from'", "needs the key"},
      {kBox, "cylinder = { from = [0, 0, 1], radius = 1 }", 33, "'to'", "needs the key"},
      {kBox, "cylinder = { from = [0, 0, 0], to = [0, 0, 1] }", 33, "'radius'", "needs the key"},
      {kBox, "cylinder = { from = [0, 0, 0], to = [0, 0, 1], radius = -1 }", 33, "radius", "above 0"},
      {kBox, "cylinder = { from = [0, 0, 0], to = [0, 0, 1], radius = inf }", 33, "radius", "above 0"},
      {kBox, "cylinder = { from = [0, 0], to = [0, 0, 1], radius = 1 }", 33, "from", "[x, y, z]"},
      {kBox, "cylinder = { from = [0, 0, 0], to = [0, 0, 1], radius = 1, rad = 1 }", 33, "'rad'",
       "did you mean 'radius'?"},
      {"watch = [\"spindle\", \"holder\"]", "watch = \"spindle\"", 34, "watch", "must be a list"},
      {"watch = [\"spindle\", \"holder\"]", "watch = [1]", 34, "watch", "a text in quotes"},
      {"watch = [\"spindle\", \"holder\"]", "watch = [\"spindel\"]", 34, "'spindel'",
       "did you mean 'spindle'?"},
      {"watch = [\"spindle\", \"holder\"]", "watch = [\"cradle\"]", 34, "watches itself", "name others"},
      {"watch = [\"spindle\", \"holder\"]", "watches = [\"spindle\"]", 34, "'watches'",
       "did you mean 'watch'?"},
  });
  expectTold(kGoodMachine + "[[body]]\nname = \"cradle\"\nbox = [[0, 0, 0], [1, 1, 1]]\n", 36, "'cradle'",
             "two bodies with the name", "a name twice");
}

/// A tetrahedron, and the same without one of its faces.
constexpr const char* kClosed = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
constexpr const char* kOpen = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\n";

TEST(BadMachineFile, MeshesOfBodies) {
  const TempFolder folder;
  folder.write("open.obj", kOpen);
  folder.write("empty.stl", "");
  folder.write("text.stl", "no mesh at all\n");
  folder.write("folder.stl/inside.txt", "");
  folder.write("closed.obj", kClosed);
  const struct {
    const char *value, *word;
  } rows[] = {{"\"open.obj\"", "not closed"},     {"\"empty.stl\"", "empty.stl"},
              {"\"text.stl\"", "text.stl"},       {"\"folder.stl\"", "folder.stl"},
              {"\"nothing.stl\"", "nothing.stl"}, {"\"\"", "must not be empty"},
              {"5", "a text in quotes"},          {"[\"closed.obj\"]", "a text in quotes"},
              {"\"../../etc/passwd\"", "passwd"}, {"\"open.obj\\u0000\"", "zero byte"}};
  for (const auto& row : rows) {
    const ReadMachine read = readMachineFile(
        folder.write("machine.toml", inGoodMachine(kBox, fmt::format("mesh = {}", row.value))));
    EXPECT_TRUE(read.error.starts_with("33 ")) << row.value << ": " << read.error;
    EXPECT_NE(read.error.find(row.word), std::string::npos) << row.value << ": " << read.error;
    EXPECT_FALSE(read.job.settings.machine) << row.value;
  }
  const ReadMachine good =
      readMachineFile(folder.write("machine.toml", inGoodMachine(kBox, "mesh = \"closed.obj\"")));
  EXPECT_EQ(good.error, "");
}

TEST(BadMachineFile, FilesThatAreNone) {
  const TempFolder folder;
  const struct {
    std::string path;
    const char* word;
  } rows[] = {{folder.path("nothing.toml"), "nothing.toml"},
              {folder.path(), "folder"},
              {folder.write("empty.toml", ""), "says nothing"},
              {folder.write("comment.toml", "# a machine\n\n"), "says nothing"},
              {folder.write("text.toml", "%\nO0001\nM30\n%\n"), "key"},
              {folder.write("latin.toml", "schema = \"proveout.machine/1\"\nname = \"Fr\xE4se\"\n"), "utf-8"},
              {folder.write("utf16.toml", std::string("\xFF\xFEs\0c\0h\0", 8)), "UTF-8"},
              {folder.write("zero.toml", std::string("name = \"a\"\n\0\0\0", 14)), "expected keys"},
              {folder.write("binary.toml", "\x01\x02\x03"), "expected keys"}};
  for (const auto& row : rows) {
    const ReadMachine read = readMachineFile(row.path);
    EXPECT_NE(read.error.find(row.word), std::string::npos) << row.path << ": " << read.error;
    EXPECT_FALSE(read.job.settings.machine);
  }
}

/// Cut at any byte it is told or is a whole machine, which has its spindle on Z at least.
TEST(BadMachineFile, CutAtEveryByte) {
  const std::size_t enough = kGoodMachine.find("on = \"Z\"\n") + 8;
  for (std::size_t length = 0; length < kGoodMachine.size(); ++length) {
    const ReadMachine read = readMachineText(kGoodMachine.substr(0, length));
    EXPECT_EQ(read.error.empty(), read.job.settings.machine.has_value()) << length << read.error;
    EXPECT_TRUE(length >= enough || !read.error.empty()) << length;
  }
}

/// What X, Y and Z leave out is as the keys of the whole machine say.
TEST(MachineFile, MainAxesTakeTheRatesAndLimitsOfTheMachine) {
  const ReadMachine read = readMachineText(
      "rapid = 12000\nacceleration = [1, 2, 3]\nlimits = { Y = [-5, 7], X = [0, 1] }\n" + kGoodMachine);
  ASSERT_EQ(read.error, "");
  const ControlSettings& settings = read.job.settings;
  EXPECT_EQ(settings.rapid_mm_min, Vec3(30000, 12000, 12000));
  EXPECT_EQ(settings.acceleration_mm_s2, Vec3(1, 2, 3));
  ASSERT_TRUE(settings.limits[1]);
  EXPECT_EQ(settings.limits[1]->max, 7);
  EXPECT_EQ(settings.limits[0]->max, 810);  // its own travel
  ASSERT_TRUE(settings.machine->axes[1].travel);
  EXPECT_EQ(settings.machine->axes[1].travel->min, -5);
}

/// A second file stands for the first one: nothing of that is left.
TEST(MachineFile, TheNextMachineTakesNothingOfTheOneBefore) {
  const TempFolder folder;
  Job job;
  Diagnostics diagnostics;
  loadMachine(folder.write("first.toml", "acceleration = 7\nlimits = { Y = [-5, 7] }\n" + kGoodMachine), job,
              diagnostics);
  loadMachine(folder.write("second.toml", inGoodMachine("travel = [-10, 810]\nrapid = 30000\n", "")), job,
              diagnostics);
  ASSERT_FALSE(diagnostics.hasErrors());
  EXPECT_EQ(job.settings.rapid_mm_min, Vec3(15000, 15000, 15000));
  EXPECT_EQ(job.settings.acceleration_mm_s2, Vec3(0, 0, 0));
  EXPECT_FALSE(job.settings.limits[0]);
  EXPECT_FALSE(job.settings.limits[1]);
}

TEST(MachineFile, BodiesMayWatchThoseBelow) {
  const ReadMachine read = readMachineText(inGoodMachine("\"holder\"]", "\"post\", \"tool\"]") +
                                           "[[body]]\nname = \"post\"\nbox = [[0, 0, 0], [1, 1, 1]]\n");
  ASSERT_EQ(read.error, "");
  EXPECT_EQ(read.job.settings.machine->bodies[0].watch,
            (std::vector<std::string>{"spindle", "post", "tool"}));
}

}  // namespace
}  // namespace proveout
