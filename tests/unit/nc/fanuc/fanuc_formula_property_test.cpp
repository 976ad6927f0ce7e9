// Random formulas and conditions of custom macro B against an evaluator that reads tokens by a grammar
// written down here: ranks, null values, functions. Proves fan-12-expr fan-12-func fan-12-logic fan-12-cond
// fan-12-nullrules
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "core/nc/fanuc/alarms.h"
#include "core/nc/fanuc/macro/formulas.h"
#include "core/nc/macro/expression.h"

namespace proveout {
namespace {

using nc::LexError;
using nc::MacroEvaluator;
using nc::Value;
using nc::VariableStore;

class Nothing : public nc::MacroEnvironment {
 public:
  int axisNumber(std::string_view) const override { return -1; }
  ParameterAnswer parameter(int, int, int) const override { return {nc::SharedAlarm::kOutOfRange, "N", 0.0}; }
};

constexpr int kVariables = 20;
constexpr double kDegree = M_PI / 180.0;
using Variables = std::vector<std::optional<double>>;

/// One token of a formula and what it stands for.
struct Token {
  enum class Kind { kNumber, kVariable, kOperator, kFunction, kOpen, kClose, kSlash2 } kind;
  std::string text;
  double number = 0.0;
  int variable = 0;
};
using Tokens = std::vector<Token>;
struct Refused {};

/// Reads tokens: sums of products of operands, from left to right.
class Reference {
 public:
  Reference(const Tokens& tokens, const Variables& variables) : tokens_(tokens), variables_(variables) {}

  std::optional<double> sum() {
    std::optional<double> left = product();
    while (isOne({"+", "-", "OR", "XOR"})) {
      const std::string op = tokens_[at_++].text;
      const std::optional<double> right = product();
      left = apply(op, left.value_or(0.0), right.value_or(0.0));
    }
    return left;
  }
  bool relation() {
    const std::optional<double> left = sum();
    const std::string op = tokens_[at_++].text;
    const std::optional<double> right = sum();
    if (op == "EQ") return left.has_value() == right.has_value() && left.value_or(0.0) == right.value_or(0.0);
    if (op == "NE")
      return !(left.has_value() == right.has_value() && left.value_or(0.0) == right.value_or(0.0));
    const double a = left.value_or(0.0), b = right.value_or(0.0);
    return op == "GT" ? a > b : op == "GE" ? a >= b : op == "LT" ? a < b : a <= b;
  }
  bool done() const { return at_ == tokens_.size(); }

 private:
  bool isOne(std::initializer_list<const char*> words) const {
    if (at_ >= tokens_.size() || tokens_[at_].kind != Token::Kind::kOperator) return false;
    for (const char* word : words) {
      if (tokens_[at_].text == word) return true;
    }
    return false;
  }
  std::optional<double> product() {
    std::optional<double> left = operand();
    while (isOne({"*", "/", "AND", "MOD"})) {
      const std::string op = tokens_[at_++].text;
      const std::optional<double> right = operand();
      left = apply(op, left.value_or(0.0), right.value_or(0.0));
    }
    return left;
  }
  static double bits(const std::string& op, double a, double b) {
    const double x = std::floor(std::abs(a) + 0.5) * (a < 0 ? -1 : 1);
    const double y = std::floor(std::abs(b) + 0.5) * (b < 0 ? -1 : 1);
    if (std::abs(x) > 4294967295.0 || std::abs(y) > 4294967295.0) throw Refused();
    const auto p = static_cast<std::int32_t>(static_cast<std::int64_t>(x));
    const auto q = static_cast<std::int32_t>(static_cast<std::int64_t>(y));
    return op == "AND" ? p & q : op == "OR" ? p | q : p ^ q;
  }
  static double apply(const std::string& op, double a, double b) {
    if ((op == "/" || op == "MOD") && b == 0.0) throw Refused();
    const double out = op == "+"     ? a + b
                       : op == "-"   ? a - b
                       : op == "*"   ? a * b
                       : op == "/"   ? a / b
                       : op == "MOD" ? a - b * std::trunc(a / b)
                                     : bits(op, a, b);
    if (!std::isfinite(out)) throw Refused();
    return op == "MOD" ? std::fmod(a, b) : out;
  }
  std::optional<double> operand() {
    const Token& token = tokens_[at_++];
    switch (token.kind) {
      case Token::Kind::kOperator: {  // a sign
        const double value = operand().value_or(0.0);
        return token.text == "-" ? -value : value;
      }
      case Token::Kind::kNumber:
        return token.number;
      case Token::Kind::kVariable:
        return variables_[static_cast<std::size_t>(token.variable)];
      case Token::Kind::kOpen: {
        const std::optional<double> value = sum();
        ++at_;
        return value;
      }
      default:
        break;
    }
    ++at_;  // [
    const double x = sum().value_or(0.0);
    ++at_;  // ]
    return function(token.text, x);
  }
  double function(const std::string& name, double x) {
    double out = 0.0;
    if (name == "ABS") out = std::abs(x);
    if (name == "FIX") out = x < 0 ? std::ceil(x) : std::floor(x);
    if (name == "FUP") out = x < 0 ? std::floor(x) : std::ceil(x);
    if (name == "ROUND") out = x < 0 ? std::ceil(x - 0.5) : std::floor(x + 0.5);
    if (name == "SQRT" && x < 0) throw Refused();
    if (name == "SQRT") out = std::sqrt(x);
    if (name == "LN" && x <= 0) throw Refused();
    if (name == "LN") out = std::log(x);
    if (name == "EXP") out = std::exp(x);
    if (name == "SIN") out = std::sin(x * kDegree);
    if (name == "COS") out = std::cos(x * kDegree);
    if (name == "ATAN") {
      if (at_ < tokens_.size() && tokens_[at_].text == "/" && at_ + 1 < tokens_.size() &&
          tokens_[at_ + 1].kind == Token::Kind::kOpen) {
        at_ += 2;
        const double y = sum().value_or(0.0);
        ++at_;
        out = std::atan2(x, y) / kDegree;
        if (out < 0) out += 360;
      } else {
        out = std::atan(x) / kDegree;
      }
    }
    if (!std::isfinite(out)) throw Refused();
    return out;
  }

