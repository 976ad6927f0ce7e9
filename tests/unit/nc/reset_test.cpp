// Modal state at power-on and after a program's end, against the tables of the manual (chapter 3, 10).
// Proves nct-3-reset nct-3-CLR nct-3-N1300 nct-3-N1301 nct-13.1-M2 nct-13.1-M30 nct-3-poweron
#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <set>
#include <string>

#include "core/nc/iso/program/control.h"
#include "core/nc/nct/dialect.h"

namespace proveout::nc {
namespace {

/// A control that has run a program to its end.
class Ended {
 public:
  explicit Ended(const std::string& program, std::map<std::string, double> parameters = {},
                 LengthUnit units = LengthUnit::kMillimetre)
      : source_("main.nc", program) {
    settings_.parameters = std::move(parameters);
    settings_.units = units;
    settings_.start = Vec3(10, 20, 30);
    AxisSettings axis;
    axis.name = "C";
    settings_.axes.push_back(axis);
    control_ = std::make_unique<IsoControl>(nctDialect(), source_, settings_, sink_, nullptr, ControlHost{});
    summary_ = control_->run();
    EXPECT_TRUE(summary_.ok()) << program
                               << (path_.diagnostics.all().empty() ? "" : path_.diagnostics.all()[0].message);
  }
  IsoContext& c() { return control_->context(); }
  /// Code of a group, G number times ten.
  int code(IsoGroup group) { return c().state.active[static_cast<std::size_t>(group)]; }
  std::map<int, int> codes() {
    std::map<int, int> all;
    for (int group = 1; group < kGroupCount; ++group) all[group] = code(static_cast<IsoGroup>(group));
    return all;
  }

