// The shared evaluator of formulas, with languages of this test's own: ranks, directions, relations,
// functions of two arguments, vacant values, and random formulas against an evaluator that works another way.
#include "core/nc/macro/formula.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "core/nc/macro/expression.h"
#include "core/nc/nct/alarms.h"
#include "core/nc/nct/formulas.h"

namespace proveout::nc {
namespace {

enum Special { kExists = 1 };

constexpr auto kOperators = std::to_array<FormulaOperator>({
    {"AND", 0, Operation::kAnd},
    {"OR", 0, Operation::kOr},
    {"XOR", 0, Operation::kXor},
    {"EQ", 1, Operation::kEqual},
    {"NE", 1, Operation::kUnequal},
    {"GT", 1, Operation::kGreater},
    {"GE", 1, Operation::kGreaterEqual},
    {"LT", 1, Operation::kLess},
    {"LE", 1, Operation::kLessEqual},
    {"+", 2, Operation::kAdd},
    {"-", 2, Operation::kSubtract},
    {"**", 4, Operation::kPower},
    {"*", 3, Operation::kMultiply},
    {"//", -1, Operation::kEnd},
    {"/", 3, Operation::kDivide},
    {"MOD", 3, Operation::kModuloPositive},
    {"^", 5, Operation::kPower, true},
});
constexpr auto kFunctions = std::to_array<FormulaFunction>({
    {"ABS", absoluteValue},
    {"ATAN", nullptr, arcTangentOf},
    {"ANGLE", arcTangent, arcTangentOf, "/,"},
    {"SQRT", squareRoot},
    {"SIN", sine},
    {"FIX", downwards},
    {"FUP", upwards},
    {"LN", naturalLogarithm},
    {"ROUND", nearest},
    {"POW", nullptr, [](double x, double y, double& out) { return out = std::pow(x, y), Refusal(); }, ","},
    {"EXISTS", nullptr, nullptr, {}, kExists},
});

constexpr FormulaRules namedRules() {
  FormulaRules out;
  out.argument = FormulaArgument::kBracket;
  out.whole_conditions = true;
  out.most_depth = 20;
  return out;
}
constexpr FormulaLanguage kNamed{namedRules(), FormulaRows(kOperators), FormulaRows(kFunctions)};

/// Variables are #<name>; EXISTS[#<name>].
class NamedFormula : public FormulaParser<NamedFormula> {
 public:
  NamedFormula(const FormulaLanguage& language, std::string_view text,
               const std::map<std::string, double>& variables, std::vector<std::uint32_t>& reads)
      : FormulaParser(language, text, 0, reads), variables_(variables) {}

  std::optional<FormulaFault> fault;

  bool fail(const FormulaFault& told) {
    fault = told;
    return false;
  }
  bool variable(Value& out) {
    const std::size_t begin = i;
    const std::optional<std::string> name = nameHere();
    const auto found = name ? variables_.find(*name) : variables_.end();
    if (found == variables_.end()) return failAt(Kind::kNoOperand, begin);
    out = {found->second, std::isnan(found->second)};
    if (out.vacant) out.number = 0.0;
    return true;
  }
  bool special(int which, const FormulaFunction& function, Value& out) {
    EXPECT_EQ(which, kExists);
    i += function.text.size();
    const std::size_t begin = i;
    if (!take('[')) return failAt(Kind::kNoArgument, begin);
    const std::optional<std::string> name = nameHere();
    if (!name || !take(']')) return failAt(Kind::kNoArgument, begin);
    out = {variables_.contains(*name) ? 1.0 : 0.0, false};
    return true;
  }
  bool otherName(Value& /*out*/) { return failAt(Kind::kNoOperand, i); }
  double tolerance() const { return 1e-6; }

