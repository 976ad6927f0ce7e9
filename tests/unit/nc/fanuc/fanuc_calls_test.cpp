// Subprograms, macros and what settings turn into calls.
#include <gtest/gtest.h>

#include "tests/unit/nc/iso_run.h"

namespace proveout::test {
namespace {

using Lines = std::vector<std::string>;
using Settings = std::map<std::string, double>;
using Files = std::map<std::string, std::string>;

/// Rapids go straight, so that a block is one motion.
IsoRun callsMill(const std::string& text, Settings settings = {}, const Files& files = {}) {
  settings.try_emplace("rapid", 1);
  return {ControlId::kFanucMill, text, runAtZero(settings), files};
}

struct CallCase {
  const char* program;
  Lines motions;
  Settings settings = {};
};

void expectCallMotions(const std::vector<CallCase>& cases, const Files& files = {}) {
  for (const CallCase& one : cases) {
    const IsoRun run = callsMill(one.program, one.settings, files);
    EXPECT_EQ(run.error(), "") << one.program << "\n" << run.message();
    EXPECT_EQ(run.motions(), one.motions) << one.program;
  }
}

// Row 30. fan-11-M98
TEST(FanucCalls, SubprogramsAreCalledWithRepetitions) {
  const char* const kSub = "M30\nO12\nG91 G0 X1\nM99\n";
  const auto with = [&](const char* call) { return std::string("O1\n") + call + "\n" + kSub; };
  expectCallMotions({
      {with("M98 P30012").c_str(), {"R 1 0 0", "R 2 0 0", "R 3 0 0"}},
  });
  for (const auto& [call, times] : std::map<std::string, std::size_t>{{"M98 P12", 1},
                                                                      {"M98 P0012", 1},
                                                                      {"M98 P012 L4", 4},
                                                                      {"M98 P20012", 2},
                                                                      {"M98 P0020012", 2},
                                                                      {"M98 P12 L0", 0},
                                                                      {"M98 P30012 (THREE)", 3}}) {
    const IsoRun run = callsMill(with(call.c_str()));
    EXPECT_EQ(run.error(), "") << call << run.message();
    EXPECT_EQ(run.motions().size(), times) << call;
  }
  EXPECT_TRUE(callsMill(with("M98 P12 L0")).tells("fanuc-call-none"));
}

TEST(FanucCalls, WithTheLFormAllDigitsAreTheNumber) {
  const std::string program = "O1\nG91 M98 P30012\nM30\nO12\nG0 X1\nM99\nO30012\nG0 X2\nM99\n";
  EXPECT_EQ(callsMill(program).motions().size(), 3u) << "O12 three times";
  const auto notesForm = [&](const Settings& settings) {
    int notes = 0;
    for (const Diagnostic& d : callsMill(program, settings).path.diagnostics.all())
      notes += d.message.find("subprogram_form") != std::string::npos;
    return notes;
  };
  EXPECT_EQ(notesForm({}), 1);
  EXPECT_EQ(notesForm({{"subprogram_form", 0}}), 0);
  EXPECT_EQ(callsMill(program, {{"subprogram_form", 1}}).motions(), (Lines{"R 2 0 0"}));
  // A long number that is there alone under that name.
  const IsoRun alone = callsMill("O1\nM98 P30012\nM30\nO30012\nG0 X2\nM99\n");
  EXPECT_EQ(alone.motions(), (Lines{"R 2 0 0"}));
  EXPECT_TRUE(alone.tells("fanuc-long-number"));
  EXPECT_EQ(callsMill("O1\nM98 P12345678 L2\nM30\nO12345678\nG91 G0 X2\nM99\n").motions(),
            (Lines{"R 2 0 0", "R 4 0 0"}));
}

// fan-11-M98Q fan-11-M98name
TEST(FanucCalls, CallsMayBeginAtABlockAndGoByName) {
  const char* const kSub = "M30\nO12\nG0 X1\nN20 G0 X2\nM99\n";
  EXPECT_EQ(callsMill(std::string("O1\nM98 P12 Q20\n") + kSub).motions(), (Lines{"R 2 0 0"}));
  EXPECT_EQ(callsMill(std::string("O1\nG91 M98 P12 Q20 L2\n") + kSub).motions(),
            (Lines{"R 2 0 0", "R 4 0 0"}));
  EXPECT_EQ(callsMill(std::string("O1\nM98 P12 Q30\n") + kSub).error(), "fanuc-078");
  EXPECT_EQ(callsMill("O1\nM98 <HOLES>\nM30\nO<HOLES>\nG0 X3\nM99\n").motions(), (Lines{"R 3 0 0"}));
  EXPECT_EQ(callsMill("O1\nM98 <HOLES>\nM30\n<HOLES>\nG0 X3\nM99\n").motions(), (Lines{"R 3 0 0"}));
  EXPECT_EQ(callsMill("O1\nM98 <NONE>\nM30\n<HOLES>\nG0 X3\nM99\n").error(), "fanuc-076");
}

// fan-11-M99 fan-11-M99P fan-11-M30 fan-11-M02
TEST(FanucCalls, ReturnsGoBackOrToABlock) {
  expectCallMotions({
      {"O1\nM98 P2\nG0 X1\nN9 G0 X2\nM30\nO2\nG0 Y1\nM99\n", {"R 0 1 0", "R 1 1 0", "R 2 1 0"}},
      {"O1\nM98 P2\nG0 X1\nN9 G0 X2\nM30\nO2\nG0 Y1\nM99 P9\n", {"R 0 1 0", "R 2 1 0"}},
      {"O1\nG91 M98 P2\nM30\nO2\nG0 Y1\n#500=#500+1\nIF[#500 EQ 2]GOTO5\nM99 L4\nN5 M99 L0\n",
       {"R 0 1 0", "R 0 2 0"}},
      {"O1\nM98 P2\nG0 X1\nM30\nO2\nG0 Y1\nM30\n", {"R 0 1 0"}},
      {"O1\nM98 P2\nG0 X1\nM30\nO2\nG0 Y1\nM2\n", {"R 0 1 0"}},
      {"O1\nM98 P2\nG0 X1\nM30\nO2\nG0 Y1\nG80 M99\n", {"R 0 1 0", "R 1 1 0"}},
  });
  EXPECT_EQ(callsMill("O1\nM98 P2\nM30\nO2\nM99 P7\n").error(), "fanuc-078");
}

// fan-11-M99main
TEST(FanucCalls, AMainProgramThatReturnsEndsWithANote) {
  const IsoRun once = callsMill("O1\nG91 G0 X1\nM99\n");
  EXPECT_EQ(once.motions(), (Lines{"R 1 0 0"}));
  EXPECT_TRUE(once.tells("fanuc-main-m99"));
  EXPECT_EQ(callsMill("O1\nG91 G0 X1\nM99\n", {{"repeat_main", 3}}).motions(),
            (Lines{"R 1 0 0", "R 2 0 0", "R 3 0 0"}));
  EXPECT_EQ(callsMill("O1\nN1 G91 G0 X1\n#500=#500+1\nIF[#500 EQ 3]GOTO9\nM99 P1\nN9 M30\n").motions().size(),
            3u);
}

// fan-11-search
TEST(FanucCalls, ProgramsAreLookedForInTheFileAndThenInTheFolders) {
  const std::string call = "O1\nM98 P12\nM30\n";
  for (const char* name :
       {"O0012", "O0012.NC", "o0012.tap", "O00000012.eia", "0012.nc", "12.nc", "12", "O12.min"})
    EXPECT_EQ(callsMill(call, {}, {{name, "G0 X4\nM99\n"}}).motions(), (Lines{"R 4 0 0"})) << name;
  EXPECT_EQ(callsMill(call + "O12\nG0 X5\nM99\n", {}, {{"O0012.nc", "G0 X4\nM99\n"}}).motions(),
            (Lines{"R 5 0 0"}));
  const IsoRun none = callsMill(call);
  EXPECT_EQ(none.error(), "fanuc-076");
  for (const char* name : {"O0012", "O00000012", "0012", "12", ".nc", ".tap", ".eia", ".txt", ".min", ".cnc"})
    EXPECT_NE(none.message().find(name), std::string::npos) << name << ": " << none.message();
  EXPECT_EQ(callsMill("O1\nM98\nM30\n").error(), "fanuc-076");
  // A subprogram may stand in front of the end of a file that it is not the first of, and be called from
  // there.
  EXPECT_EQ(callsMill("O1\nM98 P2\nM30\nO2\nM98 P3\nM99\nO3\nG0 X1\nM99\n").motions(), (Lines{"R 1 0 0"}));
}

// fan-11-M198
TEST(FanucCalls, ExternalCallsLookIntoTheFoldersFirst) {
  const std::string program = "O1\nM198 P12\nM30\nO12\nG0 X5\nM99\n";
  EXPECT_EQ(callsMill(program, {}, {{"O0012.nc", "G0 X4\nM99\n"}}).motions(), (Lines{"R 4 0 0"}));
  EXPECT_EQ(callsMill(program).motions(), (Lines{"R 5 0 0"}));
}

// fan-11-nest
TEST(FanucCalls, NestingHasItsLimits) {
  const auto chain = [](int depth, const char* call) {
    std::string text = "O1\n" + std::string(call) + "2\nM30\n";
    for (int k = 2; k <= depth + 1; ++k) {
      text += "O" + std::to_string(k) + "\nG91 G0 X1\n";
      if (k <= depth) text += call + std::to_string(k + 1) + "\n";
      text += "M99\n";
    }
    return text;
  };
  EXPECT_EQ(callsMill(chain(10, "M98 P")).error(), "");
  EXPECT_EQ(callsMill(chain(10, "M98 P")).motions().size(), 10u);
  EXPECT_EQ(callsMill(chain(11, "M98 P")).error(), "fanuc-077");
  EXPECT_EQ(callsMill(chain(4, "M98 P"), {{"sub_nesting", 4}}).error(), "");
  EXPECT_EQ(callsMill(chain(5, "M98 P"), {{"sub_nesting", 4}}).error(), "fanuc-077");
  EXPECT_EQ(callsMill(chain(4, "G65 P")).error(), "");
  EXPECT_EQ(callsMill(chain(5, "G65 P")).error(), "fanuc-077");
}

// Row 31. fan-12-args1 fan-12-args2
TEST(FanucCalls, ArgumentsGoToTheirVariables) {
  const auto first = [](const std::string& words, const std::string& reads) {
    return callsMill("O1\nG65 P2 " + words + "\nM30\nO2\nG0 " + reads + "\nM99\n").motions();
  };
  EXPECT_EQ(first("A1. B2. I-3. I4. D5.", "X#1 Y#2 Z#4"), (Lines{"R 1 2 -3"}));
  EXPECT_EQ(first("A1. B2. I-3. I4. D5.", "X#7"), (Lines{"R 5 0 0"}));
  EXPECT_EQ(first("D5. I-3. I4.", "X#7"), (Lines{"R 4 0 0"})) << "the later one holds";
  struct Letter {
    char letter;
    int variable;
  };
  for (const Letter& one :
       {Letter{'A', 1}, {'B', 2},  {'C', 3},  {'D', 7},  {'E', 8},  {'F', 9},  {'H', 11},
        {'I', 4},       {'J', 5},  {'K', 6},  {'M', 13}, {'Q', 17}, {'R', 18}, {'S', 19},
        {'T', 20},      {'U', 21}, {'V', 22}, {'W', 23}, {'X', 24}, {'Y', 25}, {'Z', 26}}) {
    EXPECT_EQ(first(std::string(1, one.letter) + "7", "X#" + std::to_string(one.variable)),
              (Lines{"R 7 0 0"}))
        << one.letter;
  }
  EXPECT_EQ(first("I1 J2 K3", "X#4 Y#5 Z#6"), (Lines{"R 1 2 3"}));
  EXPECT_EQ(first("I1 J2 K3 I4 J5 K6", "X#7 Y#8 Z#9"), (Lines{"R 4 5 6"}));
  EXPECT_EQ(first("I1I2I3I4I5I6I7I8I9I10", "X#31"), (Lines{"R 10 0 0"}));
  EXPECT_EQ(first("I1J1K1I2J2K2I3J3K3I4J4K4I5J5K5I6J6K6I7J7K7I8J8K8I9J9K9I10J11K12", "X#31 Y#32 Z#33"),
            (Lines{"R 10 11 12"}));
  EXPECT_EQ(first("A-1.5 B[2+3] C-[1]", "X#1 Y#2 Z#3"), (Lines{"R -1.5 5 -1"}));
  EXPECT_EQ(first("A1", "X[#2+1] Y#2"), (Lines{"R 1 0 0"})) << "those that are not there are null";
}

// fan-12-argdecimal
TEST(FanucCalls, ArgumentsWithoutAPointCountAsTheirAddressDoes) {
  const std::string program =
      "O1\nG65 P2 X10 A10. H3 D4 R2000\nM30\nO2\nG0 X[#24+0] Y[#1+0] Z[#11+#7+#18]\nM99\n";
  EXPECT_EQ(callsMill(program).motions(), (Lines{"R 10 10 2007"}));
  EXPECT_EQ(callsMill(program, {{"decimal", 1}}).motions(), (Lines{"R 0.01 10 9"}));
}

// fan-12-argerr
TEST(FanucCalls, SomeAddressesAreNoArguments) {
  for (const char* words : {"G65 P2 G1", "G91 G65 P2", "G65 P2 A1 N5", "G65 P2 I1I1I1I1I1I1I1I1I1I1I1"})
    EXPECT_EQ(callsMill(std::string("O1\n") + words + "\nM30\nO2\nM99\n").error(), "fanuc-129") << words;
}

// fan-12-G65
TEST(FanucCalls, AMacroHasLocalsOfItsOwn) {
  expectCallMotions({
      {"O1\n#1=5\nG65 P2 A1\nG0 X#1\nM30\nO2\n#1=#1+1\nG0 Y#1\nM99\n", {"R 0 2 0", "R 5 2 0"}},
      {"O1\n#1=5\nM98 P2\nG0 X#1\nM30\nO2\n#1=#1+1\nM99\n", {"R 6 0 0"}},
      {"O1\nG65 P2 L3 A1\nM30\nO2\nG91 G0 X#1\n#1=9\nM99\n", {"R 1 0 0", "R 2 0 0", "R 3 0 0"}},
      {"O1\nG65 P2 A1\nM30\nO2\nG65 P3 A[#1+1]\nG0 X#1\nM99\nO3\nG0 Y#1\nM99\n", {"R 0 2 0", "R 1 2 0"}},
  });
}

// Worked example of section 12.
TEST(FanucCalls, TheBoltCircleOfTheSpecification) {
  const IsoRun run = callsMill(
      "O1\nG90 G0 Z10.\nG65 P9100 X10. Y0 Z-5. R2. I40. A0 H6\nM30\n"
      "O9100\n#2=0\nWHILE[#2 LT #11]DO1\n#3=#1+#2*360/#11\n"
      "G81 X[#24+#4*COS[#3]] Y[#25+#4*SIN[#3]] Z#26 R#18 F100\n#2=#2+1\nEND1\nG80 M99\n");
  EXPECT_EQ(run.error(), "") << run.message();
  Lines bottoms;
  for (const std::string& line : run.motions()) {
    if (line.starts_with("F")) bottoms.push_back(line);
  }
  EXPECT_EQ(bottoms, (Lines{"F 50 0 -5", "F 30 34.641 -5", "F -10 34.641 -5", "F -30 0 -5",
                            "F -10 -34.641 -5", "F 30 -34.641 -5"}));
}

// Row 61. fan-12-G66 fan-12-G67
TEST(FanucCalls, ModalMacrosRunBehindMotions) {
  const char* const kMacro = "M30\nO7\nG91 G0 Z-#1\nZ#1\nG90\nM99\n";
  const auto with = [&](const std::string& text) { return callsMill("O1\n" + text + kMacro).motions(); };
  EXPECT_EQ(with("G66 P7 A5.\nG0 X10\nX20\nG67\nX30\n"),
            (Lines{"R 10 0 0", "R 10 0 -5", "R 10 0 0", "R 20 0 0", "R 20 0 -5", "R 20 0 0", "R 30 0 0"}));
  EXPECT_EQ(with("G66 P7 A5.\n#500=1\nM8\nG67\nG0 X30\n"), (Lines{"R 30 0 0"})) << "no motion, no call";
  EXPECT_EQ(with("G66 P7 A5. L2\nG0 X10\nG67\n").size(), 5u);
}

// fan-12-G66.1
TEST(FanucCalls, OfModalMacrosOfBlocksEachBlockIsArguments) {
  const IsoRun run = callsMill(
      "O1\nG66.1 P7 A1.\nN5 G1 X3. A2.\nA4.\nG67\nG0 Z9\nM30\nO7\nG0 X#1 Y#24\nG0 Z#10\n#500=#14\nM99\n");
  EXPECT_EQ(run.error(), "") << run.message();
  EXPECT_EQ(run.motions(), (Lines{"R 1 0 0", "R 2 3 0", "R 2 3 1", "R 4 3 1", "R 4 3 9"}));
}

// fan-12-callG fan-12-callM fan-12-callT
TEST(FanucCalls, SettingsTurnCodesIntoCalls) {
  expectCallMotions({
      {"O1\nG100 X5. Y6.\nM30\nO9010\nG0 X#24 Y#25\nM99\n", {"R 5 6 0"}, {{"macro_call_g.O9010", 100}}},
      {"O1\nG81.5 A5. L2\nM30\nO9011\nG91 G0 X#1\nM99\n",
       {"R 5 0 0", "R 10 0 0"},
       {{"macro_call_g.O9011", 81.5}}},
      {"O1\nM50 A3.\nM30\nO9020\nG0 X#1\nM99\n", {"R 3 0 0"}, {{"macro_call_m.O9020", 50}}},
      {"O1\n#1=4\nM6\nM30\nO9001\nM6\nG0 X#1\nM99\n", {"R 4 0 0"}, {{"sub_call_m.O9001", 6}}},
      {"O1\nT12\nM30\nO9000\nG0 X#149\nM99\n", {"R 12 0 0"}, {{"sub_call_t", 1}}},
      {"O1\nS800\nM30\nO9029\nG0 X#147\nM99\n", {"R 800 0 0"}, {{"sub_call_s", 1}}},
      {"O1\nB45.\nM30\nO9028\nG0 X#146\nM99\n", {"R 45 0 0"}, {{"sub_call_b", 1}}},
      // Inside, the code itself is plain.
      {"O1\nG1 X5. F100\nM30\nO9010\nG1 X[#24*2] F100\nM99\n", {"F 10 0 0"}, {{"macro_call_g.O9010", 1}}},
  });
}

}  // namespace
}  // namespace proveout::test
