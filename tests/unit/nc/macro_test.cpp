// Formulas, variables and loops of the macro language, without a control around them.
// Proves nct-23.1.2-num nct-23.1.6-const nct-23.2.3-range nct-23.2.4-SQRT nct-23.2.4-EXP nct-23.2.4-LN
// nct-23.2.6-brackets
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/geometry/degrees.h"
#include "core/nc/macro/expression.h"
#include "core/nc/macro/loop_index.h"
#include "core/nc/nct/alarms.h"
#include "core/nc/nct/formulas.h"

namespace proveout::nc {
namespace {

class Environment : public MacroEnvironment {
 public:
  int axisNumber(std::string_view name) const override {
    return name == "X" ? 1 : name == "Y" ? 2 : name == "Z" ? 3 : name == "C" ? 6 : -1;
  }
  ParameterAnswer parameter(int number, int bit, int index) const override {
    if (number == 107 && bit < 0) return {SharedAlarm::kParameterMissing, "2. parameter missing", 0.0};
    return {{}, {}, number + 1000.0 * bit + 1e6 * index};
  }
};

class MacroFormulas : public testing::Test {
 protected:
  /// The value of a whole formula; NaN and error_ where it fails; -1e99 for vacant.
  double value(const std::string& text) {
    Value out;
    std::size_t pos = 0;
    error_ = {};
    if (!macro_.formula(text, pos, out, error_)) return std::nan("");
    EXPECT_EQ(pos, text.size()) << text;
    return out.vacant ? -1e99 : out.number;
  }
  std::string errorOf(const std::string& text) {
    EXPECT_TRUE(std::isnan(value(text))) << text;
    EXPECT_GT(error_.columns.begin, 0) << text;
    EXPECT_GT(error_.columns.end, error_.columns.begin) << text;
    EXPECT_FALSE(error_.message.empty()) << text;
    return error_.code;
  }
  std::string assign(const std::string& text) {
    std::size_t pos = 0;
    error_ = {};
    return macro_.assign(text, pos, error_) ? "" : error_.code;
  }
  bool holds(const std::string& text) {
    std::size_t pos = 0;
    bool out = false;
    EXPECT_TRUE(macro_.condition(text, pos, out, error_)) << text << error_.message;
    EXPECT_EQ(pos, text.size());
    return out;
  }
  double variable(int number) {
    Value out;
    EXPECT_EQ(store_.read(number, out), VariableStatus::kDone) << number;
    return out.vacant ? -1e99 : out.number;
  }