  const Tokens& tokens_;
  const Variables& variables_;
  std::size_t at_ = 0;
};

class Maker {
 public:
  explicit Maker(unsigned seed) : random_(seed) {}

  int pick(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  void formula(int depth, Tokens& out) {
    operand(depth, out);
    for (int more = pick(3); more > 0; --more) {
      static const char* const kOperators[] = {"+", "-", "*", "/", "MOD", "AND", "OR", "XOR"};
      out.push_back({Token::Kind::kOperator, kOperators[pick(8)]});
      operand(depth, out);
    }
  }
  void relation(int depth, Tokens& out) {
    static const char* const kRelations[] = {"EQ", "NE", "GT", "GE", "LT", "LE"};
    formula(depth, out);
    out.push_back({Token::Kind::kOperator, kRelations[pick(6)]});
    formula(depth, out);
  }
  std::string textOf(const Tokens& tokens) {
    std::string text;
    for (const Token& token : tokens) {
      const bool word = token.kind == Token::Kind::kOperator && std::isalpha(token.text[0]);
      if (pick(3) == 0 || (word && pick(2))) text += ' ';
      text += token.text;
    }
    return text;
  }

 private:
  void bracket(int depth, Tokens& out) {
    out.push_back({Token::Kind::kOpen, "["});
    formula(depth - 1, out);
    out.push_back({Token::Kind::kClose, "]"});
  }
  void operand(int depth, Tokens& out) {
    if (pick(8) == 0) out.push_back({Token::Kind::kOperator, pick(2) ? "-" : "+"});
    const int kind = depth > 0 ? pick(6) : pick(3);
    if (kind == 0) {
      const double value = pick(400) / 8.0;
      out.push_back({Token::Kind::kNumber, fmt::format("{}", value), value});
    } else if (kind <= 2) {
      const int n = 1 + pick(kVariables);
      out.push_back({Token::Kind::kVariable, fmt::format("#{}", n), 0.0, n});
    } else if (kind == 3) {
      bracket(depth, out);
    } else {
      static const char* const kFunctions[] = {"ABS", "FIX", "FUP", "ROUND", "SQRT", "LN",
                                               "EXP", "SIN", "COS", "ATAN",  "ATAN"};
      const int which = pick(11);
      out.push_back({Token::Kind::kFunction, kFunctions[which]});
      bracket(depth, out);
      if (which < 10) return;
      out.push_back({Token::Kind::kSlash2, "/"});
      bracket(depth, out);
    }
  }
  std::mt19937 random_;
};

class FanucFormulaProperties : public testing::Test {
 protected:
  FanucFormulaProperties() : variables_(kVariables + 1) {
    for (int n = 1; n <= kVariables; ++n) {
      if (n % 4 == 0) continue;  // null
      variables_[static_cast<std::size_t>(n)] =
          n % 4 == 1 ? maker_.pick(20) - 10 : (maker_.pick(800) - 400) / 16.0;
      store_.write(n, {*variables_[static_cast<std::size_t>(n)]});
    }
  }
  Maker maker_{2026};
  Variables variables_;
  VariableStore store_;
  Nothing environment_;
  MacroEvaluator macro_{store_, environment_, nc::fanucAlarms(), nc::fanucFormulas()};
};

TEST_F(FanucFormulaProperties, RandomFormulasHaveTheirValue) {
  int values = 0;
  for (int k = 0; k < 20000; ++k) {
    Tokens tokens;
    maker_.formula(4, tokens);
    const std::string text = maker_.textOf(tokens);
    std::optional<double> expected;
    bool refused = false;
    try {
      Reference reference(tokens, variables_);
      expected = reference.sum();
      ASSERT_TRUE(reference.done()) << text;
    } catch (const Refused&) {
      refused = true;
    }
    Value value;
    LexError error;
    std::size_t pos = 0;
    const bool good = macro_.formula(text, pos, value, error);
    // Cosines of round angles are exactly 0 here and nearly so there.
    const bool angles = text.find("SIN") != std::string::npos || text.find("COS") != std::string::npos;
    if (good == refused && angles) continue;
    ASSERT_EQ(good, !refused) << text << ": " << error.message;
    if (!good) continue;
    ++values;
    ASSERT_EQ(value.vacant, !expected.has_value()) << text;
    const double number = expected.value_or(0.0);
    // Sines of round angles are exact here and nearly so there: what a bit operation or a rounding makes of
    // the difference is not compared.
    const bool close = std::abs(value.number - number) <= 1e-9 * std::max(1.0, std::abs(number));
    const bool jumps = text.find("FIX") != std::string::npos || text.find("FUP") != std::string::npos ||
                       text.find("ROUND") != std::string::npos || text.find("MOD") != std::string::npos ||
                       text.find("AND") != std::string::npos || text.find("OR") != std::string::npos ||
                       text.find("ATAN") != std::string::npos || text.find("EXP") != std::string::npos;
    ASSERT_TRUE(close || (jumps && angles)) << text << ": " << value.number << " and " << number;
  }
  EXPECT_GT(values, 8000);
}

TEST_F(FanucFormulaProperties, RandomConditionsHoldAsTheyShould) {
  int asked = 0;
  for (int k = 0; k < 20000; ++k) {
    // One relation, or several in brackets of their own joined by one operator, or bare ones joined.
    const int parts = 1 + maker_.pick(3);
    const char* const join = maker_.pick(2) ? "AND" : "OR";
    const bool wrapped = maker_.pick(2) == 0;
    std::string text = "[";
    bool expected = false, refused = false;
    for (int part = 0; part < parts; ++part) {
      Tokens tokens;
      maker_.relation(1, tokens);
      if (part > 0) text += fmt::format(" {} ", join);
      text += wrapped ? "[" + maker_.textOf(tokens) + "]" : maker_.textOf(tokens);
      // AND and OR inside of a bare relation that is joined would be read as joining.
      if (!wrapped && parts > 1) {
        for (const Token& t : tokens)
          refused = refused || t.text == "AND" || t.text == "OR" || t.text == "XOR";
      }
      try {
        Reference reference(tokens, variables_);
        const bool holds = reference.relation();
        expected = part == 0                         ? holds
                   : std::string_view(join) == "AND" ? expected && holds
                                                     : expected || holds;
      } catch (const Refused&) {
        refused = true;
      }
    }
    text += "]";
    if (refused || text.find("SIN") != std::string::npos || text.find("COS") != std::string::npos) continue;
    ++asked;
    bool holds = false;
    LexError error;
    std::size_t pos = 0;
    ASSERT_TRUE(macro_.condition(text, pos, holds, error)) << text << ": " << error.message;
    ASSERT_EQ(holds, expected) << text;
    ASSERT_EQ(pos, text.size());
  }
  EXPECT_GT(asked, 4000);
}

// Bad text is refused with a place, whatever it is.
TEST_F(FanucFormulaProperties, CutAndChangedFormulasNeverCrash) {
  for (int k = 0; k < 20000; ++k) {
    Tokens tokens;
    maker_.formula(3, tokens);
    std::string text = maker_.textOf(tokens);
    static constexpr std::string_view kOdd = "[]#/*-+.,( )ENAT0129=_";
    for (int change = maker_.pick(4); change > 0 && !text.empty(); --change) {
      const auto at = static_cast<std::size_t>(maker_.pick(static_cast<int>(text.size())));
      if (maker_.pick(2))
        text.erase(at, 1);
      else
        text.insert(at, 1, kOdd[static_cast<std::size_t>(maker_.pick(static_cast<int>(kOdd.size())))]);
    }
    Value value;
    LexError error;
    std::size_t pos = 0;
    if (macro_.formula(text, pos, value, error)) {
      ASSERT_TRUE(std::isfinite(value.number)) << text;
    } else {
      ASSERT_FALSE(error.code.empty()) << text;
      ASSERT_GE(error.columns.end, error.columns.begin) << text;
    }
    bool holds = false;
    pos = 0;
    macro_.condition("[" + text + "]", pos, holds, error);
  }
}

}  // namespace
}  // namespace proveout