 private:
  MemoryProgramSource source_;
  ControlSettings settings_;
  Toolpath path_;
  ToolpathBuilder sink_{path_};
  std::unique_ptr<IsoControl> control_;
  InterpretSummary summary_;
};

/// One code of each group, other than that of power-on, as far as they go together at a program's end.
constexpr const char* kElsewhere =
    "G1 F100 G18 G91 G95 G20 G43 G99 G96 S50 G55 G62\n"
    "G51.1 X0\nG68 X0 Z0 R30\nG16\n";

/// The codes with a star in the manual's table (chapter 3), with all bits of N1300 and N1301 at 0.
const std::map<int, int> kStars{
    {kGroupMotion, 0},       {kGroupPlane, 170},   {kGroupDistance, 900},
    {kGroupFeedMode, 940},   {kGroupUnits, 210},   {kGroupRadiusComp, 400},
    {kGroupLengthComp, 490}, {kGroupCycle, 800},   {kGroupReturn, 980},
    {kGroupScaling, 500},    {kGroupMacro, 670},   {kGroupSurfaceSpeed, 970},
    {kGroupWorkSystem, 540}, {kGroupCutting, 640}, {kGroupRotation, 690},
    {kGroupPolarData, 150},  {kGroupMirror, 501},  {kGroupPolarInterpolation, 131}};

TEST(Reset, PowerOnSetsTheCodesWithAStar) {
  Ended run("X0\n");
  for (const auto& [group, code] : kStars) EXPECT_EQ(run.code(static_cast<IsoGroup>(group)), code) << group;
}

TEST(Reset, BitsOfN1300AndN1301ChooseAtPowerOnAndAtTheEnd) {
  struct Choice {
    const char* bit;
    IsoGroup group;
    int code;
  };
  for (const Choice& choice :
       {Choice{"N1300.G01", kGroupMotion, 10}, Choice{"N1300.G18", kGroupPlane, 180},
        Choice{"N1300.G19", kGroupPlane, 190}, Choice{"N1300.G20", kGroupUnits, 200},
        Choice{"N1300.G43", kGroupLengthComp, 430}, Choice{"N1300.G44", kGroupLengthComp, 440},
        Choice{"N1300.G91", kGroupDistance, 910}, Choice{"N1301.G95", kGroupFeedMode, 950}}) {
    Ended at_power_on("M99\n", {{choice.bit, 1}});
    EXPECT_EQ(at_power_on.code(choice.group), choice.code) << choice.bit;
    Ended at_end("G0 G17 G90 G94 G21 G49\nM30\n", {{choice.bit, 1}});
    EXPECT_EQ(at_end.code(choice.group), choice.code) << choice.bit;
    EXPECT_EQ(at_end.codes(), at_power_on.codes()) << choice.bit;
  }
}

TEST(Reset, TheJobsUnitHoldsUnlessTheParameterIsGiven) {
  EXPECT_EQ(Ended("M30\n", {}, LengthUnit::kInch).code(kGroupUnits), 200);
  EXPECT_EQ(Ended("G21\nM30\n", {}, LengthUnit::kInch).code(kGroupUnits), 200);
  EXPECT_EQ(Ended("M30\n", {{"N1300.G20", 0}}, LengthUnit::kInch).code(kGroupUnits), 210);
}

TEST(Reset, ProgramEndReturnsEveryGroup) {
  const std::map<int, int> power_on = Ended("M99\n").codes();
  for (const char* end : {"M2\n", "M30\n", ""}) {
    Ended run(std::string(kElsewhere) + end);
    EXPECT_EQ(run.codes(), power_on) << end;
    EXPECT_FALSE(run.c().state.transforms.any());
    EXPECT_EQ(run.c().state.work_system, 1);
    EXPECT_EQ(run.c().state.axes.plane_u, 0);
    EXPECT_EQ(run.c().state.axes.plane_w, 2);
  }
}

TEST(Reset, M99OfTheMainProgramKeepsEverything) {
  Ended run(std::string(kElsewhere) + "M99\n");
  EXPECT_EQ(run.code(kGroupPlane), 180);
  EXPECT_EQ(run.code(kGroupWorkSystem), 550);
  EXPECT_TRUE(run.c().state.transforms.rotates);
}

TEST(Reset, TablesKeepGroupsOneByOne) {
  const std::map<int, int> before = Ended(std::string(kElsewhere) + "M99\n").codes();
  const std::map<int, int> fresh = Ended("M99\n").codes();
  // G90 and G91, G20 and G21, G15 are set whatever the tables say.
  const std::set<int> always{kGroupDistance, kGroupUnits, kGroupPolarData, kGroupPolarInterpolation};
  int changed = 0;
  for (int kept = 1; kept < kGroupCount; ++kept) {
    Ended run(std::string(kElsewhere) + "M30\n",
              {{"N1301.CLR", 1}, {"CLR.C" + std::string(kept < 10 ? "0" : "") + std::to_string(kept), 1}});
    for (const auto& [group, code] : run.codes()) {
      const bool keeps = group == kept && !always.contains(group);
      EXPECT_EQ(code, keeps ? before.at(group) : fresh.at(group)) << "C" << kept << " group " << group;
      changed += keeps && before.at(group) != fresh.at(group);
    }
    EXPECT_EQ(run.c().state.work_system, kept == kGroupWorkSystem ? 2 : 1);
    EXPECT_EQ(run.c().state.transforms.rotates, kept == kGroupRotation);
    EXPECT_EQ(run.c().state.transforms.mirrored.any(), kept == kGroupMirror);
    EXPECT_EQ(run.c().state.axes.plane_u, kept == kGroupPlane ? 2 : 0);
  }
  EXPECT_GE(changed, 9);
}

TEST(Reset, TablesCountWithClrOnly) {
  Ended run(std::string(kElsewhere) + "M30\n", {{"CLR.C02", 1}, {"CLR.C14", 1}});
  EXPECT_EQ(run.code(kGroupPlane), 170);
  EXPECT_EQ(run.code(kGroupWorkSystem), 540);
}

TEST(Reset, ShiftsAndModesGoWhateverTheTablesSay) {
  std::map<std::string, double> keep_all{{"N1301.CLR", 1}};
  for (int k = 1; k < kGroupCount; ++k)
    keep_all["CLR.C" + std::string(k < 10 ? "0" : "") + std::to_string(k)] = 1;
  Ended shifted("G52 X5\nG92 Y7\nG10.9 X1\nM30\n", keep_all);
  EXPECT_TRUE(shifted.c().registers.frames.shift52.xyz.isZero());
  EXPECT_TRUE(shifted.c().registers.frames.shift92.xyz.isZero());
  EXPECT_FALSE(shifted.c().state.axes.diameter.any());
  EXPECT_NEAR(shifted.c().position[0], 10, 1e-12);
  EXPECT_NEAR(shifted.c().position[1], 20, 1e-12);
  Ended smooth("G5.1 Q2\nM30\n", keep_all);
  EXPECT_EQ(smooth.c().state.axes.smoothing, 0);
  Ended cylinder("G18 X0 C0\nG7.1 C20\nM30\n", keep_all);
  EXPECT_EQ(cylinder.c().state.axes.mode, VirtualMode::kOff);
  EXPECT_FALSE(cylinder.c().stages.virtual_plane.linked());
}

TEST(Reset, WordsTablesAndTheToolStay) {
  Ended run("G10 L2 P2 X3\nG10 L12 P4 R6\nF250 S900 M3\nT5 M6\nH0 D4\nM30\n");
  EXPECT_EQ(run.c().state.feed, 250);
  EXPECT_EQ(run.c().state.spindle_rpm, 900);
  EXPECT_EQ(run.c().state.tool, 5);
  EXPECT_EQ(run.c().state.d, 4);
  EXPECT_EQ(run.c().registers.frames.basic[1].offset.xyz.x(), 3);
  EXPECT_EQ(run.c().registers.offsets.effective(OffsetColumn::kRadius, 4), 6);
}

TEST(Reset, EndsCountParts) {
  EXPECT_EQ(Ended("#3901=4\nM30\n").c().registers.parts_made, 5);
  EXPECT_EQ(Ended("#3901=4\nM2\n").c().registers.parts_made, 5);
  EXPECT_EQ(Ended("#3901=4\nM77\nM30\n", {{"N2305", 77}}).c().registers.parts_made, 5);
  EXPECT_EQ(Ended("#3901=4\nM99\n").c().registers.parts_made, 4);
}

}  // namespace
}  // namespace proveout::nc
