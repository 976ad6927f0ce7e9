// Loops that move and count: those without an end are told, and programs with an end run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "control_path.h"

namespace proveout {
namespace {

using test::ControlPath;
using testing::HasSubstr;

constexpr std::uint64_t kBlocks = 1'000'000;  ///< 50,000 motions; 2,000 are let be

ControlPath run(ControlId control, const std::string& text, std::uint64_t block_limit = kBlocks) {
  ControlSettings settings;
  settings.block_limit = block_limit;
  if (control == ControlId::kFlexNc) settings.start = Vec3(100.0, 0.0, 50.0);
  return {control, text, settings};
}

/// Ends with that error in that line (from 1), after few motions.
void expectEnded(ControlId control, const std::string& text, const std::string& code, int line,
                 const std::string& said) {
  const ControlPath ended = run(control, text);
  const Diagnostic error = ended.first(Severity::kError);
  EXPECT_EQ(error.code, code) << text;
  EXPECT_EQ(error.where.line, line) << error.message;
  EXPECT_THAT(error.message, HasSubstr(said)) << text;
  EXPECT_EQ(ended.summary.end, ProgramEnd::kBlockLimit);
  EXPECT_LE(ended.count(), 4'200u) << text;
}

void expectRuns(ControlId control, const std::string& text, std::size_t motions) {
  const ControlPath done = run(control, text, ControlSettings{}.block_limit);
  EXPECT_EQ(done.summary.end, ProgramEnd::kEndOfProgram) << done.first(Severity::kError).message;
  EXPECT_EQ(done.count(), motions) << text;
}

TEST(EndlessLoops, OfNct) {
  const auto ended = [](const std::string& text, int line, const std::string& said) {
    expectEnded(ControlId::kNct, text, "nct-endless-loop", line, said);
  };
  ended("G90\n#1=3\nWHILE[1 GT 0] DO1\nG1 X#1 F500\n#1=#1-1\nEND1\nM30\n", 3,
        "lines 3 to 6: the program came back from line 6 to line 3");
  ended("#1=0\nWHILE[#1 GE 0] DO1\nG1 X#1 F500\n#1=#1+1\nEND1\nM30\n", 2, "#1 from");
  ended("#1=0\nWHILE[#1 NE 7] DO1\nG1 X#1 F500\n#1=#1+2\nEND1\nM30\n", 2, "endless");
  ended("G91\nN10 G1 X1 F500\n#1=#1+1\nIF[#1 LT 0] GOTO 20\nGOTO 10\nN20 M30\n", 2, "X from");
  ended("G91\nN10 G1 X1 F500\n#1=#1+1\nM99 P10\n", 2, "from line 4 to line 2");
  ended("#1=0\nWHILE[1 GT 0] DO1\n#2=0\nWHILE[#2 LT 5] DO2\nG1 X[#1+#2] F500\n#2=#2+1\nEND2\n#1=#1+1\nEND1\n",
        2, "lines 2 to 9");
  ended("#1=0\nDO1\nIF[#2 EQ 1] GOTO 5\nG1 X#1 F500\nN5 #2=1-#2\n#1=#1+1\nEND1\n", 2, "endless");
}

/// Programs of nct that call each other.
MemoryProgramSource called(const std::string& main, const std::vector<std::string>& subs) {
  MemoryProgramSource source("main.nc", main);
  int number = 10;
  for (const std::string& sub : subs) source.add("O00" + std::to_string(number++) + ".nc", sub);
  return source;
}

TEST(EndlessLoops, OfCallsThatAreRepeated) {
  const MemoryProgramSource deep = called(
      "M98 P10 L999\nM30\n", {"G91 G1 X1 F500\nM98 P11 L999\nM99\n", "X1\nM98 P12 L999\nM99\n", "X1\nM99\n"});
  ControlSettings settings;
  settings.block_limit = kBlocks;
  Toolpath path;
  ToolpathBuilder builder(path);
  EXPECT_EQ(interpret(ControlId::kNct, deep, settings, builder).end, ProgramEnd::kBlockLimit);
  EXPECT_LE(path.motions.size(), 4'200u);
  ASSERT_FALSE(path.diagnostics.all().empty());
  EXPECT_EQ(path.diagnostics.all().front().code, "nct-endless-loop");
  EXPECT_THAT(path.diagnostics.all().front().message, HasSubstr("of 999 of the call in line 2"));
  expectEnded(ControlId::kWedm,
              "G92 X0 Y0;\nG91;\nM98 P0001 L999;\nM02;\nN0001;\nG01 X1.;\nM98 P0002 L999;\nM99;\n"
              "N0002;\nX0.01;\nY0.01;\nM98 P0003 L999;\nM99;\nN0003;\nX0.01;\nM99;\n",
              "wedm-endless-loop", 9, "of 999");
}

TEST(EndlessLoops, OfOtherControls) {
  expectEnded(ControlId::kWl4Mill, "%E\nG54\nG91\nN010 G1 U1 F500 #30=(#30+1)\nU-1 N10\nM30\n%\n",
              "wl4-endless-loop", 4, "#30 from");
  expectEnded(ControlId::kWl4Mill, "%E\nG54\n#30=0\nN010 G1 X#30 F500\n#30=(#30+1)\nIF(#30>-1) N10\nM30\n%\n",
              "wl4-endless-loop", 4, "lines 4 to 6");
  expectEnded(ControlId::kFlexNc,
              "T1M06D1\nS300M03\nG98F100\nG91G00X1\nN1\nZ1\nP1200=P1200+1\nP200=5\nREPEAT9(P200)FROM1\nM02\n",
              "fnc-endless-loop", 6, "P1200 from");
}

TEST(EndlessLoops, ProgramsWithAnEndRun) {
  expectRuns(ControlId::kNct,
             "#1=0\nWHILE[#1 LT 100000] DO1\n#1=#1+1\nG1 X#1 F500\nG1 Y#1\nG1 Z#1\nEND1\nM30\n", 300'000);
  // A grid of holes, a helix of short chords by GOTO, and a subprogram that counts itself.
  expectRuns(
      ControlId::kNct,
      "#1=0\nWHILE[#1 LT 400] DO1\n#2=0\nWHILE[#2 LT 200] DO2\nG0 X[#1+1] Y#2\nG1 Z-1 F500\nG0 Z1\n#2=#2+1\n"
      "END2\n#1=#1+1\nEND1\nM30\n",
      400 * 200 * 3);
  expectRuns(
      ControlId::kNct,
      "#1=0\nN10 #1=#1+0.125\nG1 X[10*COS[#1]] Y[10*SIN[#1]] Z[-#1/360] F500\nIF[#1 LT 26250] GOTO 10\nM30\n",
      210'000);
  Toolpath path;
  ToolpathBuilder builder(path);
  const MemoryProgramSource counted = called("M98 P10 L210000\nM30\n", {"G91 G1 X1 F500\nM99\n"});
  EXPECT_EQ(interpret(ControlId::kNct, counted, {}, builder).end, ProgramEnd::kEndOfProgram);
  EXPECT_EQ(path.motions.size(), 210'000u);
  expectRuns(ControlId::kWl4Mill,
             "%E\nG54\n#30=1\nN010 G1 X(#30/1000) F500\n#30=(#30+1)\nIF(#30<210000) N10\nM30\n%\n", 209'999);
}

}  // namespace
}  // namespace proveout
