// Custom macro B: expressions, null values, conditions, jumps, loops, alarms, output.
#include <gtest/gtest.h>

#include "core/nc/fanuc/alarms.h"
#include "core/nc/fanuc/macro/formulas.h"
#include "core/nc/macro/expression.h"
#include "tests/unit/nc/iso_run.h"

namespace proveout::test {
namespace {

using Lines = std::vector<std::string>;
using Settings = std::map<std::string, double>;

/// Rapids go straight, so that a block is one motion.
IsoRun macroMill(const std::string& text, Settings settings = {}) {
  settings.try_emplace("rapid", 1);
  return {ControlId::kFanucMill, text, runAtZero(settings)};
}

/// The value of an expression as DPRNT writes it with four decimals, or the code of its error.
std::string valueOf(const std::string& expression, const Settings& settings = {}) {
  MemoryProgramSource source("main.nc", "O1\n#100=" + expression + "\nDPRNT[#100[84]]\nM30\n");
  Toolpath path;
  ToolpathBuilder sink(path);
  MemoryOutput output;
  ControlHost host;
  host.output = &output;
  interpret(ControlId::kFanucMill, source, runAtZero(settings), sink, nullptr, host);
  for (const Diagnostic& d : path.diagnostics.all()) {
    if (d.severity == Severity::kError) return d.code;
  }
  // A sign stands in front of the blanks.
  std::string text = output.files().at("macro.txt");
  std::erase(text, ' ');
  return IsoRun::number(std::stod(text));
}

// Rows 32 to 36 of the acceptance are below. fan-12-expr
TEST(FanucMacro, OperatorsHaveTheirRanks) {
  const std::vector<std::pair<const char*, const char*>> kCases = {
      {"2+3*2", "8"},         {"10-3-2", "5"},      {"7 MOD 4*2", "6"},   {"5 OR 3+1", "8"},
      {"100/10/5", "2"},      {"2*[3+4]", "14"},    {"-2+3", "1"},        {"5*-2", "-10"},
      {"6 AND 3 OR 8", "10"}, {"5 XOR 1 + 2", "6"}, {"1+6 AND 3", "3"},   {"[[[[[1]]]]]", "1"},
      {"7 MOD -4", "3"},      {"-7 MOD 4", "-3"},   {"-#1", "0"},         {"#1+#2*3", "0"},
      {"1+2(TWO)*3", "7"},    {"SIN[30]*2", "1"},   {"2*SIN[30]+1", "2"}, {"8/2*4", "16"}};
  for (const auto& [text, value] : kCases) EXPECT_EQ(valueOf(text), value) << text;
}

// fan-12-func
TEST(FanucMacro, FunctionsHaveTheirValues) {
  const std::vector<std::pair<const char*, const char*>> kCases = {
      {"FIX[-2.7]", "-2"}, {"FIX[2.7]", "2"},     {"FUP[-2.1]", "-3"},
      {"FUP[2.1]", "3"},   {"ROUND[-2.5]", "-3"}, {"ROUND[2.5]", "3"},
      {"ROUND[2.4]", "2"}, {"RND[1.5]", "2"},     {"SQRT[16]", "4"},
      {"SQR[9]", "3"},     {"ABS[-3]", "3"},      {"LN[1]", "0"},
      {"EXP[0]", "1"},     {"POW[2,10]", "1024"}, {"POW[4,0.5]", "2"},
      {"BIN[18]", "12"},   {"BCD[12]", "18"},     {"BIN[BCD[1234]]", "1234"},
      {"ADP[3.5]", "3.5"}, {"COS[60]", "0.5"},    {"TAN[45]", "1"},
      {"ACOS[0.5]", "60"}, {"ACOS[-1]", "180"},   {"ATAN[1]", "45"},
      {"ATAN[-1]", "-45"}, {"ABS[#1]", "0"},      {"ATAN[1]/2", "22.5"},
      {"SQRT [4]", "2"}};
  for (const auto& [text, value] : kCases) EXPECT_EQ(valueOf(text), value) << text;
}

// Row 36. fan-12-atan
TEST(FanucMacro, TheRangeOfArcFunctionsIsASetting) {
  const Settings kSigned{{"atan_range", 180}};
  struct Angle {
    const char *text, *turn, *both_signs;
  };
  for (const Angle& one : {Angle{"ATAN[-1]/[-1]", "225", "-135"}, Angle{"ATAN[-1,-1]", "225", "-135"},
                           Angle{"ATAN[1]/[-1]", "135", "135"}, Angle{"ATAN[-1]/[1]", "315", "-45"},
                           Angle{"ATAN[0]/[-1]", "180", "180"}, Angle{"ATAN[1,1]", "45", "45"},
                           Angle{"ASIN[-0.5]", "330", "-30"}, Angle{"ASIN[0.5]", "30", "30"},
                           Angle{"ASIN[-1]", "270", "-90"}, Angle{"ATAN[ 1 ] / [ 1 ]", "45", "45"}}) {
    EXPECT_EQ(valueOf(one.text), one.turn) << one.text;
    EXPECT_EQ(valueOf(one.text, kSigned), one.both_signs) << one.text;
  }
}

// fan-12-logic
TEST(FanucMacro, LogicIsOf32Bits) {
  const std::vector<std::pair<const char*, const char*>> kCases = {{"12 AND 10", "8"}, {"12 OR 10", "14"},
                                                                   {"12 XOR 10", "6"}, {"5.4 AND 7", "5"},
                                                                   {"4.6 AND 7", "5"}, {"-1 AND 255", "255"}};
  for (const auto& [text, value] : kCases) EXPECT_EQ(valueOf(text), value) << text;
}

// fan-12-vars fan-12-large fan-13-const fan-12-nullrules
TEST(FanucMacro, VariablesKeepTheirValues) {
  for (const char* number :
       {"#1", "#33", "#100", "#199", "#500", "#999", "#98000", "#98499", "#900000", "#907399"})
    EXPECT_EQ(macroMill(std::string("O1\n") + number + "=7.5\nG0 X" + number + "\nM30\n").motions(),
              (Lines{"R 7.5 0 0"}))
        << number;
  EXPECT_EQ(macroMill("O1\n#1=3\n#[#1+97]=8\nG0 X#100 Y#[99+1]\nM30\n").motions(), (Lines{"R 8 8 0"}));
  EXPECT_EQ(valueOf("#3101"), "3.1416");
  EXPECT_EQ(valueOf("#3102"), "2.7183");
  for (const char* number : {"#34", "#99", "#200", "#499", "#1200", "#9999", "#98500", "#800000"}) {
    EXPECT_EQ(valueOf(number), "fanuc-115") << number;
    EXPECT_EQ(macroMill(std::string("O1\n") + number + "=1\nM30\n").error(), "fanuc-115") << number;
  }
}

// Rows 32 and 33, section 12. fan-12-nullrules fan-12-cond
TEST(FanucMacro, NullIsZeroButForEqAndNe) {
  struct Condition {
    const char* text;
    bool holds;
  };
  for (const Condition& one : {Condition{"#1 EQ #0", true},
                               {"#1 EQ 0", false},
                               {"#1 NE #0", false},
                               {"#1 NE 0", true},
                               {"#1 GE 0", true},
                               {"#1 GT 0", false},
                               {"#1 LE 0", true},
                               {"#1 LT 0", false},
                               {"#1 LT 1", true},
                               {"#1 GT -1", true},
                               {"#1 EQ #2", true},
                               {"0 EQ #1", false},
                               {"1 EQ 1", true},
                               {"#1+0 EQ 0", true},
                               {"2 GT 1", true},
                               {"1 GE 1", true},
                               {"1 LT 1", false},
                               {"-1 LE -1", true},
                               {"[1 EQ 1] AND [2 EQ 2]", true},
                               {"[1 EQ 1] AND [2 EQ 3]", false},
                               {"[1 EQ 2] OR [2 EQ 2]", true},
                               {"[1 EQ 2] OR [2 EQ 3]", false},
                               {"[1 EQ 1] XOR [2 EQ 2]", false},
                               {"1 EQ 1 AND 2 EQ 2", true},
                               {"1 EQ 1 AND 2 EQ 3", false},
                               {"3 EQ 1 OR 2 EQ 2", true},
                               {"1 EQ 1 OR 1 EQ 2 AND 1 EQ 2", true},
                               {"6 AND 2 EQ 2", true},
                               {"2 EQ 6 AND 2", true},
                               {"[[1 EQ 1] AND [[2 EQ 3] OR [4 GT 3]]]", true},
                               {"#1 EQ #0 AND #2 EQ #0", true}}) {
    const IsoRun run = macroMill(std::string("O1\nIF[") + one.text + "]GOTO 5\nG0 X1\nN5 M30\n");
    EXPECT_EQ(run.error(), "") << one.text << run.message();
    EXPECT_EQ(run.motions().empty(), one.holds) << one.text;
  }
  const auto motions = [](const char* text) {
    return macroMill(std::string("O1\n") + text + "M30\n").motions();
  };
  EXPECT_EQ(motions("#2=#0\nG1 X5. Y#2 F100\n"), (Lines{"F 5 0 0"}));
  EXPECT_EQ(motions("#1=5.\n#2=#1\n#1=#0\nG0 X#2 Y#1\n"), (Lines{"R 5 0 0"}));
  EXPECT_EQ(motions("G0 X[#1+3]\nG0 X#1\n"), (Lines{"R 3 0 0"}));
  EXPECT_EQ(motions("#2=#1*5\nG0 Y2.\nG0 X1. Y#2\n"), (Lines{"R 0 2 0", "R 1 0 0"})) << "#2 is 0, not null";
  EXPECT_EQ(motions("G0 X1. Y-#1 Z-[#1]\n"), (Lines{"R 1 0 0"}));
  EXPECT_EQ(macroMill("O1\nIF[#1]GOTO5\nN5 M30\n").error(), "fanuc-114") << "a null condition";
  EXPECT_EQ(macroMill("O1\nIF[ABC]GOTO5\nN5 M30\n").error(), "fanuc-114");
}

// fan-12-IF fan-12-THEN
TEST(FanucMacro, IfHasAJumpOrOneStatement) {
  const auto motions = [](const char* text) {
    const IsoRun run = macroMill(std::string("O1\n") + text + "M30\n");
    EXPECT_EQ(run.error(), "") << text << run.message();
    return run.motions();
  };
  EXPECT_EQ(motions("IF[1 EQ 1]THEN #1=3\nG0 X#1\n"), (Lines{"R 3 0 0"}));
  EXPECT_EQ(motions("IF[1 EQ 2]THEN #1=3\nG0 X5 Y#1\n"), (Lines{"R 5 0 0"}));
  EXPECT_EQ(motions("IF [1 EQ 1] THEN #1 = 3 (YES)\nG0 X#1\n"), (Lines{"R 3 0 0"}));
  EXPECT_EQ(motions("IF [#2 NE #0] GOTO 10\nG0 X1\nN10\n"), (Lines{"R 1 0 0"}));
  EXPECT_EQ(motions("#2=0\nIF [#2 NE #0] GOTO 10\nG0 X1\nN10\n"), Lines());
  EXPECT_EQ(macroMill("O1\nIF[1 EQ 1]THEN #3000=7(BAD)\nM30\n").error(), "fanuc-3007");
  EXPECT_EQ(macroMill("O1\nIF[1 EQ 1]THEN G0 X5\nM30\n").error(), "fanuc-127");
  EXPECT_EQ(macroMill("O1\nIF[1 EQ 1] G0 X5\nM30\n", {{"flavour", 1}}).motions(), (Lines{"R 5 0 0"}));
}

// Row 35. fan-12-GOTO
TEST(FanucMacro, GotoLooksForwardFirst) {
  const auto motions = [](const char* text) { return macroMill(std::string("O1\n") + text).motions(); };
  EXPECT_EQ(motions("N5 G0 X1\nIF[#1 EQ 1]GOTO9\n#1=1\nGOTO 5\nG0 Y1\nN5 G0 X2\nN9 M30\n"),
            (Lines{"R 1 0 0", "R 2 0 0"}));
  EXPECT_EQ(motions("N5 G91 G0 X1\n#1=#1+1\nIF[#1 LT 3]GOTO 5\nM30\n").size(), 3u);
  EXPECT_EQ(motions("#1=7\nGOTO#1\nG0 X1\nN7 G0 Y1\nM30\n"), (Lines{"R 0 1 0"}));
  EXPECT_EQ(motions("#1=7\nGOTO[100+#1]\nG0 X1\nN107 G0 Y1\nM30\n"), (Lines{"R 0 1 0"}));
  EXPECT_EQ(motions("GOTO[6.6]\nG0 X1\nN7 G0 Y1\nM30\n"), (Lines{"R 0 1 0"}));
  for (const char* jump : {"GOTO 8", "GOTO 0", "GOTO[-7]", "GOTO#1"})
    EXPECT_EQ(macroMill(std::string("O1\n") + jump + "\nN7 M30\n").error(), "fanuc-128") << jump;
}

TEST(FanucMacro, GotoMayLeaveALoopButNotEnterOne) {
  EXPECT_EQ(
      macroMill("O1\n#1=0\nWHILE[#1 LT 9]DO1\n#1=#1+1\nG0 X#1\nIF[#1 EQ 2]GOTO5\nEND1\nN5 M30\n").motions(),
      (Lines{"R 1 0 0", "R 2 0 0"}));
  EXPECT_EQ(
      macroMill("O1\n#1=0\nWHILE[#1 LT 3]DO1\n#1=#1+1\nIF[#1 EQ 2]GOTO5\nG0 X#1\nN5 END1\nM30\n").motions(),
      (Lines{"R 1 0 0", "R 3 0 0"}));
  const char* const kInto = "O1\nGOTO 5\nDO1\nDO2\nEND2\nN5 G0 X1\nEND1\nM30\n";
  EXPECT_EQ(macroMill(kInto).error(), "fanuc-goto-into-loop");
  EXPECT_EQ(macroMill("O1\nDO1\nGOTO 5\nDO2\nN5 G0 X1\nEND2\nEND1\nM30\n").error(), "fanuc-goto-into-loop");
  EXPECT_EQ(
      macroMill("O1\n#1=#1+1\nIF[#1 GT 1]GOTO9\nDO1\nGOTO 6\nEND1\nN6 GOTO 5\nN5 G0 X1\nN9 M30\n").motions(),
      (Lines{"R 1 0 0"}));
}

// Row 34. fan-12-WHILE
TEST(FanucMacro, LoopsRunWhileTheirConditionHolds) {
  const auto motions = [](const char* text) {
    const IsoRun run = macroMill(std::string("O1\n") + text + "M30\n");
    EXPECT_EQ(run.error(), "") << text << run.message();
    return run.motions();
  };
  EXPECT_EQ(motions("#100=1\nWHILE[#100 LE 3]DO1\nG1 X#100 F100\n#100=#100+1\nEND1\n"),
            (Lines{"F 1 0 0", "F 2 0 0", "F 3 0 0"}));
  EXPECT_EQ(motions("WHILE[1 EQ 2]DO1\nG0 X1\nEND1\nG0 Y1\n"), (Lines{"R 0 1 0"}));
  EXPECT_EQ(
      motions(
          "#1=0\nWHILE [#1 LT 2] DO 2\n#2=0\nWHILE[#2 LT 2]DO1\nG91 G0 X1\n#2=#2+1\nEND1\n#1=#1+1\nEND 2\n")
          .size(),
      4u);
  EXPECT_EQ(motions("#1=0\nWHILE[#1 LT 2]DO1\n#1=#1+1\nEND1\nWHILE[#1 LT 4]DO1\n#1=#1+1\nEND1\nG0 X#1\n"),
            (Lines{"R 4 0 0"}));
  EXPECT_EQ(motions("DO1\n#1=#1+1\nIF[#1 EQ 5]GOTO5\nEND1\nN5 G0 X#1\n"), (Lines{"R 5 0 0"}));
  const std::vector<std::pair<const char*, const char*>> kFaults = {
      {"WHILE[1 EQ 1]DO4\nEND4\n", "fanuc-126"},
      {"DO1\nG0 X1\n", "fanuc-124"},
      {"G0 X1\nEND1\n", "fanuc-124"},
      {"DO1\nDO2\nEND1\nEND2\n", "fanuc-124"},
      {"DO1\nDO1\nEND1\nEND1\n", "fanuc-124"},
      {"WHILE[1 EQ 1]\nEND1\n", "fanuc-124"},
      {"WHILE[1 EQ 1]DO1 G0 X1\nEND1\n", "fanuc-127"},
  };
  for (const auto& [text, code] : kFaults)
    EXPECT_EQ(macroMill(std::string("O1\n") + text + "M30\n").error(), code) << text;
  IsoRun endless = macroMill("O1\nDO1\nG91 G0 X1\nEND1\nM30\n");
  EXPECT_NE(endless.error(), "") << "a loop without an end stops at a limit";
}

// fan-12-errors fan-13-protect fan-13-other
TEST(FanucMacro, ErrorsHaveTheNumbersOfTheControl) {
  const std::vector<std::pair<const char*, const char*>> kCases = {
      {"#1=1/0", "fanuc-112"},
      {"#1=1/#2", "fanuc-112"},
      {"#1=5 MOD 0", "fanuc-112"},
      {"#1=SQRT[-1]", "fanuc-119"},
      {"#1=LN[0]", "fanuc-119"},
      {"#1=LN[-1]", "fanuc-119"},
      {"#1=ASIN[1.1]", "fanuc-119"},
      {"#1=ACOS[-2]", "fanuc-119"},
      {"#1=POW[-2,0.5]", "fanuc-119"},
      {"#1=BIN[26]", "fanuc-119"},
      {"#1=EXP[1000]", "fanuc-111"},
      {"#1=POW[10,400]", "fanuc-111"},
      {"#1=##2", "fanuc-114"},
      {"#1=SIN", "fanuc-114"},
      {"#1=SIN30", "fanuc-114"},
      {"#1=", "fanuc-114"},
      {"#1=2+", "fanuc-114"},
      {"#1=ABC[2]", "fanuc-114"},
      {"#1=[2+3", "fanuc-125"},
      {"IF[1 EQ 1 GOTO 5", "fanuc-114"},
      {"IF[1=1]GOTO 5", "fanuc-114"},
      {"IF 1 EQ 1 GOTO 5", "fanuc-114"},
      {"#1=[[[[[[[[[[[[[[[[[[[[[1]]]]]]]]]]]]]]]]]]]]]", "fanuc-118"},
      {"#-1=3", "fanuc-114"},
      {"#5001=1", "fanuc-116"},
      {"#4001=1", "fanuc-116"},
      {"#1000=1", "fanuc-116"},
      {"#0=1", "fanuc-116"},
      {"#3101=1", "fanuc-116"},
      {"#1=#7777", "fanuc-115"},
      {"#7777=1", "fanuc-115"},
      {"#1=1 G0 X1", "fanuc-127"},
      {"G0 X1 #1=2", "fanuc-127"},
      {"G0 X1 GOTO 5", "fanuc-127"},
      {"#1=1 #2=2", "fanuc-127"}};
  for (const auto& [text, code] : kCases) {
    const IsoRun run = macroMill(std::string("O1\n") + text + "\nM30\n");
    EXPECT_EQ(run.error(), code) << text << ": " << run.message();
  }
  EXPECT_NE(macroMill("O1\n#1=#7777\nM30\n").message().find("7777"), std::string::npos);
  const IsoRun null = macroMill("O1\n#1=#7777\n#7778=1\nG0 X1 Y#1\nM30\n", {{"unknown_variables", 1}});
  EXPECT_EQ(null.motions(), (Lines{"R 1 0 0"}));
  EXPECT_TRUE(null.tells("fanuc-unknown-variable"));
  EXPECT_EQ(macroMill("O1\n#461=3\nG0 X#461\nM30\n", {{"unknown_variables", 1}}).motions(),
            (Lines{"R 3 0 0"}));
}

// Row 37. fan-12-alarm
TEST(FanucMacro, AProgramRaisesItsAlarm) {
  const IsoRun run = macroMill("O1\nG0 X1\n#3000=5(NO PART)\nG0 X2\nM30\n");
  EXPECT_EQ(run.error(), "fanuc-3005");
  EXPECT_EQ(run.message(), "NO PART");
  EXPECT_EQ(run.motions(), (Lines{"R 1 0 0"}));
  EXPECT_FALSE(run.summary.ok());
  EXPECT_EQ(macroMill("O1\n#3000=[60+7] (X)\nM30\n").error(), "fanuc-3067");
  EXPECT_EQ(macroMill("O1\n#3000=5(NO PART)\nM30\n", {{"flavour", 1}}).error(), "fanuc-1005");
}

// fan-12-3006
TEST(FanucMacro, AProgramStopsWithAText) {
  const IsoRun run = macroMill("O1\n#3006=1(TURN PART)\nG0 X2\nM30\n");
  EXPECT_EQ(run.error(), "");
  EXPECT_EQ(run.motions(), (Lines{"R 2 0 0"}));
  bool told = false;
  for (const auto& [at, e] : run.path.events) {
    const auto* message = e.as<event::Message>();
    told = told || (message != nullptr && message->text == "TURN PART" && message->number == 1);
  }
  EXPECT_TRUE(told);
}

// Row 63. fan-12-out
TEST(FanucMacro, DprntWritesColumns) {
  const auto written = [](const std::string& text, const Settings& settings = {}) {
    MemoryProgramSource source("main.nc", "O1\n#100=12.3456\n#101=-1\n" + text + "M30\n");
    Toolpath path;
    ToolpathBuilder sink(path);
    MemoryOutput output;
    ControlHost host;
    host.output = &output;
    EXPECT_TRUE(interpret(ControlId::kFanucMill, source, runAtZero(settings), sink, nullptr, host).ok())
        << text;
    return output.files().contains("macro.txt") ? output.files().at("macro.txt") : "";
  };
  EXPECT_EQ(written("POPEN\nDPRNT[X#100[43]*Y#101[33]]\nPCLOS\n"), "X   12.346 Y-  1.000\r\n");
  EXPECT_EQ(written("DPRNT[X#100[43]]\n"), "X   12.346\r\n");
  EXPECT_EQ(written("POPEN\nDPRNT[#100[20]/#101[2]]\nDPRNT[A]\nPCLOS\n"), " 12/- 1\r\nA\r\n");
  EXPECT_EQ(written("POPEN\nDPRNT[#1[32]]\nPCLOS\nPOPEN\nDPRNT[END]\nPCLOS\n"), "   0.00\r\nEND\r\n");
  EXPECT_EQ(written("POPEN\nDPRNT[X#100[43]Y#101[33]]\nPCLOS\n", {{"dprnt_compact", 1}}),
            "X12.346Y-1.000\r\n");
}

// fan-12-SETVN fan-12-named
TEST(FanucMacro, VariablesHaveNames) {
  EXPECT_EQ(macroMill("O1\nSETVN 510[TOOL_NO, WORK_NO]\n#[TOOL_NO]=4\n#511=5\nG0 X#510 Y#[WORK_NO]\nM30\n")
                .motions(),
            (Lines{"R 4 5 0"}));
  EXPECT_EQ(macroMill("O1\nG0 X3. Y4.\nG0 X[#[_ABSIO[2]]] Y[#_ABSIO[1]]\nM30\n").motions(),
            (Lines{"R 3 4 0", "R 4 3 0"}));
  EXPECT_EQ(macroMill("O1\n#1=#[_NOTHING]\nM30\n").error(), "fanuc-115");
  EXPECT_EQ(macroMill("O1\nSETVN [A]\nM30\n").error(), "fanuc-114");
}

// fan-12-lookahead
TEST(FanucMacro, StatementsActInTheOrderOfTheProgram) {
  EXPECT_EQ(macroMill("O1\nG0 X5.\n#1=#5001\n#2=#5021\nG0 X6.\nG0 Y#1 Z#2\nM30\n").motions(),
            (Lines{"R 5 0 0", "R 6 0 0", "R 6 5 5"}));
}

TEST(FanucMacro, RoundGoesToTheIncrementInWords) {
  EXPECT_EQ(macroMill("O1\n#1=1.23456\nG0 X[ROUND[#1]]\nM30\n").motions(), (Lines{"R 1.235 0 0"}));
  EXPECT_EQ(macroMill("O1\n#1=ROUND[1.23456]\nG0 X#1\nM30\n").motions(), (Lines{"R 1 0 0"}));
  EXPECT_EQ(macroMill("O1\nIF[ROUND[1.4] EQ 1]GOTO5\nG0 X1\nN5 M30\n").motions(), Lines());
  EXPECT_EQ(macroMill("O1\nM98 P[ROUND[11.6]]\nM30\nO12\nG0 X1\nM99\n").motions(), (Lines{"R 1 0 0"}));
}

}  // namespace
}  // namespace proveout::test