 private:
  std::optional<std::string> nameHere() {
    const std::size_t close = text_.find('>', i);
    if (text_.substr(i, 2) != "#<" || close == std::string_view::npos) return std::nullopt;
    std::string name(text_.substr(i + 2, close - i - 2));
    i = close + 1;
    return name;
  }
  const std::map<std::string, double>& variables_;
};

class NamedFormulas : public testing::Test {
 protected:
  double value(const std::string& text, const FormulaLanguage& language = kNamed) {
    NamedFormula formula(language, text, variables_, reads_);
    Value out;
    fault_.reset();
    const bool good = formula.formula(out);
    fault_ = formula.fault;
    EXPECT_EQ(good, !fault_) << text;
    end_ = formula.pos();
    return good ? out.number : std::nan("");
  }
  FormulaFault faultOf(const std::string& text, const FormulaLanguage& language = kNamed) {
    EXPECT_TRUE(std::isnan(value(text, language))) << text;
    return fault_.value_or(FormulaFault{});
  }
  bool holds(const std::string& text, const FormulaLanguage& language = kNamed) {
    NamedFormula formula(language, text, variables_, reads_);
    bool out = false;
    EXPECT_TRUE(formula.condition(out)) << text;
    EXPECT_EQ(formula.pos(), text.size()) << text;
    return out;
  }

