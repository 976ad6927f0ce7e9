// Lines: blanks, comments, words. Texts of errors are those of rs274 2.9.
#include <gtest/gtest.h>

#include "tests/unit/nc/linuxcnc/linuxcnc_run.h"

namespace proveout::test {
namespace {

// lcn-2-line
TEST(LinuxCncLine, BlanksAndCaseMeanNothing) {
  EXPECT_EQ(lcn("g0x1 0y- .5\nM2\n").motions(), (Lines{"R 10 -0.5 0"}));
  EXPECT_EQ(lcn("%\nG 0 x 1\tY 2 . 5\nm2\n%\n").motions(), (Lines{"R 1 2.5 0"}));
  const std::string blanks(300, ' ');
  EXPECT_EQ(lcn("G0 X1" + blanks + "\nM2\n").error(), "linuxcnc-long-line");
  EXPECT_EQ(lcn("G0 X1" + std::string(248, ' ') + "\nM2\n").error(), "linuxcnc-long-line");
  EXPECT_EQ(lcn("G0 X1" + std::string(247, ' ') + "\nM2\n").error(), "");
  EXPECT_EQ(lcn("o1 if [0]\n(" + std::string(260, 'x') + ")\no1 endif\nM2\n").error(), "linuxcnc-long-line");
  EXPECT_EQ(lcn("o1 if [0]\n(open\no1 endif\nM2\n").error(), "linuxcnc-open-comment");
  EXPECT_EQ(lcn("o1 if [0]\no2 iff [1]\no1 endif\nM2\n").error(), "linuxcnc-o-word");
}

// lcn-2-line
TEST(LinuxCncLine, PercentOpensAndCloses) {
  EXPECT_EQ(lcn("\n%\nG0 X1\n%\nG0 X2\n").motions(), (Lines{"R 1 0 0"}));
  EXPECT_EQ(lcn("G0 X1\n%\nG0 X2\nM2\n").message(), "Bad character '%' used");
}

// lcn-2-n
TEST(LinuxCncLine, LineNumbers) {
  EXPECT_EQ(lcn("N10.1 G0 X1\nn10.12345 X2\nN10 X3\nM2\n").motions(),
            (Lines{"R 1 0 0", "R 2 0 0", "R 3 0 0"}));
  EXPECT_TRUE(lcn("N-5 G0 X3\nM2\n").message().starts_with("Bad format unsigned integer"));
  EXPECT_EQ(lcn("G0 N5 X3\nM2\n").message(), "Bad character 'n' used");
}

// lcn-2-skip
TEST(LinuxCncLine, BlockDelete) {
  const std::string text = "G0 X1\n/X2\n/ (msg,hidden) X3\nM2\n";
  EXPECT_EQ(lcn(text).motions(), (Lines{"R 1 0 0", "R 2 0 0", "R 3 0 0"}));
  ControlSettings off = runAtZero();
  off.skip_switches[0] = true;
  EXPECT_EQ(lcn(text, {}, off).motions(), (Lines{"R 1 0 0"}));
  EXPECT_TRUE(told(lcn(text, {}, off)).empty());
}

// lcn-2-comment
TEST(LinuxCncLine, Comments) {
  EXPECT_EQ(lcn("G0 X1 (a(b)c)\nM2\n").message(), "Nested comment found");
  EXPECT_EQ(lcn("G0 X1 (abc\nM2\n").message(), "Unclosed comment found");
  EXPECT_EQ(lcn("G0 X1 )\nM2\n").message(), "Bad character ')' used");
  EXPECT_EQ(lcn("G0 X(in)1 ; it's (not\nY2;)\nM2\n").motions(), (Lines{"R 1 0 0", "R 1 2 0"}));
}

// lcn-2-msg lcn-2-print lcn-2-debug
TEST(LinuxCncLine, OnlyTheLastCommentIsActive) {
  EXPECT_EQ(told(lcn("(first)G0 X1(msg,second)\n(msg,a)(b)\n(msg,c);(msg,d)\n;msg,e\nM2\n")),
            (Lines{"second", "c"}));
  EXPECT_EQ(told(lcn("( MSG , hello)\n(MSG,  Hello World)\n( msg,x #1)\n(m s g,x)\nM2\n")),
            (Lines{"  Hello World", "x #1"}));
  EXPECT_EQ(told(lcn("(debug, #<nope> #1.5 #1+2)\n(print,a #1 b)\nM2\n")),
            (Lines{" ###### 0.000000.5 0.000000+2", "a 0.000000 b"}));
}

// lcn-2-log lcn-2-probeopen
TEST(LinuxCncLine, LogFilesAreNoted) {
  const IsoRun run =
      lcn("(logopen,x.log)\n#1=3\n(log,foo #1)\n(logclose)\n(probeopen x.txt)\n(probeclose)\nM2\n");
  EXPECT_EQ(run.error(), "");
  EXPECT_EQ(told(run), (Lines{"foo 3.000000"}));
  EXPECT_TRUE(run.tells("linuxcnc-noted"));
}

// lcn-2-words
TEST(LinuxCncLine, WordsThatCannotStand) {
  const std::pair<const char*, const char*> cases[] = {
      {"G0 X1 X2", "Multiple x words on one line"},
      {"G0 X1+2", "Bad character '+' used"},
      {"G0 X", "No characters found in reading real value"},
      {"G0 X[1", "Unclosed expression"},
      {"U1", "Bad character 'u' used"},
      {"G100", "G-code out of range"},
      {"M3.5", "Non integer value for integer"},
      {"M200", "M-code greater than 199: M200"},
      {"G0 X1 o1 call", "Bad character 'o' used"},
  };
  for (const auto& [line, message] : cases) {
    const std::string found = lcn(std::string(line) + "\nM2\n").message();
    EXPECT_TRUE(found.starts_with(message)) << line << ": " << found;
  }
}

// lcn-2-numbers
TEST(LinuxCncLine, Numbers) {
  EXPECT_EQ(lcn("G0 X+3 Y-.5 Z3.\nM2\n").motions(), (Lines{"R 3 -0.5 3"}));
  EXPECT_TRUE(lcn("G0 X1.2.3\nM2\n").message().starts_with("bad number format"));
  EXPECT_TRUE(lcn("G0 X1e3\nM2\n").message().starts_with("E word with no"));
  EXPECT_EQ(lcn("G[0.00001] X1\nG[20/20] F100 X2\nM2\n").motions(), (Lines{"R 1 0 0", "F 2 0 0"}));
}

// lcn-2-groups
TEST(LinuxCncLine, OneCodeOfAGroup) {
  for (const char* line : {"G0 G1 X2", "G98 G99", "G17 G18", "G4 P1 G53 G0 X1", "G0 G0 X1", "G43 G49"})
    EXPECT_EQ(lcn(std::string(line) + "\nM2\n").message(), "Two g codes used from same modal group") << line;
  for (const char* line : {"M7 M8", "M3 M4", "M0 M2", "M3 M19", "M8 M8", "M6 M61 Q1"})
    EXPECT_EQ(lcn(std::string(line) + "\nM2\n").message(), "Two m codes used from same modal group") << line;
}

}  // namespace
}  // namespace proveout::test
