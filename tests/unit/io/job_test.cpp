#include "io/job/job.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "job_fixture.h"

namespace proveout {
namespace {

using namespace io_test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(Job, ReadsEveryKey) {
  JobFolder folder;
  folder.write("subs/O0001.nc", "");
  const auto job = folder.load(R"(
schema = "proveout.job/1"
name = "bracket"
control = "nct"
program = "bracket.nc"
encoding = "koi8-r"
subprograms = ["subs"]
units = "inch"
[machine]
rapid = 12000
start = [0, 0, 50]
reference_points = [[0, 0, 100], [10, 0, 100.5]]
tool_change_s = 3.5
range_b = ["Z+", "X-"]
default_spindle = 800
acceleration = [500, 600, 700]
acceleration_rise_s = 0.05
[machine.limits]
X = [-400, 400]
Z = [-100.5, 200]
[[machine.spindle]]
number = 2
name = "S2"
acceleration = 900
position_name = "CS2"
main_code = 32
range = [{ min = 50, max = 1000 }, { min = 800, max = 4000 }]
[stock]
shape = "box"
min = [0, 0, -20]
max = [80, 80, 0]
[nominal]
mesh = "bracket.stl"
unit = "inch"
gouge = 0.03
excess = 0.06
[[tool]]
number = 1
name = "ball nose"
type = "ball"
diameter = 3.175
flute_length = 12
overall_length = 40
gauge_length = 5
holder = [[0, 10], [20, 10], [20, 16]]
[[tool]]
number = 12
type = "flat"
diameter = 10
shank_diameter = 12
[offsets.work]
G54 = [100, 50, -20]
G59 = [1, 2, 3]
"G54.1 P7" = [4, 5, 6]
common = [0.5, 0, 0]
[offsets.rotation]
G55 = [0, 0, 30]
[offsets.length]
1 = 100.5
2 = { geometry = 90, wear = -0.02 }
[offsets.radius]
1 = 1.5875
[panel]
block_skip = [1, 3]
interrupt_blocks = [120, 7]
answers = { 201 = 3, 150 = 0 }
plc_bits = [0, 31]
plc_numbers = [0, 2.5, -1]
date = 20140518
time = 153241
test_mode = true
optional_stop = true
[simulation]
resolution = 0.1
simplify = 0.02
threads = 2
max_memory_gb = 1.5
max_time_s = 90
max_blocks = 5000
lenient = true
[output]
formats = ["stl", "obj", "vdb"]
views = ["top"]
size = [800, 600]
)");
  ASSERT_TRUE(job) << folder.text();
  EXPECT_EQ(job->name, "bracket");
  EXPECT_EQ(job->control, "nct");
  EXPECT_EQ(job->program, folder.path("bracket.nc"));
  EXPECT_THAT(job->subprograms, ElementsAre(folder.path("subs")));
  const ControlSettings& s = job->settings;
  EXPECT_EQ(s.encoding, TextEncoding::kKoi8R);
  EXPECT_EQ(s.units, LengthUnit::kInch);
  EXPECT_EQ(s.rapid_mm_min, Vec3::Constant(12000));
  EXPECT_EQ(job->start, Vec3(0, 0, 50));
  EXPECT_EQ(s.reference_points[1], Vec3(10, 0, 100.5));
  EXPECT_FALSE(s.reference_points[2].has_value());
  EXPECT_EQ(s.tool_change_s, 3.5);
  EXPECT_EQ(s.stroke_range_b, (std::vector<std::string>{"Z+", "X-"}));
  EXPECT_EQ(s.default_spindle_rpm, 800);
  EXPECT_EQ(s.acceleration_mm_s2, Vec3(500, 600, 700));
  EXPECT_EQ(s.bell_time_s, 0.05);
  ASSERT_EQ(s.spindles.size(), 1u);
  EXPECT_EQ(s.spindles[0].number, 2);
  EXPECT_EQ(s.spindles[0].acceleration, 900);
  EXPECT_EQ(s.spindles[0].main_code, 32);
  ASSERT_EQ(s.spindles[0].ranges.size(), 2u);
  EXPECT_EQ(s.spindles[0].ranges[1].max, 4000);
  EXPECT_EQ(s.limits[0]->min, -400);
  EXPECT_FALSE(s.limits[1].has_value());
  EXPECT_EQ(s.limits[2]->max, 200);
  EXPECT_EQ(std::get<BoxShape>(*job->stock).max, Vec3(80, 80, 0));
  EXPECT_EQ(job->nominal->mesh.path, folder.path("bracket.stl"));
  EXPECT_EQ(job->nominal->mesh.unit, MeshUnit::kInch);
  EXPECT_EQ(job->nominal->gouge_mm, 0.03);
  EXPECT_EQ(job->nominal->excess_mm, 0.06);
  ASSERT_EQ(job->tools.size(), 2u);
  EXPECT_EQ(job->tools[0].type, ToolType::kBall);
  EXPECT_EQ(job->tools[0].name, "ball nose");
  EXPECT_THAT(job->tools[0].holder, ElementsAre(Vec2(0, 10), Vec2(20, 10), Vec2(20, 16)));
  EXPECT_EQ(job->tools[1].number, 12);
  EXPECT_EQ(job->tools[1].shank_diameter, 12);
  EXPECT_EQ(s.gauge_lengths.at(1), 5);
  EXPECT_EQ(s.work_offsets[0], Vec3(100, 50, -20));
  EXPECT_EQ(s.work_offsets[5], Vec3(1, 2, 3));
  EXPECT_EQ(s.extended_offsets.at(7), Vec3(4, 5, 6));
  EXPECT_EQ(s.common_offset, Vec3(0.5, 0, 0));
  EXPECT_EQ(s.work_rotations_deg[1], Vec3(0, 0, 30));
  EXPECT_EQ(s.length_offsets.at(1).geometry, 100.5);
  EXPECT_EQ(s.length_offsets.at(2).wear, -0.02);
  EXPECT_EQ(s.radius_offsets.at(1).geometry, 1.5875);
  EXPECT_TRUE(s.skip_switches[0] && !s.skip_switches[1] && s.skip_switches[2]);
  EXPECT_EQ(s.interrupt_blocks, (std::vector<std::int64_t>{120, 7}));
  EXPECT_TRUE(s.optional_stop && s.lenient);
  EXPECT_EQ(job->person.message_answers, (std::map<int, int>{{150, 0}, {201, 3}}));
  EXPECT_TRUE(job->person.plc_bits[0] && !job->person.plc_bits[1] && job->person.plc_bits[31]);
  EXPECT_EQ(job->person.plc_numbers, (std::array<double, 3>{0.0, 2.5, -1.0}));
  EXPECT_EQ(job->person.date, 20140518);
  EXPECT_EQ(job->person.time, 153241);
  EXPECT_TRUE(job->person.test_mode);
  EXPECT_EQ(s.block_limit, 5000u);
  EXPECT_EQ(job->simulation.resolution_mm, 0.1);
  EXPECT_EQ(job->simulation.simplify_mm, 0.02);
  EXPECT_EQ(job->simulation.threads, 2);
  EXPECT_EQ(job->simulation.max_memory_gb, 1.5);
  EXPECT_EQ(job->simulation.max_time_s, 90.0);
  EXPECT_THAT(job->output.formats, ElementsAre(OutputFormat::kStl, OutputFormat::kObj, OutputFormat::kVdb));
  EXPECT_THAT(job->output.views, ElementsAre("top"));
  EXPECT_EQ(job->output.width, 800);
}

/// The first example of the reference that is a whole job.
std::string smallestJobOfTheReference() {
  const std::string text = readBytes(std::string(PROVEOUT_SOURCE_DIR) + "/docs/reference/job.md");
  const std::size_t begin = text.find("```toml\n");
  if (begin == std::string::npos) return "";
  return text.substr(begin + 8, text.find("```", begin + 8) - begin - 8);
}

TEST(Job, ReadsTheSmallestJobOfTheReference) {
  JobFolder folder;
  const auto job = folder.load(smallestJobOfTheReference());
  ASSERT_TRUE(job) << folder.text();
  EXPECT_EQ(job->tools.at(0).type, ToolType::kBall);
}

TEST(Job, NeedsLittle) {
  JobFolder folder;
  const auto job = folder.load(kSmallJob);
  ASSERT_TRUE(job) << folder.text();
  EXPECT_EQ(job->name, "job");
  EXPECT_FALSE(job->nominal.has_value());
  EXPECT_FALSE(job->start.has_value());
  EXPECT_FALSE(job->simulation.resolution_mm.has_value());
  EXPECT_THAT(job->output.formats, ElementsAre(OutputFormat::kStl));
  EXPECT_EQ(job->settings.encoding, TextEncoding::kAuto);
}

TEST(Job, ReadsEveryToolType) {
  JobFolder folder;
  const auto job = folder.load(std::string(kSmallJob) + R"(
[[tool]]
number = 2
type = "bull"
diameter = 10
corner_radius = 2
[[tool]]
number = 3
type = "cone"
diameter = 6
tip_diameter = 0.2
cone_angle = 60
[[tool]]
number = 4
type = "drill"
diameter = 5
[[tool]]
number = 5
type = "taper"
tip_diameter = 2
taper_angle = 3
flute_length = 20
[[tool]]
number = 6
type = "taper"
tip_diameter = 1
taper_angle = 45
diameter = 5
)");
  ASSERT_TRUE(job) << folder.text();
  ASSERT_EQ(job->tools.size(), 6u);
  EXPECT_EQ(job->tools[1].corner_radius, 2);
  EXPECT_EQ(job->tools[2].cone_angle_deg, 60);
  EXPECT_EQ(job->tools[3].point_angle_deg, 118);
  // A taper of 3 degrees a side widens by 2 x 20 x tan 3 deg over 20 mm.
  EXPECT_EQ(job->tools[4].type, ToolType::kCone);
  EXPECT_EQ(job->tools[4].cone_angle_deg, 6);
  EXPECT_NEAR(job->tools[4].diameter, 2 + 40 * 0.052407779283, 1e-9);
  EXPECT_EQ(job->tools[5].cone_angle_deg, 90);
  EXPECT_EQ(job->tools[5].diameter, 5);
}

TEST(Job, ReadsToolsWithNecksAndForms) {
  JobFolder folder;
  const auto job = folder.load(kSmallJob + R"(
[[tool]]
number = 2
type = "taper"
ball_diameter = 1
taper_angle = 5
flute_length = 20
[[tool]]
number = 3
type = "dovetail"
diameter = 20
dovetail_angle = 60
height = 8
neck_diameter = 9
corner_radius = 0.4
[[tool]]
number = 4
type = "tslot"
diameter = 21
thickness = 9
neck_diameter = 10
neck_length = 25
shank_diameter = 12
overall_length = 70
[[tool]]
number = 5
type = "lollipop"
diameter = 6
neck_diameter = 3
[[tool]]
number = 6
type = "thread-mill"
diameter = 10
pitch = 1.5
teeth = 8
crest_flat = 0.1875
[[tool]]
number = 7
type = "form"
profile = [[2, 0], [5, 3, -3], [5, 4], [6, 4], [6, 6], [4, 8, 2]]
shank_diameter = 8
overall_length = 40
)");
  ASSERT_TRUE(job) << folder.text();
  ASSERT_EQ(job->tools.size(), 7u);
  EXPECT_EQ(job->tools[1].type, ToolType::kTaperBall);
  EXPECT_EQ(job->tools[1].cone_angle_deg, 10);
  // The flank touches the ball of 0.5 at a height of 0.5 (1 - sin 5 deg) and widens by tan 5 deg a side.
  EXPECT_NEAR(job->tools[1].diameter, 0.996194698 + 2 * (20 - 0.456422129) * 0.0874886635, 1e-8);
  EXPECT_EQ(job->tools[2].type, ToolType::kDovetail);
  EXPECT_EQ(job->tools[2].dovetail_angle_deg, 60);
  EXPECT_EQ(job->tools[2].cutter_height, 8);
  EXPECT_EQ(job->tools[2].corner_radius, 0.4);
  EXPECT_EQ(job->tools[3].type, ToolType::kTSlot);
  EXPECT_EQ(job->tools[3].cutter_height, 9);
  EXPECT_EQ(job->tools[3].neck_length, 25);
  EXPECT_EQ(job->tools[4].type, ToolType::kLollipop);
  EXPECT_EQ(job->tools[4].neck_diameter, 3);
  EXPECT_EQ(job->tools[5].type, ToolType::kThreadMill);
  EXPECT_EQ(job->tools[5].teeth, 8);
  EXPECT_EQ(job->tools[5].thread_angle_deg, 60);
  EXPECT_EQ(job->tools[5].crest_flat, 0.1875);
  EXPECT_EQ(job->tools[6].type, ToolType::kForm);
  EXPECT_EQ(job->tools[6].diameter, 12);
  ASSERT_EQ(job->tools[6].outline.size(), 6u);
  EXPECT_EQ(job->tools[6].outline[1].arc_radius, -3);
  EXPECT_EQ(job->tools[6].outline[5].z, 8);
}

TEST(Job, ReadsRegionsThatAreNotCompared) {
  JobFolder folder;
  const auto job = folder.load(kSmallJob + R"(
[nominal]
mesh = "bracket.stl"
[[nominal.ignore]]
name = "thread"
z = [-26, 0]
radius = [8, 11]
[[nominal.ignore]]
name = "label"
min = [0, 0, -1]
max = [20, 10, 1]
)");
  ASSERT_TRUE(job);
  ASSERT_EQ(job->nominal->ignored.size(), 2u);
  const IgnoredRegion &thread = job->nominal->ignored[0], &label = job->nominal->ignored[1];
  EXPECT_TRUE(thread.contains({0, -9, -25}));
  EXPECT_FALSE(thread.contains({0, -7, -25}));
  EXPECT_FALSE(thread.contains({0, -9, 1}));
  EXPECT_TRUE(label.contains({10, 5, 0}));
  EXPECT_FALSE(label.contains({10, 11, 0}));
}

TEST(Job, ReadsInserts) {
  JobFolder folder;
  const auto job = folder.load(kSmallJob + R"(
[[tool]]
number = 5
name = "CNMG"
type = "insert"
nose_radius = 0.8
orientation = 3
insert_angle = 80
lead_angle = 95
edge_length = 12
holder = [[11, 5], [100, 5], [100, 30], [12, 30]]
[[tool]]
number = 6
type = "insert"
shape = "groove"
orientation = 4
width = 3
edge_length = 18
side_relief = 1.5
[[tool]]
number = 7
type = "insert"
shape = "thread"
orientation = 8
insert_angle = 60
tip_flat = 0.125
edge_length = 4
[[tool]]
number = 8
type = "insert"
shape = "round"
orientation = 9
nose_radius = 6
[[tool]]
number = 9
type = "insert"
shape = "corner"
nose_radius = 0
orientation = 8
insert_angle = 35
edge_length = 16
)");
  ASSERT_TRUE(job) << folder.text();
  ASSERT_EQ(job->tools.size(), 6u);
  for (std::size_t k = 1; k < 6; ++k) {
    EXPECT_EQ(job->tools[k].type, ToolType::kInsert);
    ASSERT_TRUE(job->tools[k].insert.has_value());
  }
  const Insert& corner = *job->tools[1].insert;
  EXPECT_EQ(job->tools[1].name, "CNMG");
  EXPECT_EQ(corner.shape, InsertShape::kCorner);
  EXPECT_EQ(corner.orientation, 3);
  EXPECT_EQ(corner.nose_radius, 0.8);
  EXPECT_EQ(corner.insert_angle_deg, 80);
  EXPECT_EQ(corner.lead_angle_deg, 95);
  EXPECT_EQ(corner.edge_length, 12);
  ASSERT_EQ(corner.holder.size(), 4u);
  EXPECT_EQ(corner.holder[3], Vec2(12, 30));
  EXPECT_TRUE(job->tools[1].holder.empty());
  const Insert& groove = *job->tools[2].insert;
  EXPECT_EQ(groove.shape, InsertShape::kGroove);
  EXPECT_EQ(groove.width, 3);
  EXPECT_EQ(groove.side_relief_deg, 1.5);
  EXPECT_EQ(groove.nose_radius, 0);
  EXPECT_EQ(job->tools[3].insert->shape, InsertShape::kThread);
  EXPECT_EQ(job->tools[3].insert->tip_flat, 0.125);
  EXPECT_EQ(job->tools[4].insert->shape, InsertShape::kRound);
  EXPECT_TRUE(job->tools[4].insert->at_center);
  EXPECT_EQ(job->tools[4].insert->orientation, 3);
  EXPECT_FALSE(job->tools[3].insert->at_center);
  EXPECT_EQ(job->tools[5].insert->orientation, 8);
}

TEST(Job, ReadsEveryStock) {
  JobFolder folder;
  folder.write("blank.stl", "x");
  folder.write("blank.vdb", "x");
  const auto stock = [&](const std::string& text) {
    const auto job = folder.load(withStock(text));
    EXPECT_TRUE(job) << folder.text();
    return job ? *job->stock : StockSpec();
  };
  const auto cylinder = std::get<CylinderShape>(
      stock("shape = 'cylinder'\naxis = 'x'\nbase = [1, 2, 3]\ndiameter = 10\nlength = 30"));
  EXPECT_EQ(cylinder.axis, 0);
  EXPECT_EQ(cylinder.base, Vec3(1, 2, 3));
  EXPECT_EQ(cylinder.radius, 5);
  EXPECT_EQ(cylinder.inner_radius, 0);
  EXPECT_EQ(cylinder.length, 30);
  const auto tube = std::get<CylinderShape>(
      stock("shape = 'tube'\nbase = [0, 0, 0]\nradius = 10\ninner_diameter = 8\nlength = 30"));
  EXPECT_EQ(tube.axis, 2);
  EXPECT_EQ(tube.inner_radius, 4);
  const auto mesh = std::get<MeshFile>(stock("shape = 'mesh'\nfile = 'blank.stl'\nunit = 'm'"));
  EXPECT_EQ(mesh.path, folder.path("blank.stl"));
  EXPECT_EQ(mesh.unit, MeshUnit::kMetre);
  EXPECT_EQ(std::get<SavedStock>(stock("shape = 'vdb'\nfile = 'blank.vdb'")).path, folder.path("blank.vdb"));
}

TEST(Job, ReadsStartHolesAndThePointOfThePart) {
  JobFolder folder;
  const auto job = folder.load(
      withStock(kSmallStock + "part_point = [1, 2, -3]\n[[stock.start_hole]]\nat = [10, 20]\ndiameter = 3\n"
                              "[[stock.start_hole]]\nat = [30, 20.5]\ndiameter = 0.8"));
  ASSERT_TRUE(job) << folder.text();
  ASSERT_EQ(job->start_holes.size(), 2u);
  EXPECT_EQ(job->start_holes[1].at, Vec2(30, 20.5));
  EXPECT_EQ(job->start_holes[1].diameter, 0.8);
  EXPECT_EQ(job->part_point, Vec3(1, 2, -3));
  const auto plain = folder.load(kSmallJob);
  ASSERT_TRUE(plain);
  EXPECT_TRUE(plain->start_holes.empty());
  EXPECT_FALSE(plain->part_point);
}

TEST(Job, ReadsControlParameters) {
  JobFolder folder;
  folder.names.parameters["nct"] = {{"N1339", 0, 10}, {"N1337.SEC", 0, 1}};
  const auto good = folder.load(replacedOnce(kSmallJob, "control = \"nct\"\n", "") +
                                "[control]\nname = \"nct\"\n[control.nct]\nN1339 = 0.01\nN1337.SEC = 1\n");
  ASSERT_TRUE(good) << folder.text();
  EXPECT_THAT(good->settings.parameters, ElementsAre(std::pair<const std::string, double>("N1337.SEC", 1),
                                                     std::pair<const std::string, double>("N1339", 0.01)));
}

TEST(Job, ControlsMayShareATableOfSettings) {
  JobFolder folder;
  folder.names.controls = {"nct", "fanuc-mill", "fanuc-lathe"};
  folder.names.parameters["fanuc-lathe"] = {{"decimal", 0, 1, 0, {"calculator", "increment"}}};
  folder.names.settings_tables = {{"fanuc-mill", "fanuc"}, {"fanuc-lathe", "fanuc"}};
  const std::string head = replacedOnce(kSmallJob, "control = \"nct\"\n", "");
  const auto job =
      folder.load(head + "[control]\nname = 'fanuc-lathe'\n[control.fanuc]\ndecimal = 'increment'\n");
  ASSERT_TRUE(job) << folder.text();
  EXPECT_EQ(job->settings.parameters.at("decimal"), 1);
  EXPECT_THAT(folder.refusal(head + "[control]\nname = 'fanuc-lathe'\n[control.fanuc]\ndecimals = 1\n"),
              HasSubstr("control 'fanuc-lathe' has no parameter 'decimals'; did you mean 'decimal'?"));
  EXPECT_THAT(folder.refusal(head + "[control]\nname = 'fanuc-lathe'\n[control.fanuc]\ndecimal = 'x'\n"),
              HasSubstr("decimal 'x' is not known; there are calculator, increment"));
  EXPECT_THAT(folder.refusal(head + "[control]\nname = 'fanuc-lathe'\n[control.fanuc]\ndecimal = 1\n"),
              HasSubstr("decimal must be a text"));
  EXPECT_THAT(folder.refusal(head + "[control]\nname = 'fanuc-lathe'\n[control.fanuc-lathe]\ndecimal = 1\n"),
              HasSubstr("settings of control 'fanuc-lathe' stand in [control.fanuc]"));
}

TEST(Job, MayLeaveTheControlToTheProgram) {
  JobFolder folder;
  folder.names.parameters["nct"] = {{"N1339", 0, 10}};
  const std::string head = replacedOnce(kSmallJob, "control = \"nct\"\n", "");
  for (const char* control : {"", "[control]\nname = 'auto'\n", "[control.nct]\nN1339 = 1\n"}) {
    const auto job = folder.load(head + control);
    ASSERT_TRUE(job) << folder.text();
    EXPECT_EQ(job->control, kAutoControl);
    EXPECT_TRUE(job->settings.parameters.empty());
  }
  const auto job =
      folder.load(head + "[control]\nname = 'auto'\n[control.nct]\nN1339 = 1\n[control.flexnc]\n");
  ASSERT_TRUE(job) << folder.text();
  EXPECT_EQ(job->settings_by_table.at("nct").at("N1339"), 1);
}

TEST(Job, ReadsAMachineFileAndChangesIt) {
  JobFolder folder;
  folder.write("machines/vmc.toml",
               "rapid = [30000, 30000, 20000]\ntool_change_s = 4\n[limits]\nX = [0, 500]\nY = [0, 400]\n");
  const auto job = folder.load(
      std::string(kSmallJob) +
      "[machine]\nfile = 'machines/vmc.toml'\ntool_change_s = 2\n[machine.limits]\nX = [0, 450]\n");
  ASSERT_TRUE(job) << folder.text();
  EXPECT_EQ(job->settings.rapid_mm_min, Vec3(30000, 30000, 20000));
  EXPECT_EQ(job->settings.tool_change_s, 2);
  EXPECT_EQ(job->settings.limits[0]->max, 450);
  EXPECT_EQ(job->settings.limits[1]->max, 400);
}

TEST(Job, ReadsThePlaceOfToolChanges) {
  JobFolder folder;
  folder.write("vmc.toml", "tool_change = [100, -50, 400]\n");
  const auto list = folder.load(std::string(kSmallJob) + "[machine]\nfile = 'vmc.toml'\n");
  ASSERT_TRUE(list) << folder.text();
  const ToolChangePlace& whole = list->settings.tool_change;
  EXPECT_EQ(whole.x, 100);
  EXPECT_EQ(whole.y, -50);
  EXPECT_EQ(whole.z, 400);
  EXPECT_FALSE(whole.by_default);
  const auto changed =
      folder.load(std::string(kSmallJob) + "[machine]\nfile = 'vmc.toml'\ntool_change = { Z = 300 }\n");
  ASSERT_TRUE(changed) << folder.text();
  EXPECT_EQ(changed->settings.tool_change.x, 100);
  EXPECT_EQ(changed->settings.tool_change.z, 300);
  const auto height = folder.load(std::string(kSmallJob) + "[machine.tool_change]\nZ = 300\n");
  ASSERT_TRUE(height) << folder.text();
  EXPECT_FALSE(height->settings.tool_change.x || height->settings.tool_change.y);
  EXPECT_EQ(height->settings.tool_change.z, 300);
  EXPECT_FALSE(folder.load(kSmallJob)->settings.tool_change.any());
}

TEST(Job, ReadsTheHandOfTools) {
  JobFolder folder;
  const auto job =
      folder.load(std::string(kSmallJob) +
                  "hand = 'right'\n[[tool]]\nnumber = 2\ntype = 'drill'\ndiameter = 5\nhand = 'left'\n"
                  "[[tool]]\nnumber = 3\ntype = 'drill'\ndiameter = 5\n");
  ASSERT_TRUE(job) << folder.text();
  EXPECT_FALSE(job->tools[0].left_hand);
  EXPECT_TRUE(job->tools[1].left_hand);
  EXPECT_FALSE(job->tools[2].left_hand);
}

TEST(Job, ReadsFurtherAxes) {
  JobFolder folder;
  folder.names.parameters["nct"] = {{"N0305", 0, 10, 32}};
  folder.write("vmc.toml", "[[axis]]\nname = 'A'\nnumber = 4\n");
  const auto job =
      folder.load(replacedOnce(kSmallJob, "control = \"nct\"\n", "") +
                  "[control]\nname = 'nct'\n[control.nct]\nN0305.6 = 5\n"
                  "[machine]\nfile = 'vmc.toml'\n"
                  "[[machine.axis]]\nname = 'C'\nnumber = 6\nrapid = 3600\nlimits = [-360, 360]\n"
                  "[[machine.axis]]\nname = 'W'\nnumber = 5\nkind = 'linear'\nparallel = 'Z'\n"
                  "start = 2\nreference = 3\n"
                  "[[machine.axis]]\nname = 'B'\nnumber = 7\ncarries = 'nothing'\n"
                  "[[machine.axis]]\nname = 'A'\nnumber = 8\ncarries = 'part'\ndirection = [1, 0, 1]\n"
                  "center = [4, 5, 6]\n");
  ASSERT_TRUE(job) << folder.text();
  const auto& axes = job->settings.axes;
  ASSERT_EQ(axes.size(), 4u) << "the job's axes stand for the file's";
  EXPECT_EQ(axes[0].name, "C");
  EXPECT_EQ(axes[0].kind, AxisKind::kRotary);
  EXPECT_EQ(axes[0].rapid, 3600);
  EXPECT_EQ(axes[0].limit->max, 360);
  EXPECT_EQ(axes[1].number, 5);
  EXPECT_EQ(axes[1].kind, AxisKind::kLinear);
  EXPECT_EQ(axes[1].parallel, "Z");
  EXPECT_EQ(axes[1].start, 2);
  EXPECT_EQ(axes[1].reference, 3);
  EXPECT_EQ(axes[0].carries, RotaryCarries::kDefault);
  EXPECT_FALSE(axes[0].direction.has_value());
  EXPECT_EQ(axes[2].carries, RotaryCarries::kNothing);
  EXPECT_EQ(axes[3].carries, RotaryCarries::kPart);
  EXPECT_EQ(axes[3].direction, Vec3(1, 0, 1));
  EXPECT_EQ(axes[3].center, Vec3(4, 5, 6));
  EXPECT_EQ(job->settings.parameters.at("N0305.6"), 5);
}

TEST(NearestName, FindsSlipsOnly) {
  const std::vector<std::string> names = {"diameter", "flute_length", "number", "type"};
  EXPECT_EQ(nearestName("diamter", names), "diameter");
  EXPECT_EQ(nearestName("daimeter", names), "diameter");
  EXPECT_EQ(nearestName("flutelength", names), "flute_length");
  EXPECT_EQ(nearestName("typ", names), "type");
  EXPECT_EQ(nearestName("feed", names), "");
  EXPECT_EQ(nearestName("", names), "");
  EXPECT_EQ(nearestName("x", {"y"}), "");
  EXPECT_EQ(nearestName("x", {"y", "X"}), "X");
  EXPECT_EQ(nearestName(std::string(100000, 'd'), names), "");
}

TEST(NearestName, KnowsBeginningsAndWhatPeopleWrite) {
  EXPECT_EQ(nearestName("dia", {"diameter", "type"}), "diameter");
  EXPECT_EQ(nearestName("tol", {"tool", "tolerance"}), "tolerance");
  EXPECT_EQ(nearestName("out", {"output", "size"}), "output");
  EXPECT_EQ(nearestName("type", {"shape", "file"}), "shape");
  EXPECT_EQ(nearestName("file", {"mesh", "unit"}), "mesh");
  EXPECT_EQ(nearestName("path", {"shape", "file"}), "file");
  EXPECT_EQ(nearestName("type", {"number"}), "");
}

TEST(LoadJob, WritesDeviationsOfAPartThatIsCompared) {
  JobFolder folder;
  const auto job = folder.load(kSmallJob +
                               "[nominal]\nmesh = 'bracket.stl'\n[output]\nformats = ['3mf', 'glb']\n"
                               "deviation = ['csv', 'ply', 'glb']\n");
  ASSERT_TRUE(job) << folder.text();
  EXPECT_THAT(job->output.formats, ElementsAre(OutputFormat::kThreeMf, OutputFormat::kGlb));
  EXPECT_THAT(job->output.deviation,
              ElementsAre(DeviationOutput::kCsv, DeviationOutput::kPly, DeviationOutput::kGlb));
}

TEST(LoadJob, FilesThatStateTheirUnitTakeNone) {
  JobFolder folder;
  folder.write("bracket.3mf", "");
  folder.write("bracket.glb", "");
  for (const std::string ending : {"3mf", "glb"}) {
    const std::string nominal = "[nominal]\nmesh = 'bracket." + ending + "'\n";
    folder.clear();
    EXPECT_TRUE(folder.load(kSmallJob + nominal)) << folder.text();
    EXPECT_THAT(
        folder.refusal(kSmallJob + nominal + "unit = 'inch'\n"),
        HasSubstr("a " + std::string(ending == "glb" ? "GLB" : "3MF") + " file states its unit itself"));
  }
}

}  // namespace
}  // namespace proveout
