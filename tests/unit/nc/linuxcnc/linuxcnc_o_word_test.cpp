// O-words and M98. Figures and texts are those of runs of rs274 2.9.
#include <gtest/gtest.h>

#include "tests/unit/nc/linuxcnc/linuxcnc_run.h"

namespace proveout::test {
namespace {

// lcn-2-o: rows 40, 43 and 54 of the acceptance list
TEST(LinuxCncOWords, SubsAndTheirValues) {
  const IsoRun tri =
      lcn("G21 F100\no<tri> sub\nG1 X#1 Y#2\no<tri> return [#1+#2]\no<tri> endsub [1]\n"
          "o<TRI> call [3] [4]\n(debug,#<_value> #<_value_returned>)\nM2\n");
  EXPECT_EQ(tri.motions(), (Lines{"F 3 4 0"}));
  EXPECT_EQ(told(tri), (Lines{"7.000000 1.000000"}));
  EXPECT_EQ(lcn("o100 call\nM2\no100 sub\nG0 X3\no100 endsub\n").motions(), (Lines{"R 3 0 0"}));
  EXPECT_EQ(
      told(
          lcn("#1=9\no100 sub\n(debug,#1 #2)\n#1=7\no100 endsub\no100 call [3]\n(debug,#1 #<_value>)\nM2\n")),
      (Lines{"3.000000 0.000000", "9.000000 0.000000"}));
  EXPECT_EQ(told(lcn("o1 sub\n#<a>=2\n(debug,#<_g>)\n#<_g>=3\no1 endsub\n#<a>=1\n#<_g>=1\no1 call\n"
                     "(debug,#<a> #<_g>)\nM2\n")),
            (Lines{"1.000000", "1.000000 3.000000"}));
  EXPECT_EQ(told(lcn("o1 sub\n(debug,#<a>)\no1 endsub\n#<a>=1\n#2=1\no#2 call\nM2\n")), (Lines{"######"}));
}

// lcn-2-o
TEST(LinuxCncOWords, LevelsEnd) {
  const IsoRun run =
      lcn("o100 sub\n#2=[#1+1]\n(debug,#1 #<_call_level>)\no100 call [#2]\no100 endsub\n"
          "o100 call [1]\nM2\n");
  EXPECT_EQ(told(run).size(), 9u);
  EXPECT_EQ(told(run).back(), "9.000000 9.000000");
  EXPECT_EQ(run.message(), "Too many subroutine levels");
}

// lcn-2-oflow: row 41
TEST(LinuxCncOWords, BranchesAndLoops) {
  const std::pair<const char*, Lines> cases[] = {
      {"o1 if [0]\n(debug,a)\no1 elseif [1]\n(debug,b)\no1 elseif [1]\n(debug,c)\no1 else\n(debug,d)\no1 "
       "endif\n",
       {"b"}},
      {"o1 if [0]\n(debug,a)\no1 elseif [0]\n(debug,b)\no1 else\n(debug,d)\no1 endif\n", {"d"}},
      {"o1 if [2]\n(debug,a)\no1 elseif [1]\n(debug,b)\no1 else\n(debug,d)\no1 endif\n", {"a"}},
      {"o1 while [#1 lt 3]\n#1=[#1+1]\no2 if [#1 eq 2]\no1 continue\no2 endif\n(debug,#1)\no1 "
       "endwhile\n(debug,e)\n",
       {"1.000000", "3.000000", "e"}},
      {"o1 do\n#1=[#1+1]\no2 if [#1 eq 2]\no1 continue\no2 endif\n(debug,#1)\no1 while [#1 lt 4]\n",
       {"1.000000", "3.000000", "4.000000"}},
      {"o1 do\n#1=[#1+1]\no2 if [#1 eq 2]\no1 break\no2 endif\n(debug,#1)\no1 while [#1 lt 4]\n(debug,e)\n",
       {"1.000000", "e"}},
      {"o1 repeat [2.5]\no2 repeat [2]\n(debug,x)\no2 endrepeat\no1 endrepeat\n", {"x", "x", "x", "x"}},
      {"o1 repeat [0]\n(debug,x)\no1 endrepeat\no2 repeat [-1]\n(debug,x)\no2 endrepeat\n", {}},
      {"o1 sub\no1 repeat [2]\n(debug,x)\no1 endrepeat\no1 endsub\no1 call\n", {"x", "x"}},
      {"o<a> sub\no100 if [1]\n(debug,a)\no100 endif\no<a> endsub\no<b> sub\no100 if [1]\n(debug,b)\no100 "
       "endif\n"
       "o<b> endsub\no<a> call\no<b> call\no100 if [1]\n(debug,m)\no100 endif\no<a> call\n",
       {"a", "b", "m", "a"}},
      {"N5 o1 if [1]\n(debug,x)\n/o1 endif\n", {"x"}},
      {"o<Foo Bar> sub\n(debug,#1)\no<foobar> endsub\no<FOObar> call [1] [2] (x)\n", {"1.000000"}},
  };
  for (const auto& [text, lines] : cases) {
    const IsoRun run = lcn(std::string(text) + "M2\n");
    EXPECT_EQ(told(run), lines) << text << run.message();
    EXPECT_EQ(run.error(), "") << text << run.message();
  }
}

// lcn-2-o: the control takes the conditions behind a branch that was taken in hand all the same.
TEST(LinuxCncOWords, ConditionsBehindATakenBranchAreEvaluated) {
  const IsoRun run = lcn("o1 if [2]\nG0 X1\no1 elseif [1/0]\nG0 X2\no1 endif\nM2\n");
  EXPECT_EQ(run.error(), "linuxcnc-divide-by-zero");
  EXPECT_EQ(run.motions(), (Lines{"R 1 0 0"}));
}

// lcn-2-o: what LinuxCNC 2.9 does not forget, by its interpreter.
TEST(LinuxCncOWords, BreaksAndContinuesAreLeftOver) {
  const IsoRun once =
      lcn("o1 do\n#1=[#1+1]\nG0 X#1\no2 while [1]\no2 break\no2 endwhile\no1 while [#1 LT 3]\nM2\n");
  EXPECT_EQ(once.motions(), (Lines{"R 1 0 0"}));
  EXPECT_TRUE(once.tells("linuxcnc-left-over"));
  // A break that it passes over where the loop ends by its condition.
  const IsoRun passed =
      lcn("o2 while [#1 LT 1]\n#1=[#1+1]\no3 if [0]\no2 break\no3 endif\no2 endwhile\n"
          "o1 do\n#2=[#2+1]\nG0 X#2\no1 while [#2 LT 3]\nM2\n");
  EXPECT_EQ(passed.motions(), (Lines{"R 1 0 0"}));
  EXPECT_TRUE(passed.tells("linuxcnc-left-over"));
  const IsoRun twice =
      lcn("o1 do\n#1=[#1+1]\no1 continue\no1 while [#1 LT 2]\no2 repeat [2]\n#2=[#2+1]\nG0 X#2\n"
          "o2 endrepeat\nM2\n");
  EXPECT_EQ(twice.motions(), (Lines{"R 1 0 0", "R 2 0 0", "R 3 0 0", "R 4 0 0"}));
  EXPECT_TRUE(twice.tells("linuxcnc-left-over"));
}

// lcn-2-oerr
TEST(LinuxCncOWords, Errors) {
  const std::pair<const char*, const char*> cases[] = {
      {"o100 call", "EOF in file:main.nc seeking o-word: o100 from line: 1"},
      {"o<foo> call", "EOF in file:main.nc seeking o-word: o<foo> from line: 1"},
      {"o100 while [0]\nG0 X1", "EOF in file:main.nc seeking o-word: o100 from line: 1"},
      {"o100 repeat [0]", "EOF in file:main.nc seeking o-word: o100 from line: 1"},
      {"o100 if [0]", "EOF in file:main.nc seeking o-word: o100 from line: 1"},
      {"o100 sub", "EOF in file:main.nc seeking o-word: o100 from line: 1"},
      {"o100 endif", "undefined O-word label: 'o100 endif'"},
      {"o100 else", "undefined O-word label: 'o100 else'"},
      {"o100 endwhile", "undefined O-word label: 'o100 endwhile'"},
      {"o100 break", "undefined O-word label: 'o100 break'"},
      {"o100 return", "not in a subroutine definition: 'o100 return'"},
      {"o100 sub\no100 endsub\no100 sub\no100 endsub", "redefining sub: o100 already defined in line 1"},
      {"o1 sub\no2 sub\no2 endsub\no1 endsub", ""},
      {"o1 sub\no2 sub\no2 endsub\no1 endsub\no1 call", "Nested subroutine definition"},
      {"o1 if [1]\no1 endif\no1 if [1]\no1 endif",
       "duplicate O-word label - already defined in line 1: 'o1 if'"},
      {"o1 repeat [1]\no1 break\no1 endrepeat",
       "no matching while/do label: 'o1 break' (found 'repeat' in line 1)"},
      {"o1 if 1", "Left bracket missing after 'if'"},
      {"o1 if [1] G0 X1\no1 endif", "Unexpected character after O-word"},
      {"o1 if [[1] gt [0]] and [1]", "Unexpected character after O-word"},
      {"o1 sub\no1 endsub\no1 call 5", "Unexpected character after O-word"},
      {"o1 foo", "Unknown control command in o word"},
      {"o1 if [1/0]\no1 endif", "Attempt to divide by zero"},
      {"o", "O-word without a number or a <name>"},
      {"o<a", "O-word without a number or a <name>"},
  };
  for (const auto& [text, message] : cases)
    EXPECT_EQ(lcn(std::string(text) + "\nM2\n").message(), message) << text;
  EXPECT_TRUE(lcn("o1 if [1]\nG0 X1\nM2\n").tells("linuxcnc-missing-endif"));
}

// lcn-2-ofile
TEST(LinuxCncOWords, SubsInFiles) {
  const std::map<std::string, std::string> files = {
      {"sq.ngc", "o<sq> sub\n(debug,file #1)\no<sq> endsub [#1*2]\n"},
      {"100.ngc", "o100 sub\nG0 X#1\no200 call [#1]\no100 endsub\no200 sub\nG0 Y#1\no200 endsub\n"},
      {"7.ngc", "o7\nG0 X7\nM99\n"},
      {"bad.ngc", "o<bad> sub\nG0 X1\n"},
      {"plain.ngc", "G0 X1\nM2\n"},
  };
  EXPECT_EQ(told(lcn("o<SQ> call [4]\n(debug,#<_value>)\nM2\n", files)),
            (Lines{"file 4.000000", "8.000000"}));
  EXPECT_EQ(lcn("M98 P7\nG0 Y1\nM2\n", files).motions(), (Lines{"R 7 0 0", "R 7 1 0"}));
  EXPECT_EQ(lcn("o<bad> call\nM2\n", files).error(), "linuxcnc-missing-end");
  EXPECT_EQ(lcn("o<plain> call\nM2\n", files).error(), "linuxcnc-missing-end");
  EXPECT_EQ(lcn("o100 call [5]\nM2\n", files).motions(), (Lines{"R 5 0 0", "R 5 5 0"}));
}

// lcn-2-M98: row 42
TEST(LinuxCncOWords, NumberedCalls) {
  EXPECT_EQ(lcn("G21 F100\nM98 P10 L3\nG0 Y9\nM2\no10\nG91 G1 X1\nM99\n").motions(),
            (Lines{"F 1 0 0", "F 2 0 0", "F 3 0 0", "R 3 9 0"}));
  EXPECT_EQ(told(lcn("#1=5\nM98 P10\n(debug,#1)\nM2\no10\n(debug,in #1)\n#1=7\nM99\n")),
            (Lines{"in 5.000000", "7.000000"}));
  EXPECT_EQ(told(lcn("M98 P5 L0\n(debug,out)\nM2\no5\n(debug,in)\nM99\n")), (Lines{"out"}));
  EXPECT_EQ(lcn("M98 L2\nM2\n").message(), "Found 'm98' code with no P-word");
  EXPECT_EQ(lcn("M98 P7\nM2\n").message(), "EOF in file:main.nc seeking o-word: o7 from line: 1");
  EXPECT_EQ(lcn("M98 P5.2\nM2\n").message(), "Non integer value for integer");
  EXPECT_EQ(lcn("M98 P5 L-1\nM2\no5\nM99\n").message(), "Negative l word used");
  EXPECT_TRUE(lcn("G0 X1\nM99\n").tells("linuxcnc-main-m99"));
  EXPECT_EQ(lcn("O5\nG0 X1\nM2\n").motions(), (Lines{"R 1 0 0"}));
}

}  // namespace
}  // namespace proveout::test