  VariableStore store_;
  Environment environment_;
  MacroEvaluator macro_{store_, environment_, nctAlarms(), nctFormulas()};
  LexError error_;
};

TEST_F(MacroFormulas, NumbersAreTheNearestDoubles) {
  for (const char* text : {"0", "256", "134.89654", ".5", "5.", "0.1", "00012.50", "123456789.987654321",
                           "3.14159265358979323846", "1694498816"}) {
    EXPECT_EQ(value(text), std::strtod(text, nullptr)) << text;
  }
  EXPECT_EQ(value("1" + std::string(300, '0')), 1e300);
  EXPECT_EQ(errorOf("1" + std::string(400, '0')), "nct-2064");
  EXPECT_EQ(errorOf("1..2"), "nct-2064");
  EXPECT_EQ(errorOf("."), "nct-2064");
  EXPECT_EQ(value("#3101"), std::numbers::pi);
  EXPECT_EQ(value("#_pi"), std::numbers::pi);
  EXPECT_EQ(value("#_E"), std::numbers::e);
  EXPECT_EQ(value("#_EMPTY"), -1e99);
  EXPECT_EQ(value("#0"), -1e99);
}

TEST_F(MacroFormulas, ArithmeticGoesByPrecedence) {
  EXPECT_EQ(value("27MOD4"), 3);
  EXPECT_EQ(value("1+2*3-4/2"), 5);
  EXPECT_EQ(value("10-4-3"), 3) << "from the left";
  EXPECT_EQ(value("24/4/2"), 3);
  EXPECT_EQ(value("-2*-3"), 6);
  EXPECT_EQ(value("[1+2]*3"), 9);
  EXPECT_EQ(value("1 + ( a comment ) 2"), 3);
  EXPECT_EQ(value("1+2*COS60"), 2) << "first the function, then the product";
  EXPECT_NEAR(value("COS[[[5-2]*10+30]*1]"), 0.5, 1e-15);
  EXPECT_EQ(value("7AND3+8"), 11) << "AND binds like *";
  EXPECT_EQ(value("1OR2*4"), 9) << "OR binds like +";
  EXPECT_EQ(value("-7MOD4"), -3);
  EXPECT_EQ(value("5.5MOD2"), 1.5);
  EXPECT_EQ(errorOf("5/0"), "nct-2093");
  EXPECT_EQ(errorOf("5MOD0"), "nct-2093");
  EXPECT_EQ(errorOf("5/#1"), "nct-2093") << "vacant counts as 0";
  EXPECT_EQ(errorOf("EXP800"), "nct-2092");
  EXPECT_EQ(errorOf("[1+2"), "nct-2121");
  EXPECT_EQ(errorOf("1+"), "nct-2064");
  EXPECT_EQ(errorOf("[1 2]"), "nct-2064");
  EXPECT_EQ(errorOf("ROUND[1]"), "nct-2064");
}

TEST_F(MacroFormulas, FunctionsAreInDegrees) {
  EXPECT_EQ(value("SIN30"), 0.5);
  EXPECT_EQ(value("SIN[-150]"), -0.5);
  EXPECT_EQ(value("COS90"), 0);
  EXPECT_EQ(value("COS[-180]"), -1);
  EXPECT_EQ(value("SIN720"), 0);
  EXPECT_EQ(value("TAN45"), 1);
  for (double a = -725.3; a < 725; a += 7.31) {
    const std::string text = "[" + std::to_string(a) + "]";
    const double r = std::strtod(text.c_str() + 1, nullptr) * std::numbers::pi / 180;
    EXPECT_NEAR(value("SIN" + text), std::sin(r), 1e-14) << a;
    EXPECT_NEAR(value("COS" + text), std::cos(r), 1e-14) << a;
    EXPECT_NEAR(value("TAN" + text) / std::tan(r), 1.0, 1e-12) << a;
  }
  EXPECT_NEAR(value("ASIN[-0.5]"), -30, 1e-12);
  EXPECT_NEAR(value("ACOS[-0.5]"), 120, 1e-12);
  EXPECT_NEAR(value("ATAN[-0.5]"), -26.56505117707799, 1e-12);
  EXPECT_NEAR(value("EXP1"), std::numbers::e, 1e-15);
  EXPECT_NEAR(value("LN2.718281828"), 0.99999999983, 1e-11);
  EXPECT_EQ(value("SQRT[5+4]"), 3);
  EXPECT_EQ(errorOf("SQRT[-1]"), "nct-2122");
  for (const char* text : {"TAN90", "TAN[-270]", "TAN450"}) EXPECT_EQ(errorOf(text), "nct-2116") << text;
  EXPECT_GT(value("TAN89.999999"), 1e7);
  EXPECT_EQ(errorOf("ASIN1.1"), "nct-2117");
  EXPECT_EQ(errorOf("ACOS[-1.0001]"), "nct-2117");
  EXPECT_EQ(errorOf("LN0"), "nct-2118");
  EXPECT_EQ(value("FIX4.8"), 4);
  EXPECT_EQ(value("FIX[-6.7]"), -6);
  EXPECT_EQ(value("FUP12.1"), 13);
  EXPECT_EQ(value("FUP[-7.3]"), -8);
  EXPECT_EQ(value("FUP12"), 12);
  EXPECT_EQ(value("ABS[-3.1]"), 3.1);
  EXPECT_EQ(value("ABS[0]"), 0);
}

TEST_F(MacroFormulas, LogicIsOf32Bits) {
  EXPECT_EQ(value("NOT0"), -1);
  EXPECT_EQ(value("[16777215AND305419896]XOR[-1694498816]"), -1691068808.0) << "9B345678h";
  EXPECT_EQ(value("5OR3"), 7);
  EXPECT_EQ(value("5XOR3"), 6);
  EXPECT_EQ(value("5AND3"), 1);
  EXPECT_EQ(value("2.6AND3"), 3) << "rounded";
  EXPECT_EQ(value("4294967295AND15"), 15);
  EXPECT_EQ(value("NOT4294967295"), 0);
  EXPECT_EQ(errorOf("4294967296AND1"), "nct-2129");
  EXPECT_EQ(errorOf("1OR[-4294967296]"), "nct-2129");
  EXPECT_EQ(errorOf("NOT1000000000000"), "nct-2129");
}

TEST_F(MacroFormulas, VariablesByNumberAndFormula) {
  EXPECT_EQ(assign("#100=7"), "");
  EXPECT_EQ(assign("#120=104"), "");
  EXPECT_EQ(value("#[#120-4]"), 7);
  EXPECT_EQ(assign("#[#120]=#100*2"), "");
  EXPECT_EQ(variable(104), 14);
  EXPECT_EQ(errorOf("##120"), "nct-2064");
  EXPECT_EQ(errorOf("#34"), "nct-variable");
  EXPECT_EQ(errorOf("#[1.5]"), "nct-2002");
  EXPECT_EQ(errorOf("#[-1]"), "nct-variable");
  EXPECT_EQ(errorOf("#99999999999999999999"), "nct-variable");
  EXPECT_EQ(errorOf("#_NONSENSE[3]"), "nct-variable");
  EXPECT_EQ(assign("#3101=1"), "nct-2161");
  EXPECT_EQ(assign("#0=1"), "nct-2161");
  EXPECT_EQ(assign("#1"), "nct-2064");
}

TEST_F(MacroFormulas, VacancyIsCopiedAndCountsAsZeroInArithmetic) {
  assign("#2=5");
  EXPECT_EQ(assign("#2=#1"), "");
  EXPECT_EQ(variable(2), -1e99);
  EXPECT_EQ(value("#1*3"), 0);
  EXPECT_EQ(value("#1+#1"), 0);
  EXPECT_TRUE(holds("[#1EQ#0]"));
  EXPECT_TRUE(holds("[#1 NE 0]"));
  EXPECT_TRUE(holds("[#1GE#0]"));
  EXPECT_TRUE(holds("[#1GT0]"));
  assign("#1=0");
  EXPECT_FALSE(holds("[#1EQ#0]"));
  EXPECT_FALSE(holds("[#1 NE 0]"));
  EXPECT_FALSE(holds("[#1GE#0]"));
  EXPECT_FALSE(holds("[#1GT0]"));
}

TEST_F(MacroFormulas, ConditionsCompare) {
  assign("#1=-5.4");
  EXPECT_TRUE(holds("[#1LT-5.39]"));
  EXPECT_FALSE(holds("[#1GT-5.39]"));
  EXPECT_TRUE(holds("[[#1+1]LE-4.4]"));
  EXPECT_TRUE(holds("[2 ge 2]"));
  EXPECT_FALSE(holds("[2NE2]"));
  const auto error = [&](const std::string& text) {
    std::size_t pos = 0;
    bool out = false;
    EXPECT_FALSE(macro_.condition(text, pos, out, error_)) << text;
    return error_.code;
  };
  EXPECT_EQ(error("[#1=2]"), "nct-2121");
  EXPECT_EQ(error("[#1EQ2"), "nct-2121");
  EXPECT_EQ(error("#1EQ2"), "nct-2064");
  EXPECT_EQ(error("[#1]"), "nct-2064");
  EXPECT_EQ(error("[[#1EQ2]AND[#1EQ3]]"), "nct-2064");
  EXPECT_EQ(error("[1EQ1EQ1]"), "nct-2064");
}

TEST_F(MacroFormulas, ValuesOfWordsTakeASignAndOneOperand) {
  const auto word = [&](const std::string& text, std::size_t length) {
    Value out;
    std::size_t pos = 0;
    EXPECT_TRUE(macro_.evaluate(text, pos, out, error_)) << text;
    EXPECT_EQ(pos, length) << text;
    return out;
  };
  assign("#24=135.5");
  EXPECT_EQ(word("-#24Y5", 4).number, -135.5);
  EXPECT_EQ(word("-[#24+1]", 8).number, -136.5);
  EXPECT_EQ(word("SIN30-#24", 5).number, 0.5) << "a formula needs brackets";
  EXPECT_TRUE(word("-#1", 3).vacant);
  EXPECT_FALSE(word("-[#1+#2]", 8).vacant);
}

TEST_F(MacroFormulas, DeepNestingIsRefused) {
  const std::string deep(100000, '[');
  EXPECT_EQ(errorOf(deep), "nct-2064");
  std::string variables, nots;
  for (int k = 0; k < 100000; ++k) {
    variables += "#[";
    nots += "NOT";
  }
  EXPECT_EQ(errorOf(variables), "nct-2064");
  EXPECT_EQ(errorOf(nots + "1"), "nct-2064");
  EXPECT_EQ(value(std::string(30, '[') + "1" + std::string(30, ']')), 1);
  EXPECT_EQ(value(std::string(100000, '-') + "1"), 1);
}

TEST_F(MacroFormulas, AxisNumbersAndParameters) {
  EXPECT_EQ(value("AXNUM[X]"), 1);
  EXPECT_EQ(value("axnum[ c ]"), 6);
  EXPECT_EQ(errorOf("AXNUM[Q]"), "nct-2017");
  EXPECT_EQ(errorOf("AXNUM X"), "nct-2064");
  EXPECT_EQ(assign("#101=PRM[1339]"), "");
  EXPECT_EQ(variable(101), 1339.0 - 1000);
  EXPECT_EQ(assign("#101=PRM[1746,#20+1]/[1]"), "");
  EXPECT_EQ(variable(101), 1746 + 1000 + 1e6);
  EXPECT_EQ(assign("#101=PRM[1339](/[1])"), "");
  EXPECT_EQ(variable(101), 339);
  EXPECT_EQ(assign("#101=[PRM[1339]]/[2]"), "");
  EXPECT_EQ(variable(101), 169.5);
  EXPECT_EQ(errorOf("PRM[1339]"), "nct-2017");
  EXPECT_EQ(assign("#101=PRM[]"), "nct-2064");
  EXPECT_EQ(assign("#101=PRM[#33]"), "nct-2064");
  EXPECT_EQ(assign("#101=PRM[107]"), "nct-2194");
}

TEST(Degrees, SimpleAnglesAreExactAndOthersTrue) {
  const double half[12] = {0, 0.5,  0, 1,  0, 0.5,
                           0, -0.5, 0, -1, 0, -0.5};  // sines at multiples of 30, where simple
  for (int turn = -2; turn <= 2; ++turn) {
    for (int k = 0; k < 12; ++k) {
      const double angle = 360.0 * turn + 30.0 * k;
      if (k % 6 == 0 || k % 2 == 1) {
        EXPECT_EQ(sinDegrees(angle), half[k]) << angle;
      }
      const int c = (k + 3) % 12;
      if (c % 6 == 0 || c % 2 == 1) {
        EXPECT_EQ(cosDegrees(angle), half[c]) << angle;
      }
    }
  }
  EXPECT_FALSE(std::signbit(sinDegrees(180.0)) || std::signbit(sinDegrees(-360.0)));
  for (double angle = -720.0; angle < 720.0; angle += 0.37) {
    const long double exact =
        static_cast<long double>(std::remainder(angle, 360.0)) * std::acos(-1.0L) / 180.0L;
    EXPECT_NEAR(sinDegrees(angle), static_cast<double>(std::sin(exact)), 2e-16) << angle;
    EXPECT_NEAR(cosDegrees(angle), static_cast<double>(std::cos(exact)), 2e-16) << angle;
  }
  EXPECT_TRUE(std::isnan(sinDegrees(std::numeric_limits<double>::infinity())));
}

TEST(MacroSymbols, TheLongestNameWins) {
  VariableStore store;
  store.addSymbol({"WZP4", 7061, 1, 20});
  store.addSymbol({"WZP48", 7941, 1, 20});
  std::size_t length = 0;
  EXPECT_EQ(store.symbolAt("wzp48[1]", length)->number, 7941);
  EXPECT_EQ(length, 5u);
  EXPECT_EQ(store.symbolAt("WZP4[1]", length)->number, 7061);
  EXPECT_EQ(store.symbolAt("PIEQ3", length)->number, 3101) << "a keyword may follow at once";
  EXPECT_EQ(store.symbolAt("WZP", length), nullptr);
}

TEST(MacroLoops, PairsByNesting) {
  const std::vector<std::string_view> lines{"WHILE[#[1]LT2]DO1",
                                            "(DO1",
                                            "END1)",
                                            "N5/2 DO 2",
                                            "END2 (x)",
                                            "X1",
                                            "END1",
                                            "DO1",
                                            "DO2",
                                            "END1",
                                            "END2",
                                            "DO3",
                                            "DO3",
                                            "END3"};
  const LoopIndex loops(lines);
  ASSERT_NE(loops.find(0), nullptr);
  EXPECT_EQ(loops.find(0)->partner, 6u);
  EXPECT_EQ(loops.find(1), nullptr) << "inside a comment";
  EXPECT_EQ(loops.find(3)->partner, 4u);
  EXPECT_EQ(loops.find(6)->partner, 0u);
  EXPECT_EQ(loops.find(7)->fault, LoopIndex::Fault::kNoEnd) << "the pairs overlap";
  EXPECT_EQ(loops.find(9)->fault, LoopIndex::Fault::kNoDo);
  EXPECT_EQ(loops.find(10)->partner, 8u);
  EXPECT_EQ(loops.find(12)->fault, LoopIndex::Fault::kDoubled);
}

}  // namespace
}  // namespace proveout::nc