  std::map<std::string, double> variables_{
      {"_x", 12.5}, {"a b", -2.0}, {"null", std::nan("")}, {"zero", 0.0}};
  std::vector<std::uint32_t> reads_;
  std::optional<FormulaFault> fault_;
  std::size_t end_ = 0;
};

TEST_F(NamedFormulas, OperatorsBindByRankAndGoFromLeftToRight) {
  EXPECT_EQ(value("2+3*2"), 8);
  EXPECT_EQ(value("10-3-2"), 5);
  EXPECT_EQ(value("2**3**2"), 64);
  EXPECT_EQ(value("2*3**2"), 18);
  EXPECT_EQ(value("-2**2"), 4);
  EXPECT_EQ(value("7 MOD 4*2"), 6);
  EXPECT_EQ(value("-5 MOD 3"), 1);
  EXPECT_EQ(value("5 mod -3"), 2);
  EXPECT_EQ(value("[2+3]*2"), 10);
  EXPECT_EQ(value("1 - -2"), 3);
  EXPECT_EQ(value("12/3/2"), 2);
  EXPECT_EQ(value("12/[3/2]"), 8);
}

TEST_F(NamedFormulas, AnOperatorMayGoFromRightToLeft) {
  EXPECT_EQ(value("2^3^2"), 512);
  EXPECT_EQ(value("2^2**3"), 64);
  EXPECT_EQ(value("2**2^3"), 256);
  EXPECT_EQ(value("3*2^2"), 12);
}

TEST_F(NamedFormulas, RelationsAndTruthsAreOperators) {
  EXPECT_EQ(value("1 EQ 1.00000001"), 1);
  EXPECT_EQ(value("1 EQ 1.0001"), 0);
  EXPECT_EQ(value("1 NE 1.0001"), 1);
  EXPECT_EQ(value("2 GT 1+1"), 0);
  EXPECT_EQ(value("2 GE 1+1"), 1);
  EXPECT_EQ(value("1 LT 2 AND 3 LE 2"), 0);
  EXPECT_EQ(value("1 LT 2 OR 3 LE 2"), 1);
  EXPECT_EQ(value("1 LT 2 XOR 3 GE 2"), 0);
  EXPECT_EQ(value("5 AND -3"), 1);
  EXPECT_EQ(value("0 OR 0"), 0);
  EXPECT_EQ(value("3 LT 2 LT 1"), 1);  // 0 LT 1
  EXPECT_TRUE(holds("[#<_x> GT 12 AND #<a b> LT 0]"));
  EXPECT_FALSE(holds(" [0]"));
}

TEST_F(NamedFormulas, FunctionsTakeTheirArguments) {
  EXPECT_EQ(value("FIX[-2.5]"), -3);
  EXPECT_EQ(value("FUP[-2.5]"), -2);
  EXPECT_EQ(value("ROUND[-2.5]"), -3);
  EXPECT_EQ(value("ATAN[-1]/[-1]"), -135);
  EXPECT_EQ(value("atan [1] / [1] * 2"), 90);
  EXPECT_EQ(value("POW[2,10]"), 1024);
  EXPECT_EQ(value("ANGLE[1]"), 45);
  EXPECT_EQ(value("ANGLE[1]/3"), 15);
  EXPECT_EQ(value("ANGLE[1]/[-1]"), 135);
  EXPECT_EQ(value("ANGLE[1,-1]/[3]"), 45);
  EXPECT_EQ(value("SIN[30]"), 0.5);
  EXPECT_EQ(value("EXISTS[#<_x>]+EXISTS[#<nope>]"), 1);
}

TEST_F(NamedFormulas, VariablesAreReadByTheControl) {
  EXPECT_EQ(value("#<_x>*2"), 25);
  EXPECT_EQ(value("-#<a b>"), 2);
  EXPECT_EQ(faultOf("1+#<nope>").begin, 2u);
}

TEST_F(NamedFormulas, AFormulaEndsWhereNothingOfItStands) {
  EXPECT_EQ(value("1+2 X3"), 3);
  EXPECT_EQ(end_, 3u);
  EXPECT_EQ(value("6 // 2"), 6);
  EXPECT_EQ(end_, 1u);
  FormulaLanguage blanks = kNamed;
  blanks.rules.takes_blanks = true;
  EXPECT_EQ(value("6  // 2", blanks), 6);
  EXPECT_EQ(end_, 3u);
  EXPECT_EQ(value("1+(two)2"), 3);
  blanks.rules.comments = false;
  EXPECT_EQ(faultOf("1+(two)2", blanks).kind, FormulaFault::Kind::kNoOperand);
}

TEST_F(NamedFormulas, FaultsNameTheirPlace) {
  using Kind = FormulaFault::Kind;
  const auto is = [&](const std::string& text, Kind kind, std::size_t begin) {
    const FormulaFault fault = faultOf(text);
    EXPECT_EQ(fault.kind, kind) << text;
    EXPECT_EQ(fault.begin, begin) << text;
  };
  is("1+", Kind::kNoOperand, 2);
  is("1+ ]", Kind::kNoOperand, 3);
  is("2*[1+3", Kind::kNoBracket, 2);
  is("1.2.3", Kind::kSecondPoint, 0);
  is("1+.", Kind::kNoDigits, 2);
  is("1" + std::string(400, '0'), Kind::kBeyondRange, 0);
  is("1+SIN 30", Kind::kNoArgument, 2);
  is("1+ATAN[1]", Kind::kNoSecond, 2);
  is("1+POW[1]/[2]", Kind::kNoSecond, 2);
  is("1+SQRT[-1]", Kind::kFunction, 2);
  is("1+ 5/0", Kind::kOperation, 3);
  is("9^999", Kind::kOperation, 0);
  EXPECT_EQ(faultOf("1+LN[-2]").argument, -2);
  EXPECT_EQ(faultOf("1+LN[-2]").name, "LN");
  EXPECT_EQ(*Refusal(faultOf("5 MOD 0").refusal), SharedAlarm::kDivision);
}

TEST_F(NamedFormulas, NestingHasALimit) {
  const auto nested = [](int depth) { return std::string(depth, '[') + "1" + std::string(depth, ']'); };
  EXPECT_EQ(value(nested(19)), 1);
  EXPECT_EQ(faultOf(nested(20)).kind, FormulaFault::Kind::kTooDeep);
  FormulaLanguage brackets = kNamed;
  brackets.rules.depth = FormulaDepth::kBrackets;
  EXPECT_EQ(value(nested(20), brackets), 1);
  EXPECT_EQ(faultOf(nested(21), brackets).begin, 20u);
  EXPECT_EQ(value(std::string(20, '-') + "1", brackets), 1);
  EXPECT_EQ(faultOf(std::string(21, '-') + "1", brackets).begin, 20u);
}

TEST_F(NamedFormulas, SignsAndNumbersGoByTheRules) {
  EXPECT_EQ(value("- -+2"), 2);
  FormulaLanguage one = kNamed;
  one.rules.many_signs = false;
  EXPECT_EQ(value("-2", one), -2);
  EXPECT_EQ(faultOf("--2", one).begin, 1u);
  one.rules.point_ends = true;
  EXPECT_EQ(value("1.2.3", one), 1.2);
  EXPECT_EQ(end_, 3u);
  one.rules.refuses_zero = one.rules.refuses_infinite = false;
  EXPECT_TRUE(std::isinf(value("1/0", one)));
}

TEST_F(NamedFormulas, VacantValuesGoByTheRules) {
  FormulaLanguage language = kNamed;
  EXPECT_TRUE(holds("[#<null> EQ 0]"));
  language.rules.vacant = VacantRelation::kAboveAll;
  EXPECT_FALSE(holds("[#<null> EQ 0]", language));
  EXPECT_TRUE(holds("[#<null> EQ #<null>]", language));
  EXPECT_TRUE(holds("[#<null> GT 100000]", language));
  // The table of Fanuc-like controls: EQ and NE tell vacant from 0, the others do not.
  language.rules.vacant = VacantRelation::kOnlyEqual;
  language.rules.whole_conditions = false;
  language.rules.formula_rank = 2;
  const std::map<std::string, bool> table{{"EQ #<null>", true}, {"EQ 0", false}, {"NE #<null>", false},
                                          {"NE 0", true},       {"GE 0", true},  {"GT 0", false},
                                          {"LE 0", true},       {"LT 0", false}};
  for (const auto& [what, expected] : table) EXPECT_EQ(holds("[#<null> " + what + "]", language), expected);
  EXPECT_EQ(value("1+1 EQ 2", language), 2);  // the relation is none of a formula's operators
  EXPECT_EQ(end_, 3u);
}

// The formulas of #n variables serve another language by another table alone.
class NoEnvironment : public MacroEnvironment {
 public:
  int axisNumber(std::string_view) const override { return -1; }
  ParameterAnswer parameter(int, int, int) const override { return {}; }
};

TEST(MacroEvaluator, TakesTheTableOfAnotherControl) {
  static constexpr auto kFanucFunctions = std::to_array<FormulaFunction>({
      {"ATAN", arcTangent, arcTangentOf, "/,"},
      {"SQRT", squareRoot},
      {"SQR", squareRoot},
      {"ROUND", nearest},
      {"POW", nullptr, [](double x, double y, double& out) { return out = std::pow(x, y), Refusal(); }, ","},
  });
  static constexpr auto kFanucOperators = std::to_array<FormulaOperator>({
      {"+", 3, Operation::kAdd},
      {"-", 3, Operation::kSubtract},
      {"OR", 3, Operation::kBitOr},
      {"*", 4, Operation::kMultiply},
      {"/", 4, Operation::kDivide},
      {"EQ", 1, Operation::kEqual},
      {"LT", 1, Operation::kLess},
      {"&&", 0, Operation::kAnd},
  });
  static constexpr FormulaLanguage kFanuc{[] {
                                            FormulaRules out;
                                            out.formula_rank = 3;
                                            out.whole_conditions = true;
                                            out.vacant = VacantRelation::kOnlyEqual;
                                            return out;
                                          }(),
                                          FormulaRows(kFanucOperators), FormulaRows(kFanucFunctions)};
  VariableStore store;
  const NoEnvironment environment;
  MacroEvaluator macro(store, environment, nctAlarms(), kFanuc);
  LexError error;
  const auto value = [&](const std::string& text) {
    std::size_t pos = 0;
    Value out;
    EXPECT_TRUE(macro.formula(text, pos, out, error)) << text << ": " << error.message;
    EXPECT_EQ(pos, text.size());
    return out.number;
  };
  std::size_t pos = 0;
  ASSERT_TRUE(macro.assign("#1=SQR[16]+SQRT 9", pos, error));
  EXPECT_EQ(value("#1"), 7);
  EXPECT_EQ(value("5 OR 3+1"), 8);
  EXPECT_EQ(value("ATAN[-1]/[-1]"), -135);
  EXPECT_EQ(value("ATAN[1,-1]"), 135);
  EXPECT_EQ(value("ATAN[1]"), 45);
  EXPECT_EQ(value("POW[#1,2]"), 49);
  bool holds = false;
  pos = 0;
  EXPECT_TRUE(macro.condition("[[#1 EQ 7] && [#2 LT 1]]", pos, holds, error));
  EXPECT_TRUE(holds);
  pos = 0;
  EXPECT_TRUE(macro.condition("[[#1 EQ 7] && [#2 EQ 0]]", pos, holds, error));
  EXPECT_FALSE(holds);
  Value out;
  pos = 0;
  EXPECT_FALSE(macro.formula("AXNUM[X]", pos, out, error));
}

/// Evaluates a list of operands and operators by taking out the operator that binds closest, time and again.
class SlowFormula {
 public:
  struct Part {
    std::string op;  ///< in front of the operand; empty: the first one
    double value = 0.0;
  };
  static int rankOf(const std::string& op) {
    static const std::map<std::string, int> kRanks{{"AND", 0}, {"OR", 0},  {"XOR", 0}, {"EQ", 1}, {"NE", 1},
                                                   {"LT", 1},  {"GE", 1},  {"+", 2},   {"-", 2},  {"*", 3},
                                                   {"/", 3},   {"MOD", 3}, {"**", 4}};
    return kRanks.at(op);
  }
  static double valueOf(std::vector<Part> parts) {
    for (int rank = 4; rank >= 0; --rank) {
      for (std::size_t k = 1; k < parts.size();) {
        if (rankOf(parts[k].op) != rank) {
          ++k;
          continue;
        }
        parts[k - 1].value = made(parts[k].op, parts[k - 1].value, parts[k].value);
        parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(k));
      }
    }
    return parts.front().value;
  }

