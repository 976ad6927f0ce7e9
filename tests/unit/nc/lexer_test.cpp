#include "core/nc/lexer.h"

#include <gtest/gtest.h>

#include <cmath>

namespace proveout::nc {
namespace {

TEST(Lexer, SplitsWordsWithoutBlanks) {
  Lexer lexer{LexRules{}};
  Block block;
  ASSERT_TRUE(lexer.lex("n120g1x-12.5y+.75z7", block));
  EXPECT_EQ(block.number, 120);
  ASSERT_EQ(block.words.size(), 4u);
  EXPECT_EQ(block.find('X')->value, -12.5);
  EXPECT_EQ(block.find('Y')->value, 0.75);
  EXPECT_EQ(block.find('Z')->value, 7.0);
  EXPECT_EQ(block.find('X')->columns.begin, 7);
  EXPECT_EQ(block.find('X')->columns.end, 13);
}

TEST(Lexer, ReadsFifteenDigitsExactly) {
  Lexer lexer{LexRules{}};
  Block block;
  ASSERT_TRUE(lexer.lex("X0.123456789012345 Y123456.789012345 Z0.1", block));
  EXPECT_EQ(block.find('X')->value, 0.123456789012345);
  EXPECT_EQ(block.find('Y')->value, 123456.789012345);
  EXPECT_EQ(block.find('Z')->value, 0.1);
}

TEST(Lexer, RoundsLongerFractionsToTheNearestDouble) {
  Lexer lexer{LexRules{}};
  Block block;
  ASSERT_TRUE(lexer.lex("X1.2345678901234567890123 Y.00000000000000000001", block));
  EXPECT_EQ(block.find('X')->value, 1.2345678901234567890123);
  EXPECT_EQ(block.find('Y')->value, 1e-20);
}

TEST(Lexer, MinusZeroIsZero) {
  Lexer lexer{LexRules{}};
  Block block;
  ASSERT_TRUE(lexer.lex("X-0.000", block));
  EXPECT_FALSE(std::signbit(block.find('X')->value));
}

TEST(Lexer, OperatorIBelongsToTheAddressBeforeIt) {
  Lexer lexer{LexRules{}};
  Block block;
  ASSERT_TRUE(lexer.lex("XI-40 I30", block));
  EXPECT_TRUE(block.find('X')->incremental);
  EXPECT_EQ(block.find('X')->value, -40);
  EXPECT_EQ(block.find('I')->value, 30);
}

TEST(Lexer, CommaAddressesAreTheirOwn) {
  Lexer lexer{LexRules{}};
  Block block;
  ASSERT_TRUE(lexer.lex("G1 X1 R5 ,R2 , C3,A-30", block));
  EXPECT_EQ(block.find('R')->value, 5);
  EXPECT_EQ(block.find(kCommaRounding)->value, 2);
  EXPECT_EQ(block.find(kCommaChamfer)->value, 3);
  EXPECT_EQ(block.find(kCommaDirection)->value, -30);
}

TEST(Lexer, CommentsGoOnOverLines) {
  Lexer lexer{LexRules{}};
  Block block;
  ASSERT_TRUE(lexer.lex("X1 (from here", block));
  EXPECT_EQ(block.words.size(), 1u);
  ASSERT_TRUE(lexer.lex("X2", block));
  EXPECT_TRUE(block.empty());
  ASSERT_TRUE(lexer.lex("to here) X3", block));
  EXPECT_EQ(block.find('X')->value, 3);
}

TEST(Lexer, ErrorsNameTheColumns) {
  Lexer lexer{LexRules{}};
  Block block;
  EXPECT_FALSE(lexer.lex("G0 X1 Y$", block));
  EXPECT_EQ(lexer.error().code, "nct-2064");
  EXPECT_EQ(lexer.error().columns.begin, 7);
  EXPECT_FALSE(lexer.lex("G0 X1 X2", block));
  EXPECT_EQ(lexer.error().code, "nct-duplicate-word");
  EXPECT_EQ(lexer.error().columns.begin, 7);
}

class FixedExpression : public ExpressionHook {
 public:
  bool evaluate(std::string_view text, std::size_t& pos, double& value, std::string& message) override {
    if (text[pos] != '#') {
      message = "only variables";
      return false;
    }
    ++pos;
    value = 0;
    while (pos < text.size() && text[pos] >= '0' && text[pos] <= '9')
      value = value * 10 + (text[pos++] - '0');
    value *= 2;
    return true;
  }
};

TEST(Lexer, ExpressionHookGivesValues) {
  FixedExpression hook;
  LexRules rules;
  rules.expressions = &hook;
  Lexer lexer(rules);
  Block block;
  ASSERT_TRUE(lexer.lex("G1 X#21 Y3", block));
  EXPECT_EQ(block.find('X')->value, 42);
  EXPECT_EQ(block.find('Y')->value, 3);
  EXPECT_FALSE(lexer.lex("X[1]", block));
  EXPECT_EQ(lexer.error().message, "only variables");
}

TEST(Lexer, NoLineCrashesIt) {
  Lexer lexer{LexRules{}};
  Block block;
  unsigned seed = 12345;
  for (int round = 0; round < 20000; ++round) {
    std::string line;
    for (int k = 0; k < 12; ++k) {
      seed = seed * 1664525u + 1013904223u;
      line += "XGNMO/(),.-+I0123456789 %<>=#[;\x80"[(seed >> 16) % 33];
    }
    lexer.setInComment(false);
    if (lexer.lex(line, block)) continue;
    EXPECT_FALSE(lexer.error().message.empty()) << line;
    EXPECT_GE(lexer.error().columns.begin, 1) << line;
    EXPECT_LE(lexer.error().columns.end, static_cast<int>(line.size()) + 2) << line;
  }
}

}  // namespace
}  // namespace proveout::nc
