// What single signs tell, what is refused, and how it is said.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/nc/guess/candidates.h"
#include "core/nc/guess/control_guess.h"
#include "core/nc/guess/program_signs.h"
#include "core/nc/guess/sign_line.h"
#include "core/nc/guess/sign_table.h"

namespace proveout::test {
namespace {

std::string guessed(const std::string& text, const std::string& name = "a.nc") {
  const GuessedControl guess = guessControl(name, text);
  return guess.chosen ? guess.chosen->name() : "refused";
}

TEST(ControlGuess, NamesWhatShowsItself) {
  const std::pair<const char*, const char*> kPrograms[] = {
      {"%\nO0001 (PART)\nG90 G54 G0 X10. Y5.\nG43 Z10. H1\nG1 Z-1. F100.\nX50.\nG28 G91 Z0.\nM30\n%\n",
       "fanuc-mill"},
      {"%\nO00001\nG53 G0 Z0.\nT1 M6\nG187 P3\nG0 G54 X1. Y2.\nG43 Z10. H01\nM97 P100\nM30\n",
       "fanuc-mill (flavour haas)"},
      {"%\nO1\nG50 S2000\nT0101\nG96 S150 M3\nG0 X50. Z2.\nG71 U2. R1.\nG71 P10 Q20 U0.4 W0.1 F0.2\n",
       "fanuc-lathe"},
      {"%\nO1\nT101\nG50 S2000\nG96 S150 M3\nG0 X50. Z2.\nG71 P10 Q20 U0.4 W0.1 D2. F0.2\nG28\n",
       "fanuc-lathe (flavour haas)"},
      {"o<s> sub\ng1 x#1\no<s> endsub\no<s> call [1]\nm2\n", "linuxcnc"},
      {"G21 G90 G64 P0.01\n#<d> = 4\nG1 X#<d>\nM2\n", "linuxcnc"},
      {"$H\nG21\nG90\nG0 X1 Y1\nM3 S1000\nG1 X5 F100\nM5\n", "linuxcnc (flavour grbl)"},
      {"(for Mach3)\nG21 G90 G91.1\nT1 M6\nG0 X1. Y1.\nG1 X5. F100\nM30\n", "linuxcnc (flavour mach3)"},
      {"%PLATE\n$ a comment\nG54 G17\nG0 X1 Y1\nG1 X5 Y6 F100\nM2\n%\n", "wl4-mill"},
      {"%SHAFT\n$ a comment\nG54 G95\nG96 S100 M3\nG77 G41 G0 X12 Z2 P200 Q209 R0.3 E2 F0.3\nM2\n%\n",
       "wl4-lathe"},
      {"// Shaft\nT1M06D11\nS900M03\nG00X(26/2)Z4\nP1100=20\nG77X20A17Y1.5Z0P2C2B2V0\nM02\n", "flexnc"},
      {"H001=110;\nT84 T86;\nC001;\nG92 X0 Y0;\nG42 H001 G01 X-10.;\nM02;\n", "wedm"},
      {"%\nO8801 (PROG)\nN1 G00 G17 G21 G40 G49 G80 G90\nN2 T12 M06\nN3 G00 G90 G54 X25.4 Y-12.7 S4500 "
       "M03\nN4 G43 H12 "
       "Z25. M08\nN5 G81 G98 Z-3.2 R2. F220.\nN6 X50.\nN7 G80\nN9 G91 G28 Z0. M05\nN11 M30\n%\n",
       "fanuc-mill"},
      {"O1000\nN010 G40 G18 G80\nN020 G50 S2500\nN030 T0202 M42\nN040 G96 S180 M03\nN050 G00 X60. Z5. "
       "M08\nN090 G71 "
       "U1.5 R0.5\nN100 G71 P110 Q150 U0.3 W0.1 F0.2\nN110 G42 G00 X20.\nN120 G01 Z-15. F0.1\nN150 G40 "
       "X60.\nM30\n",
       "fanuc-lathe"},
      {":1234\nG0 G90 G80 G40 G17\nT3 M6\nG0 G54 X1. Y1. S3000 M3\nG43 Z1. H3\nG83 X1. Y1. Z-1. R.1 Q.1 "
       "F5.\nX2.\nG80\n"
       "G91 G28 Z0\nM30\n",
       "fanuc-mill"},
      {"(File created by SheetCam for Mach3)\nG21 G40 G90\nM06 T1\nG00 Z10.0000\nX10.0000 Y20.0000\nG01 "
       "Z-3.0 F100.0\nM30\n",
       "linuxcnc (flavour mach3)"},
      {"%\nO1\n(N1416.TOL=1)\nG0 XI10\nG2 X5 I5 L3\nG0 X0\n#1=FUP[2.1]\nG65 P9999 X20\nM30\n", "nct"},
  };
  for (const auto& [text, control] : kPrograms) {
    EXPECT_EQ(guessed(text), control) << text << guessControl("a.nc", text).refusalText();
  }
}

TEST(ControlGuess, RefusesWhatManyRead) {
  for (const char* text :
       {"", "\n\n", "G0 X1 Y2\nM30\n", "%\n%\n", "(NOTHING)\n", "G21 G90\nG0 X1 Y1\nG1 Z-1 F100\nX5\nM30\n",
        "O0001\nG90 G54\nG0 X10 Y10\nG1 Z-1 F100\nX30\nM30\n", "\x01\x02\x03\xFF\xFE"}) {
    EXPECT_EQ(guessed(text), "refused") << text;
  }
}

TEST(ControlGuess, SaysTheTwoBestAndWhatToDo) {
  const std::string text =
      guessControl("a.nc", "%\nO0001\nG90 G54\nG0 X10 Y10\nG43 H1 Z5\nG1 Z-1 F100\nX30\nM30\n").refusalText();
  EXPECT_NE(text.find("It may be nct: length offset with H (line 5: G43 H1 Z5)"), std::string::npos) << text;
  EXPECT_NE(text.find("Or fanuc-mill"), std::string::npos) << text;
  EXPECT_NE(text.find("but coordinates without a point (line 4: G0 X10 Y10)"), std::string::npos) << text;
  EXPECT_NE(text.find("--control NAME"), std::string::npos) << text;
  EXPECT_NE(guessControl("a.nc", "G0 X1\n").refusalText().find("nothing in the program tells"),
            std::string::npos);
}

TEST(ControlGuess, KnowsLanguagesOfOtherControls) {
  const auto refusal = [](const char* text) { return guessControl("", text).refusalText(); };
  EXPECT_NE(refusal("0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S1000\n2 L X+10 R0 FMAX\n").find("Heidenhain"),
            std::string::npos);
  EXPECT_NE(refusal("N10 WORKPIECE(,,,\"BOX\",0)\nCYCLE83(1,2,3)\n").find("Sinumerik"), std::string::npos);
  std::string print = "M104 S200\nM140 S60\nG28\n";
  for (int k = 0; k < 40; ++k)
    print += "G1 X" + std::to_string(k) + ".5 Y2.5 E0.0" + std::to_string(k + 10) + "\n";
  EXPECT_NE(refusal(print.c_str()).find("3-D printer"), std::string::npos) << refusal(print.c_str());
}

TEST(ControlGuess, HoldsOnBadText) {
  std::string deep(100'000, '(');
  EXPECT_EQ(guessed(deep), "refused");
  std::string letters(100'000, 'G');
  EXPECT_EQ(guessed(letters), "refused");
  EXPECT_EQ(guessed("G99999999999999999999999999999 X1e999 #\n[[[[\n,,,\nN\nO\nO<\n:\n;\n$\n//\n%%%\n#<\n"),
            "refused");
  std::string many;
  for (int k = 0; k < 300'000; ++k) many += "X1\r";
  EXPECT_EQ(guessed(many), "refused");
}

TEST(ControlGuess, TellsCommentsFromFormulas) {
  using nc::guess::SignLine;
  EXPECT_EQ(SignLine("N10 G0 X10.(to the start)Y5 ; end").comment, "TO THE START  END");
  EXPECT_EQ(SignLine("G00X(26/2)Z4").code, "G00X(26/2)Z4");
  EXPECT_EQ(SignLine("#1=(#1+3) IF(#1<=6) N10").code, "#1=(#1+3)IF(#1<=6)N10");
  EXPECT_EQ(SignLine("T1 M6 (FLAT 10)").code, "T1M6");
  EXPECT_EQ(SignLine("g1 x1 ;go").comment, "GO");
  EXPECT_EQ(SignLine("T84 T86;C001;").code, "T84T86C001");
  const SignLine line("g1 x-.5 y[#1+2] z#3 ,r5");
  ASSERT_EQ(line.words.size(), 5u);
  EXPECT_EQ(line.words[1].number(), -0.5);
  EXPECT_EQ(line.words[2].value, "[#1+2]");
  EXPECT_TRUE(line.words[4].comma);
}

/// Every code that a control's tables have is a code of its candidates.
TEST(ControlGuess, TheListsOfCodesHaveThoseOfTheTables) {
  std::map<ControlId, nc::guess::Candidates> of;
  for (const auto& candidate : nc::guess::candidates())
    of[candidate.control] = static_cast<nc::guess::Candidates>(of[candidate.control] | candidate.bit);
  for (const ControlInfo& info : controls()) {
    ASSERT_TRUE(of.contains(info.id)) << info.name << " is no candidate";
    for (const CoverageRow& row : coverageTable(info.id).value()) {
      if (row.code.size() < 2 || row.code[0] != 'G' ||
          row.code.find_first_not_of("G0123456789.") != std::string::npos)
        continue;
      const int tenths = static_cast<int>(std::lround(10 * std::stod(row.code.substr(1))));
      bool known = false;
      for (const auto& candidate : nc::guess::candidates())
        known = known || (candidate.control == info.id && nc::guess::hasCode(candidate.codes, tenths));
      EXPECT_TRUE(known) << info.name << " has " << row.code;
    }
  }
}

TEST(ControlGuess, EverySignHasARow) {
  std::set<nc::guess::Sign> rows;
  for (const auto& row : nc::guess::signRows()) {
    rows.insert(row.sign);
    EXPECT_EQ(row.speaks_for & row.speaks_against, 0) << row.says;
  }
  EXPECT_EQ(rows.size(), static_cast<std::size_t>(nc::guess::Sign::kCount));
}

TEST(ControlGuess, FlavoursAreValuesOfTheSetting) {
  EXPECT_EQ(flavourValue(ControlId::kFanucMill, "haas"), 1.0);
  EXPECT_EQ(flavourValue(ControlId::kLinuxCnc, "mach3"), 2.0);
  EXPECT_FALSE(flavourValue(ControlId::kLinuxCnc, "").has_value());
  EXPECT_FALSE(flavourValue(ControlId::kNct, "haas").has_value());
}

}  // namespace
}  // namespace proveout::test
