#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "job_fixture.h"

namespace proveout {
namespace {

using io_test::kSmallJob;
using io_test::replacedOnce;
using ::testing::HasSubstr;

/// The small job with setups in place of its program.
std::string withSetups(const std::string& setups) {
  return replacedOnce(kSmallJob, "program = \"bracket.nc\"\n", "") + setups;
}

const std::string kTwo =
    "[[setup]]\nname = \"top\"\nprogram = \"bracket.nc\"\n"
    "[[setup]]\nprogram = \"back.nc\"\nsubprograms = [\"subs\"]\nstart = [1, 2, 3]\n";

class JobSetups : public testing::Test {
 protected:
  JobSetups() {
    folder.write("back.nc", "M30\n");
    folder.write("subs/O1.nc", "M99\n");
  }
  io_test::JobFolder folder;
};

TEST_F(JobSetups, LieWhereTheirPlacementSays) {
  const auto job = folder.load(withSetups("[placement]\norigin = [1, 2, 3]\nrotation = 5\n" + kTwo +
                                          "[setup.placement]\norigin = [4, 5, 6]\n"));
  ASSERT_TRUE(job.has_value()) << folder.text();
  const WorkpiecePlacement top = jobOfSetup(*job, 0).settings.placement,
                           back = jobOfSetup(*job, 1).settings.placement;
  EXPECT_EQ(top.origin, Vec3(1, 2, 3));
  EXPECT_EQ(top.rotation_deg, 5.0);
  EXPECT_EQ(back.origin, Vec3(4, 5, 6));
  EXPECT_EQ(back.rotation_deg, 5.0);
}

TEST_F(JobSetups, PlacementIsChecked) {
  EXPECT_FALSE(folder.load(withSetups("[placement]\norign = [1, 2, 3]\n" + kTwo)).has_value());
  EXPECT_THAT(folder.text(), HasSubstr("origin"));
  EXPECT_FALSE(folder.load(withSetups("[placement]\nrotation = nan\n" + kTwo)).has_value());
}

TEST_F(JobSetups, AreReadInTheirOrder) {
  const auto job = folder.load(
      withSetups("[offsets.work]\nG54 = [1, 2, 3]\nG55 = [4, 5, 6]\n[panel]\nblock_skip = [1]\n" + kTwo +
                 "[setup.transform]\nrotate = [180, 0, 0]\ntranslate = [0, 40, -20]\n"
                 "[setup.offsets.work]\nG55 = [7, 8, 9]\n[setup.panel]\nblock_skip = [2]\n"));
  ASSERT_TRUE(job.has_value()) << folder.text();
  ASSERT_EQ(setupCount(*job), 2u);
  EXPECT_EQ(job->setups[0].name, "top");
  EXPECT_EQ(job->setups[1].name, "2");
  const Job top = jobOfSetup(*job, 0), back = jobOfSetup(*job, 1);
  EXPECT_THAT(top.program, HasSubstr("bracket.nc"));
  EXPECT_FALSE(top.start.has_value());
  EXPECT_EQ(top.settings.work_offsets[1], Vec3(4, 5, 6));
  EXPECT_THAT(back.program, HasSubstr("back.nc"));
  ASSERT_EQ(back.subprograms.size(), 1u);
  EXPECT_EQ(*back.start, Vec3(1, 2, 3));
  EXPECT_EQ(back.settings.work_offsets[0], Vec3(1, 2, 3));
  EXPECT_EQ(back.settings.work_offsets[1], Vec3(7, 8, 9));
  EXPECT_TRUE(top.settings.skip_switches[0]);
  EXPECT_TRUE(!back.settings.skip_switches[0] && back.settings.skip_switches[1]);
  EXPECT_EQ(job->setups[1].from_previous(Vec3(1, 2, 3)), Vec3(1, 38, -23));
  EXPECT_EQ(setupCount(back), 1u);
}

TEST_F(JobSetups, TransformByAxisAndAngle) {
  const auto job = folder.load(
      withSetups(kTwo + "transform = { axis = [0, 0, 2], angle = 90, translate = [10, 0, 0] }\n"));
  ASSERT_TRUE(job.has_value()) << folder.text();
  EXPECT_EQ(job->setups[1].from_previous(Vec3(1, 2, 3)), Vec3(8, 1, 3));
}

TEST_F(JobSetups, WithoutThemTheJobIsOneSetup) {
  const auto job = folder.load(kSmallJob);
  ASSERT_TRUE(job.has_value()) << folder.text();
  EXPECT_EQ(setupCount(*job), 1u);
  EXPECT_EQ(jobOfSetup(*job, 0).program, job->program);
}

TEST_F(JobSetups, WrongOnesAreRefused) {
  EXPECT_THAT(folder.refusal(kSmallJob + kTwo), HasSubstr("with [[setup]], program belongs to the setups"));
  EXPECT_THAT(folder.refusal(withSetups("[[setup]]\nname = \"top\"\n")),
              HasSubstr("[[setup]] 1 needs the key 'program'"));
  EXPECT_THAT(folder.refusal(withSetups("[[setup]]\nprogram = \"bracket.nc\"\n[setup.transform]\n")),
              HasSubstr("the first setup has no transform"));
  EXPECT_THAT(folder.refusal(withSetups(kTwo + "[setup.transform]\nrotate = [0, 0, 90]\nangle = 3\n")),
              HasSubstr("not both"));
  EXPECT_THAT(folder.refusal(withSetups(kTwo + "[setup.transform]\naxis = [0, 0, 0]\nangle = 3\n")),
              HasSubstr("axis must not be zero"));
  EXPECT_THAT(folder.refusal(withSetups(kTwo + "[setup.transform]\nrotatte = [0, 0, 90]\n")),
              HasSubstr("did you mean 'rotate'?"));
  EXPECT_THAT(folder.refusal(withSetups(kTwo + "[setup.transform]\nrotate = [0, 0, nan]\n")),
              HasSubstr("rotate"));
  EXPECT_THAT(folder.refusal(withSetups(kTwo + "[[setup]]\nname = \"top\"\nprogram = \"back.nc\"\n")),
              HasSubstr("there are two setups with the name 'top'"));
  EXPECT_THAT(folder.refusal(withSetups("[[setup]]\nprogram = \"none.nc\"\n")), HasSubstr("none.nc"));
  EXPECT_THAT(folder.refusal(withSetups(kTwo + "progam = \"x\"\n")), HasSubstr("[[setup]] 2 has no key"));
  EXPECT_THAT(folder.refusal("setup = []\n" + withSetups("")), HasSubstr("at least one table"));
  EXPECT_THAT(folder.refusal("setup = 3\n" + withSetups("")), HasSubstr("a list"));
}

class JobFixtures : public JobSetups {};

const std::string kVise = "[[fixture]]\nname = \"vise\"\nmesh = \"bracket.stl\"\nunit = \"inch\"\n";
const std::string kPin = "[[fixture]]\nshape = \"cylinder\"\nbase = [1, 2, 3]\nlength = 4\ndiameter = 5\n";

TEST_F(JobFixtures, AreMeshesOrShapes) {
  const auto job = folder.load(kSmallJob + kVise + kPin);
  ASSERT_TRUE(job.has_value()) << folder.text();
  ASSERT_EQ(job->fixtures.size(), 2u);
  EXPECT_EQ(job->fixtures[0].name, "vise");
  EXPECT_EQ(std::get<MeshFile>(job->fixtures[0].shape).unit, MeshUnit::kInch);
  EXPECT_EQ(job->fixtures[1].name, "2");
  EXPECT_EQ(std::get<CylinderShape>(job->fixtures[1].shape).radius, 2.5);
}

TEST_F(JobFixtures, BelongToTheirSetup) {
  const auto job = folder.load(withSetups(kTwo + replacedOnce(kPin, "[[fixture]]", "[[setup.fixture]]")));
  ASSERT_TRUE(job.has_value()) << folder.text();
  EXPECT_TRUE(jobOfSetup(*job, 0).fixtures.empty());
  ASSERT_EQ(jobOfSetup(*job, 1).fixtures.size(), 1u);
}

TEST_F(JobFixtures, WrongOnesAreRefused) {
  EXPECT_THAT(folder.refusal(kSmallJob + "[[fixture]]\nname = \"vise\"\n"), HasSubstr("mesh or shape"));
  EXPECT_THAT(folder.refusal(kSmallJob + kVise + "shape = \"box\"\n"), HasSubstr("not both"));
  EXPECT_THAT(folder.refusal(kSmallJob + kVise + kVise), HasSubstr("two fixtures with the name 'vise'"));
  EXPECT_THAT(folder.refusal(kSmallJob + "[[fixture]]\nmesh = \"none.stl\"\n"), HasSubstr("none.stl"));
  EXPECT_THAT(folder.refusal(kSmallJob + "[[fixture]]\nshape = \"vdb\"\n"),
              HasSubstr("there are box, cylinder, tube"));
  EXPECT_THAT(folder.refusal(kSmallJob + "[[fixture]]\nshape = \"box\"\nmin = [0, 0, 0]\nmax = [1, 0, 1]\n"),
              HasSubstr("max must be above min"));
  EXPECT_THAT(folder.refusal(kSmallJob + kVise + "diameter = 3\n"), HasSubstr("has no key 'diameter'"));
  EXPECT_THAT(folder.refusal(withSetups(kTwo + kVise)),
              HasSubstr("with [[setup]], fixture belongs to the setups"));
}

TEST(CuttingLimits, OfTheMachineAndOfTools) {
  io_test::JobFolder folder;
  const std::string tool = "teeth = 4\nmax_feed_per_tooth = 0.1\nmax_rpm = 9000\n";
  Diagnostics diagnostics;
  const std::string machine = "[machine]\nmax_feed = 1000\nmax_rpm = 8000\n";
  const auto job =
      parseJob(kSmallJob + tool + machine, "job.toml", folder.path(""), folder.names, diagnostics);
  ASSERT_TRUE(job);
  EXPECT_EQ(job->limits.max_feed, 1000);
  EXPECT_EQ(job->limits.max_rpm, 8000);
  const ToolLimits& limits = job->limits.tools.at(1);
  EXPECT_EQ(limits.teeth, 4);
  EXPECT_EQ(limits.max_feed_per_tooth, 0.1);
  EXPECT_EQ(limits.max_rpm, 9000);
  for (const char* wrong : {"max_feed_per_tooth = 0.1\n", "teeth = 0\n", "max_rpm = 0\n",
                            "[machine]\nmax_feed = -3\n", "[machine]\nmax_rpm = 0\n"}) {
    Diagnostics errors;
    EXPECT_FALSE(parseJob(kSmallJob + wrong, "job.toml", folder.path(""), folder.names, errors)) << wrong;
  }
}

}  // namespace
}  // namespace proveout
