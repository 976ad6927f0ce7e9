// A control of the ISO family out of ten codes and a few tables: what another maker's control has to hand in.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/model/code_rows.h"
#include "core/nc/iso/model/dialect.h"
#include "core/nc/iso/parameters/motion.h"
#include "core/nc/iso/parameters/parameter_rows.h"
#include "core/nc/iso/program/control.h"
#include "core/nc/iso/system_variables/all_banks.h"

namespace proveout::nc {
namespace {

constexpr AddressSet kAxisWords = "XYZ";

constexpr auto kG = std::to_array<GCode>({
    rows::action(0, kGroupMotion, CodeClass::kSim, kAxisWords, planRapid, false, "", "rapid"),
    rows::action(10, kGroupMotion, CodeClass::kSim, kAxisWords, planLine, false, "", "line"),
    rows::action(20, kGroupMotion, CodeClass::kSim, "XYZIJKR", planArc, false, "", "arc, clockwise"),
    rows::action(30, kGroupMotion, CodeClass::kSim, "XYZIJKR", planArc, false, "", "arc, counter-clockwise"),
    rows::action(40, kOneShot, CodeClass::kTime, "P", planDwell, false, "", "dwell"),
    rows::modal(200, kGroupUnits, CodeClass::kSim, "", "inch"),
    rows::modal(210, kGroupUnits, CodeClass::kSim, "", "millimetres"),
    rows::modal(540, kGroupWorkSystem, CodeClass::kSim, "", "work system 1"),
    rows::modal(900, kGroupDistance, CodeClass::kSim, "", "absolute"),
    rows::modal(910, kGroupDistance, CodeClass::kSim, "", "incremental"),
});
constexpr auto kM = std::to_array<MCode>({
    {30, MPhase::kEnd, kFlowCodes, CodeClass::kState, {}, "", "end"},
    {98, MPhase::kCall, kFlowCodes, CodeClass::kSim, "PL", "", "call"},
    {99, MPhase::kCall, kFlowCodes, CodeClass::kSim, "PL", "", "return"},
});

const AlarmTable& alarms() {
  static const AlarmTable kTable{"ten",
                                 {{SharedAlarm::kOutOfRange, 3, {}, "too many digits: {}"},
                                  {SharedAlarm::kIllegalAddress, 9, {}, "illegal address {}"},
                                  {SharedAlarm::kNotImplemented, 10, {}, "improper G-code: {}"},
                                  {SharedAlarm::kCircleRadius, 20, {}, "over tolerance of radius"},
                                  {SharedAlarm::kProgramNotFound, 78, {}, "number not found"},
                                  {SharedAlarm::kBlockNotFound, 0, "sequence", "no block {}"}}};
  return kTable;
}

/// Power, and relations and AND as operators of a formula.
constexpr auto kOperators = std::to_array<FormulaOperator>({
    {"AND", 1, Operation::kAnd},
    {"EQ", 2, Operation::kEqual},
    {"GT", 2, Operation::kGreater},
    {"+", 3, Operation::kAdd},
    {"-", 3, Operation::kSubtract},
    {"**", 5, Operation::kPower},
    {"*", 4, Operation::kMultiply},
    {"/", 4, Operation::kDivide},
});
constexpr auto kFunctions = std::to_array<FormulaFunction>({{"ABS", absoluteValue}});
constexpr FormulaRules formulaRules() {
  FormulaRules rules;
  rules.whole_conditions = true;
  return rules;
}
constexpr FormulaLanguage kFormulas{formulaRules(), FormulaRows(kOperators), FormulaRows(kFunctions)};

/// Coordinates without a point count in 0.001 mm or 0.0001 inch.
bool takeIncrements(IsoContext& c) {
  bool inch = c.state.active[kGroupUnits] == gcode::kInch;
  for (const Word& w : c.block.words)
    inch = (inch || (w.address == 'G' && w.value == 20.0)) && w.value != 21.0;
  for (Word& w : c.block.words) {
    if (AddressSet("XYZIJKR").has(w.address) && !w.point && !w.from_expression) w.value *= inch ? 1e-4 : 1e-3;
  }
  return true;
}

const IsoDialect& dialect() {
  using namespace param_rows;
  static const CodeIndex kCodes({{kG, kM, {}}});
  static const ParameterTable kParameters = [] {
    ParameterTable table("ten");
    table.add(MotionParam::kRadiusDifference,
              number("3410", 3410, kChannel, 0.02, 0, 1, "arc tolerance, mm"));
    return table;
  }();
  static const IsoDialect kTen{
      .name = "ten",
      .alarms = alarms(),
      .codes = kCodes,
      .parameters = kParameters,
      .formulas = kFormulas,
      .layout = ProgramLayout::kSeveralInAFile,
      .system_variables = allBanks,
      .take_words = takeIncrements,
  };
  return kTen;
}

struct Ran {
  Toolpath path;
  InterpretSummary summary;

