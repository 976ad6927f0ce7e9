// Expressions and parameters. Figures are those of runs of rs274 2.9.
#include <gtest/gtest.h>

#include "tests/unit/nc/linuxcnc/linuxcnc_run.h"

namespace proveout::test {
namespace {

struct Case {
  const char* expression;
  const char* value;
};

// lcn-2-expr: row 38 of the acceptance list among them
TEST(LinuxCncExpression, RanksAndSigns) {
  const Case cases[] = {
      {"2**3+7 MOD 4*2", "14.000000"}, {"2**3**2", "64.000000"},
      {"-2**2", "4.000000"},           {"10-3-2", "5.000000"},
      {"2 m o d 3", "2.000000"},       {"-5 MOD 3", "1.000000"},
      {"5 MOD -3", "2.000000"},        {"1 EQ 1.00000001", "1.000000"},
      {"1 NE 1.00000001", "0.000000"}, {"1.0000001 GT 1", "1.000000"},
      {"1 GE 1.00000001", "0.000000"}, {"1 AND 0 OR 1", "1.000000"},
      {"2 XOR 3", "0.000000"},         {"1+1 EQ 2 AND 3 GT 2", "1.000000"},
      {"--[3]", "3.000000"},           {"- -3", "3.000000"},
  };
  for (const Case& c : cases) EXPECT_EQ(valueOf(c.expression), c.value) << c.expression;
}

// lcn-2-func
TEST(LinuxCncExpression, Functions) {
  const Case cases[] = {
      {"ROUND[2.5]", "3.000000"},       {"ROUND[-2.5]", "-3.000000"},   {"FIX[-2.5]", "-3.000000"},
      {"FIX[2.5]", "2.000000"},         {"FUP[-2.5]", "-2.000000"},     {"FUP[2.5]", "3.000000"},
      {"ATAN[-1]/[-1]", "-135.000000"}, {"ATAN[1]/[0]", "90.000000"},   {"SQRT[2]", "1.414214"},
      {"s q r t [2]", "1.414214"},      {"SIN[30]", "0.500000"},        {"COS[60]", "0.500000"},
      {"TAN[45]", "1.000000"},          {"ASIN[1]", "90.000000"},       {"ACOS[-1]", "180.000000"},
      {"EXP[1]", "2.718282"},           {"LN[10]", "2.302585"},         {"ABS[-4]", "4.000000"},
      {"EXISTS[#<nope>]", "0.000000"},  {"EXISTS[#99999]", "0.000000"}, {"EXISTS[#<_x>]", "1.000000"},
  };
  for (const Case& c : cases) EXPECT_EQ(valueOf(c.expression), c.value) << c.expression;
}

// lcn-2-experr
TEST(LinuxCncExpression, Errors) {
  const Case cases[] = {
      {"1/0", "Attempt to divide by zero"},
      {"SQRT[-1]", "Negative argument to sqrt"},
      {"LN[0]", "Zero or negative argument to ln"},
      {"ACOS[1.1]", "Argument to acos out of range"},
      {"ASIN[-2]", "Argument to asin out of range"},
      {"SQRT2", "Left bracket missing after unary operation name"},
      {"ATAN[1]", "Slash missing after first atan argument"},
      {"1 FOO 2", "Unknown operation"},
      {"FOO[1]", "Unknown word starting with f"},
      {"[1", "Unclosed expression"},
      {"", "bad number format"},
  };
  for (const Case& c : cases) {
    const std::string found = valueOf(c.expression);
    EXPECT_TRUE(found.starts_with(c.value)) << c.expression << ": " << found;
  }
}

// lcn-2-params: rows 37 and 43 of the acceptance list
TEST(LinuxCncParameters, TakeEffectBehindTheLine) {
  EXPECT_EQ(told(lcn("#1=5 #2=[#1+1] #3=#2\n(debug,#1 #2 #3)\nM2\n")), (Lines{"5.000000 1.000000 0.000000"}));
  EXPECT_EQ(told(lcn("#1=1 #1=2\n(debug,#1)\nM2\n")), (Lines{"2.000000"}));
  EXPECT_EQ(lcn("#2=4\n#1=7 G0 X#2 #1=2 Y#2 #2=1\nX#1 Y#2\nM2\n").motions(), (Lines{"R 4 4 0", "R 2 1 0"}));
  EXPECT_EQ(told(lcn("#1=5 (debug,#1)\nM2\n")), (Lines{"5.000000"}));
}

// lcn-2-params
TEST(LinuxCncParameters, NumbersAndNames) {
  EXPECT_EQ(told(lcn("#1=2 #2=9\n#<a b>=##1\n(debug,#<ab> #[1+1] #<A B>)\nM2\n")),
            (Lines{"9.000000 9.000000 9.000000"}));
  EXPECT_EQ(lcn("G0 X5\nX#31\nM2\n").motions(), (Lines{"R 5 0 0", "R 0 0 0"}));
  EXPECT_EQ(lcn("#0=1\nM2\n").message(), "Parameter number out of range");
  EXPECT_EQ(lcn("#5602=1\nM2\n").message(), "Parameter number out of range");
  EXPECT_EQ(lcn("#1.5=1\nM2\n").message(), "Non integer value for integer");
  EXPECT_EQ(lcn("#1 5\nM2\n").message(), "Equal sign missing in parameter setting");
}

// lcn-2-uninit, row 44
TEST(LinuxCncParameters, UnknownNames) {
  const IsoRun run = lcn("G1 X#<nope>\nM2\n");
  EXPECT_EQ(run.error(), "linuxcnc-not-defined");
  EXPECT_EQ(run.message(), "Named parameter #<nope> not defined");
}

// lcn-2-readonly, row 44
TEST(LinuxCncParameters, ReadOnly) {
  for (const char* line : {"#<_x>=1", "#5400=1", "#5413=1", "#5420=2", "#<_line>=3"})
    EXPECT_EQ(lcn(std::string(line) + "\nM2\n").error(), "linuxcnc-read-only") << line;
  for (const char* line : {"#5399=1", "#5414=1", "#5429=1", "#5070=1", "#5210=0", "#<_own>=1"})
    EXPECT_EQ(lcn(std::string(line) + "\nM2\n").error(), "") << line;
}

// lcn-2-predefined
TEST(LinuxCncParameters, Predefined) {
  const IsoRun run =
      lcn("G21 G91 G19 F120 S300 M4 M8\nG1 X1.5\n"
          "(debug,#<_x> #<_feed> #<_rpm> #<_plane> #<_motion_mode> #<_incremental> #<_absolute>)\n"
          "(debug,#<_spindle_on> #<_spindle_cw> #<_flood> #<_mist> #<_metric> #<_line> #<_coord_system>)\n"
          "G20\n(debug,#5420 #<_imperial> #<_ccomp> #<_call_level> #<_vmajor> #<_task>)\nM2\n");
  EXPECT_EQ(told(run), (Lines{"1.500000 120.000000 300.000000 190.000000 10.000000 1.000000 0.000000",
                              "1.000000 0.000000 1.000000 0.000000 1.000000 4.000000 540.000000",
                              "0.059055 1.000000 400.000000 0.000000 2.900000 0.000000"}))
      << run.message();
}

}  // namespace
}  // namespace proveout::test
