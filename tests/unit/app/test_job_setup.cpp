#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/job_setup.h"
#include "app/session/programs/interpretation.h"
#include "app/session/run/blank.h"
#include "app/session/run/job_defaults.h"
#include "tests/support/temporary_folder.h"

namespace proveout {
namespace {

RunOptions programOptions(const test::TemporaryFolder& folder) {
  RunOptions options;
  options.program.input = folder.write("a.nc", "G0 X1\nM30\n");
  options.program.control = "nct";
  options.stock = "box:0,0,-10:20,30,0";
  options.tools = {"3=flat:6", "2=ball:4"};
  return options;
}

std::optional<Job> setUp(const RunOptions& options, std::string* messages = nullptr) {
  Diagnostics diagnostics;
  std::optional<Job> job = setUpJob(options.program, diagnostics);
  if (job && !applyRunOptions(options, *job, diagnostics)) job.reset();
  for (const Diagnostic& d : diagnostics.all()) {
    if (messages) *messages += d.message + "\n";
  }
  return job;
}

TEST(JobSetup, ProgramWithOptionsMakesAJob) {
  const test::TemporaryFolder folder;
  RunOptions options = programOptions(folder);
  options.program.until = "n70";
  options.resolution_mm = 0.3;
  const std::optional<Job> job = setUp(options);
  ASSERT_TRUE(job.has_value());
  EXPECT_EQ(job->name, "a");
  EXPECT_EQ(job->tools.size(), 2u);
  EXPECT_EQ(job->settings.until->block, 70);
  EXPECT_FALSE(job->settings.until->line.has_value());
  EXPECT_EQ(outputFolder(options, *job), "a-out");
  EXPECT_DOUBLE_EQ(*job->simulation.resolution_mm, 0.3);
}

TEST(JobSetup, RefusesWhatDoesNotFit) {
  const test::TemporaryFolder folder;
  const auto message = [&](auto change) {
    RunOptions options = programOptions(folder);
    change(options);
    std::string messages;
    EXPECT_FALSE(setUp(options, &messages).has_value());
    return messages;
  };
  const auto has = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
  };
  EXPECT_TRUE(has(message([](RunOptions& o) { o.program.control.reset(); }), "--control"));
  EXPECT_TRUE(has(message([](RunOptions& o) { o.program.control = "fanuc"; }), "nct"));
  EXPECT_TRUE(has(message([](RunOptions& o) { o.program.input = "/nowhere/x.nc"; }), "/nowhere/x.nc"));
  EXPECT_TRUE(has(message([](RunOptions& o) { o.program.input = "/"; }), "/"));
  EXPECT_TRUE(has(message([](RunOptions& o) { o.stock.reset(); }), "--stock"));
  EXPECT_TRUE(has(message([](RunOptions& o) { o.stock = "sphere:1"; }), "--stock"));
  EXPECT_TRUE(has(message([](RunOptions& o) { o.stock = "box:0,0,nan:1,1,1"; }), "--stock"));
  EXPECT_TRUE(has(message([](RunOptions& o) { o.tools.clear(); }), "tool"));
  EXPECT_TRUE(has(message([](RunOptions& o) { o.tools = {"1=spoon:3"}; }), "--tool"));
  EXPECT_TRUE(has(message([](RunOptions& o) { o.tools = {"1=flat:3", "1=ball:3"}; }), "twice"));
  EXPECT_TRUE(has(message([](RunOptions& o) { o.nominal = "/nowhere.stl"; }), "--nominal"));
  EXPECT_TRUE(has(message([](RunOptions& o) { o.tolerance_mm = 0.1; }), "--tolerance"));
  EXPECT_TRUE(has(message([](RunOptions& o) { o.formats = "stl,step"; }), "--format"));
  EXPECT_TRUE(has(message([](RunOptions& o) { o.views = {"sideways"}; }), "iso-back"));
  EXPECT_TRUE(has(message([](RunOptions& o) { o.size = "8x8"; }), "--size"));
  EXPECT_TRUE(has(message([](RunOptions& o) { o.no_render = true, o.views = {"iso"}; }), "--no-render"));
  for (const char* until : {"", "N", "0", "-3", "x", "N-2", "7x", "N7x", "99999999999999999999"}) {
    EXPECT_TRUE(has(message([&](RunOptions& o) { o.program.until = until; }), "--until")) << until;
  }
}

TEST(JobSetup, JobFileRefusesProgramOptions) {
  const test::TemporaryFolder folder;
  folder.write("a.nc", "M30\n");
  RunOptions options;
  options.program.input =
      folder.write("a.toml",
                   "schema = \"proveout.job/1\"\nname = \"a\"\ncontrol = \"nct\"\n"
                   "program = \"a.nc\"\n[stock]\nshape = \"box\"\nmin = [0, 0, -1]\n"
                   "max = [1, 1, 0]\n[[tool]]\nnumber = 1\ntype = \"flat\"\ndiameter = 1\n");
  ASSERT_TRUE(setUp(options).has_value());
  std::string messages;
  options.stock = "box:0,0,0:1,1,1";
  EXPECT_FALSE(setUp(options, &messages).has_value());
  EXPECT_NE(messages.find("--stock goes with a program"), std::string::npos);
  options.stock.reset();
  options.program.control = "nct";
  EXPECT_FALSE(setUp(options).has_value());
}

TEST(JobSetup, FileNamesStayInTheFolder) {
  EXPECT_EQ(fileName("bear"), "bear");
  EXPECT_EQ(fileName("../up/a b"), "_.._up_a_b");
  EXPECT_EQ(fileName(""), "_");
  EXPECT_EQ(fileName(".hidden"), "_.hidden");
  EXPECT_EQ(fileName("\xd0\xba-1"), "\xd0\xba-1");
}

TEST(JobSetup, DefaultsForGridAndStart) {
  EXPECT_DOUBLE_EQ(defaultResolution({{0, 0, -20}, {80, 80, 0}}), 0.2);
  EXPECT_DOUBLE_EQ(defaultResolution({{0, 0, 0}, {400, 1, 1}}), 1.0);
  EXPECT_DOUBLE_EQ(defaultResolution({{0, 0, 0}, {401, 1, 1}}), 2.0);
  EXPECT_DOUBLE_EQ(defaultResolution({{0, 0, 0}, {20, 20, 20}}), 0.05);
  const Vec3 over_zero = defaultStart({{-5, -5, -10}, {10, 10, 2}});
  EXPECT_EQ(over_zero, Vec3(0, 0, 102));
  EXPECT_EQ(defaultStart({{10, 20, -10}, {30, 40, 0}}), Vec3(20, 30, 100));
}

TEST(Blank, StartInsideIsRefused) {
  Job job;
  job.stock = CylinderShape{2, {0, 0, 0}, 10, 4, 30};
  Progress progress;
  const Result<Blank> blank = openBlank(job, progress);
  ASSERT_TRUE(blank.ok());
  EXPECT_EQ(blank->bounds.min, Vec3(-10, -10, 0));
  EXPECT_EQ(blank->bounds.max, Vec3(10, 10, 30));
  EXPECT_TRUE(checkStart(job, *blank).ok());
  job.start = Vec3(7, 0, 15);
  EXPECT_FALSE(checkStart(job, *blank).ok());
  job.start = Vec3(2, 0, 15);  // in the bore
  EXPECT_TRUE(checkStart(job, *blank).ok());
  job.start = Vec3(7, 0, 30);  // on the face
  EXPECT_TRUE(checkStart(job, *blank).ok());
}

TEST(Interpretation, ToolsThatTheJobLacksTakeTheShapeOfTheirOffsetRow) {
  Toolpath path;
  const auto shape = [&](int tool, double diameter, double corner) {
    PathEvent event;
    event.what = event::ToolShape{tool, 1, diameter, corner};
    path.events.push_back({0, event});
  };
  shape(1, 10, 2);
  shape(2, 10, 0);
  shape(2, 12, 0);  // the first one counts
  shape(3, 10, 5);
  shape(4, 10, 6);
  shape(0, 10, 1);
  shape(7, 10, 1);
  std::vector<Tool> tools(1);
  tools[0].number = 7;
  tools[0].diameter = 3;
  addOffsetTools(path, tools);
  ASSERT_EQ(tools.size(), 4u);
  EXPECT_EQ(tools[0].diameter, 3);
  EXPECT_EQ(tools[1].type, ToolType::kBull);
  EXPECT_EQ(tools[1].corner_radius, 2);
  EXPECT_EQ(tools[2].type, ToolType::kFlat);
  EXPECT_EQ(tools[2].diameter, 10);
  EXPECT_EQ(tools[3].type, ToolType::kBall);
  for (const Tool& tool : tools) EXPECT_TRUE(tool.number == 7 || validateTool(tool).ok());
  EXPECT_EQ(path.diagnostics.all().size(), 3u);
}

TEST(Interpretation, MotionsWithoutAToolTakeTheLowest) {
  const MemoryProgramSource memory("a.nc", "G0 X1\n");
  const RecordingSource source(memory, TextEncoding::kAuto);
  ASSERT_TRUE(source.mainProgram().ok());
  Toolpath path;
  path.files = {"a.nc"};
  path.motions.resize(3);
  for (Motion& motion : path.motions) motion.source.line = 1;
  path.motions[2].tool = 7;
  std::vector<Tool> tools(2);
  tools[0].number = 7;
  tools[1].number = 3;
  EXPECT_TRUE(assignTools(path, tools, source));
  EXPECT_EQ(path.motions[0].tool, 3);
  EXPECT_EQ(path.motions[2].tool, 7);
  ASSERT_EQ(path.diagnostics.all().size(), 1u);
  EXPECT_EQ(path.diagnostics.all()[0].severity, Severity::kNote);
  EXPECT_EQ(path.diagnostics.all()[0].source_line, "G0 X1");
  path.motions[1].tool = 9;
  EXPECT_FALSE(assignTools(path, tools, source));
  EXPECT_NE(path.diagnostics.all().back().message.find("tool 9 is not defined"), std::string::npos);
}

}  // namespace
}  // namespace proveout