  explicit Ran(const std::string& text, std::map<std::string, double> parameters = {}) {
    ControlSettings settings;
    settings.start = Vec3::Zero();
    settings.parameters = std::move(parameters);
    MemoryProgramSource source("main.nc", text);
    ToolpathBuilder sink(path);
    IsoControl control(dialect(), source, settings, sink, nullptr, ControlHost{});
    summary = control.run();
  }
  Vec3 end() const { return path.motions.empty() ? Vec3::Zero() : path.motions.back().to; }
  std::string firstCode() const {
    return path.diagnostics.all().empty() ? "" : path.diagnostics.all().front().code;
  }
  std::string firstMessage() const {
    return path.diagnostics.all().empty() ? "" : path.diagnostics.all().front().message;
  }
};

TEST(IsoDialect, WordsWithoutAPointCountInIncrements) {
  EXPECT_TRUE(Ran("O1\nG21 G90 G0 X10000 Y2.5 Z#1\nM30\n").end().isApprox(Vec3(10, 2.5, 0)));
  EXPECT_TRUE(Ran("O1\nG20 G90 G0 X10000 Y1.\nM30\n").end().isApprox(Vec3(25.4, 25.4, 0)));
  EXPECT_TRUE(Ran("O1\n#1=3\nG0 X#1 Y[#1*2]\nIF[#1EQ3]G0 X1500\nM30\n").end().isApprox(Vec3(1.5, 6, 0)));
}

TEST(IsoDialect, FormulasHaveTheMakersRanks) {
  EXPECT_TRUE(Ran("O1\n#1=2\nG0 X[1+#1**3*2] Y[#1 GT 1 AND 3 EQ 3]\nM30\n").end().isApprox(Vec3(17, 1, 0)));
  EXPECT_TRUE(Ran("O1\nIF[1+1 EQ 2 AND 2 GT 1] G0 X2.\nM30\n").end().isApprox(Vec3(2, 0, 0)));
  EXPECT_FALSE(Ran("O1\nG0 X[SIN[30]]\nM30\n").summary.ok()) << "it has no such function";
}

TEST(IsoDialect, SubprogramsStandInTheSameFile) {
  const Ran ran(
      "%\nO0001\nG90 G0 X0 Y0\nM98 P22 L3\nG90 G1 Y7. F100.\nM30\n"
      "O0002\nG1 X99.\nM99\n"
      "O0022\nN10 G91 G1 X1. F100.\nM99\n%\n");
  ASSERT_TRUE(ran.summary.ok()) << ran.firstMessage();
  EXPECT_TRUE(ran.end().isApprox(Vec3(3, 7, 0)));
  ASSERT_EQ(ran.path.motions.size(), 4u);
  EXPECT_EQ(ran.path.motions[0].source.line, 11u) << "lines count in the file";
  EXPECT_EQ(ran.path.motions[0].source.block, 10);
}

TEST(IsoDialect, TheMainProgramEndsWhereTheNextBegins) {
  const Ran ran("O1\nG0 X1.\nO2\nG0 X2.\nM30\n");
  EXPECT_EQ(ran.firstCode(), "ten-no-end");
  EXPECT_TRUE(ran.end().isApprox(Vec3(1, 0, 0)));
}

TEST(IsoDialect, AlarmsHaveTheMakersNumbersAndTexts) {
  const Ran unknown("O1\nG81 X1.\nM30\n");
  EXPECT_FALSE(unknown.summary.ok());
  EXPECT_EQ(unknown.firstCode(), "ten-010");
  EXPECT_TRUE(unknown.firstMessage().starts_with("improper G-code: G81")) << unknown.firstMessage();
  EXPECT_EQ(Ran("O1\nM98 P5\nM30\n").firstCode(), "ten-078");
  EXPECT_EQ(Ran("O1\nM98\nM30\n").firstCode(), "ten-missing-data") << "the maker has no number for it";
  EXPECT_EQ(Ran("O1\nG0 X1. G1 Y1.\nM30\n").firstCode(), "ten-group-clash");
  const Ran raised("O1\n#3000=7(TOOL BROKEN)\nM30\n");
  EXPECT_EQ(raised.firstCode(), "ten-3007");
}

TEST(IsoDialect, ParametersGoByTheMakersNames) {
  const std::string arc = "O1\nG2 X10.04 Y10. I10. J0. F100.\nM30\n";  // radii 10 and 10.0001
  EXPECT_TRUE(Ran(arc).summary.ok());
  const Ran strict(arc, {{"3410", 0.00001}});
  EXPECT_EQ(strict.firstCode(), "ten-020");
  EXPECT_EQ(Ran("O1\nM30\n", {{"N1339", 1}}).firstMessage(),
            "unknown parameter N1339 of control ten (nearest known: 3410)");
  EXPECT_TRUE(Ran("O1\nM30\n", {{"N1339", 1}}).firstCode() == "ten-parameter");
}

}  // namespace
}  // namespace proveout::nc