 private:
  static double made(const std::string& op, double a, double b) {
    if (op == "+") return a + b;
    if (op == "-") return a - b;
    if (op == "*") return a * b;
    if (op == "/") return a / b;
    if (op == "**") return std::pow(a, b);
    if (op == "MOD") return std::fmod(a, b) < 0.0 ? std::fmod(a, b) + std::abs(b) : std::fmod(a, b);
    const bool same = a == b || std::abs(a - b) < 1e-6;
    if (op == "EQ") return same ? 1 : 0;
    if (op == "NE") return same ? 0 : 1;
    if (op == "LT") return a < b && !same ? 1 : 0;
    if (op == "GE") return a > b || same ? 1 : 0;
    const bool p = a != 0.0, q = b != 0.0;
    return (op == "AND" ? p && q : op == "OR" ? p || q : p != q) ? 1 : 0;
  }
};

/// A random formula of small whole numbers, as text and with the value that SlowFormula gives it.
class RandomFormula {
 public:
  explicit RandomFormula(unsigned seed) : random_(seed) {}
  struct Made {
    std::string text;
    double value = 0.0;
  };
  Made make(int depth) {
    static const std::vector<std::string> kOps{"AND", "OR", "XOR", "EQ", "NE",  "LT", "GE",
                                               "+",   "-",  "*",   "/",  "MOD", "**"};
    std::vector<SlowFormula::Part> parts;
    std::string text;
    const int count = 1 + pick(5);
    for (int k = 0; k < count; ++k) {
      SlowFormula::Part part;
      if (k > 0) part.op = kOps[static_cast<std::size_t>(pick(static_cast<int>(kOps.size())))];
      const Made operand = depth > 0 && pick(3) == 0 ? inner(depth) : whole();
      part.value = operand.value;
      text += blanks() + part.op + blanks() + operand.text;
      parts.push_back(part);
    }
    return {text, SlowFormula::valueOf(parts)};
  }

 private:
  int pick(int below) { return static_cast<int>(random_() % static_cast<unsigned>(below)); }
  std::string blanks() { return std::string(static_cast<std::size_t>(pick(2)), ' '); }
  Made whole() {
    const int n = pick(9);
    return pick(4) == 0 ? Made{fmt::format("-{}", n), -1.0 * n} : Made{fmt::format("{}", n), 1.0 * n};
  }
  Made inner(int depth) {
    const Made made = make(depth - 1);
    if (pick(2) == 0) return {"[" + made.text + "]", made.value};
    return {"ABS[" + made.text + "]", std::abs(made.value)};
  }
  std::mt19937 random_;
};

TEST_F(NamedFormulas, RandomOnesHaveTheValueOfASlowEvaluator) {
  FormulaLanguage language = kNamed;
  language.rules.refuses_zero = language.rules.refuses_infinite = false;
  RandomFormula random(20);
  int finite = 0;
  for (int k = 0; k < 20000; ++k) {
    const RandomFormula::Made made = random.make(3);
    const double got = value(made.text, language);
    EXPECT_EQ(end_, made.text.size()) << made.text;
    if (!std::isfinite(made.value)) continue;
    ++finite;
    EXPECT_NEAR(got, made.value, 1e-9 * std::max(1.0, std::abs(made.value))) << made.text;
  }
  EXPECT_GT(finite, 10000);
}

}  // namespace
}  // namespace proveout::nc
