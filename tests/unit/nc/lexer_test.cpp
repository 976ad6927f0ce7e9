#include "core/nc/text/lexer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/nc/nct/alarms.h"

namespace proveout::nc {
namespace {

TEST(Lexer, SplitsWordsWithoutBlanks) {
  Lexer lexer{LexRules{}, nctAlarms()};
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
  Lexer lexer{LexRules{}, nctAlarms()};
  Block block;
  ASSERT_TRUE(lexer.lex("X0.123456789012345 Y123456.789012345 Z0.1", block));
  EXPECT_EQ(block.find('X')->value, 0.123456789012345);
  EXPECT_EQ(block.find('Y')->value, 123456.789012345);
  EXPECT_EQ(block.find('Z')->value, 0.1);
}

TEST(Lexer, RoundsLongerFractionsToTheNearestDouble) {
  Lexer lexer{LexRules{}, nctAlarms()};
  Block block;
  ASSERT_TRUE(lexer.lex("X1.2345678901234567890123 Y.00000000000000000001", block));
  EXPECT_EQ(block.find('X')->value, 1.2345678901234567890123);
  EXPECT_EQ(block.find('Y')->value, 1e-20);
}

TEST(Lexer, MinusZeroIsZero) {
  Lexer lexer{LexRules{}, nctAlarms()};
  Block block;
  ASSERT_TRUE(lexer.lex("X-0.000", block));
  EXPECT_FALSE(std::signbit(block.find('X')->value));
}

TEST(Lexer, OperatorIBelongsToTheAddressBeforeIt) {
  Lexer lexer{LexRules{}, nctAlarms()};
  Block block;
  ASSERT_TRUE(lexer.lex("XI-40 I30", block));
  EXPECT_TRUE(block.find('X')->incremental);
  EXPECT_EQ(block.find('X')->value, -40);
  EXPECT_EQ(block.find('I')->value, 30);
}

TEST(Lexer, CommaAddressesAreTheirOwn) {
  Lexer lexer{LexRules{}, nctAlarms()};
  Block block;
  ASSERT_TRUE(lexer.lex("G1 X1 R5 ,R2 , C3,A-30", block));
  EXPECT_EQ(block.find('R')->value, 5);
  EXPECT_EQ(block.find(kCommaRounding)->value, 2);
  EXPECT_EQ(block.find(kCommaChamfer)->value, 3);
  EXPECT_EQ(block.find(kCommaDirection)->value, -30);
}

TEST(Lexer, CommentsGoOnOverLines) {
  Lexer lexer{LexRules{}, nctAlarms()};
  Block block;
  ASSERT_TRUE(lexer.lex("X1 (from here", block));
  EXPECT_EQ(block.words.size(), 1u);
  ASSERT_TRUE(lexer.lex("X2", block));
  EXPECT_TRUE(block.empty());
  ASSERT_TRUE(lexer.lex("to here) X3", block));
  EXPECT_EQ(block.find('X')->value, 3);
}

TEST(Lexer, ErrorsNameTheColumns) {
  Lexer lexer{LexRules{}, nctAlarms()};
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
  bool evaluate(std::string_view text, std::size_t& pos, Value& out, LexError& error) override {
    if (text[pos] == '[' && pos + 1 < text.size()) {
      ++pos;
      if (!evaluate(text, pos, out, error)) return false;
      ++pos;  // ']'
      return true;
    }
    if (text[pos] != '#') {
      error = {"nct-2064", "only variables", {}};
      return false;
    }
    ++pos;
    double value = 0;
    while (pos < text.size() && text[pos] >= '0' && text[pos] <= '9')
      value = value * 10 + (text[pos++] - '0');
    out = {value * 2, value == 0};
    return true;
  }
};

TEST(Lexer, ExpressionHookGivesValues) {
  FixedExpression hook;
  LexRules rules;
  rules.expressions = &hook;
  Lexer lexer(rules, nctAlarms());
  Block block;
  ASSERT_TRUE(lexer.lex("G1 X#21 Y3", block));
  EXPECT_EQ(block.find('X')->value, 42);
  EXPECT_EQ(block.find('Y')->value, 3);
  EXPECT_FALSE(lexer.lex("X[1]", block));
  EXPECT_EQ(lexer.error().message, "only variables");
}

TEST(Lexer, AVacantValueLeavesTheWordOut) {
  FixedExpression hook;
  LexRules rules;
  rules.expressions = &hook;
  Lexer lexer(rules, nctAlarms());
  Block block;
  ASSERT_TRUE(lexer.lex("G90 X20 Y#0", block));
  EXPECT_EQ(block.find('Y'), nullptr);
  EXPECT_EQ(block.words.size(), 2u);
  ASSERT_TRUE(lexer.lex("X#5", block));
  EXPECT_TRUE(block.find('X')->from_expression);
  EXPECT_FALSE(lexer.lex("M-1", block)) << "plain numbers keep their rules";
  EXPECT_FALSE(lexer.lex("N#3 X1", block)) << "a block number is no formula";
}

TEST(Lexer, TellsStatementsFromBlocks) {
  using enum LineKind;
  for (const auto& [text, kind] :
       std::initializer_list<std::pair<const char*, LineKind>>{{"#100=1", kAssignment},
                                                               {"IF[#1EQ2] GOTO3", kIf},
                                                               {"if[#1]", kIf},
                                                               {"WHILE[#1LT2] DO1", kWhile},
                                                               {"DO1", kDo},
                                                               {"END1", kEnd},
                                                               {"GOTO5", kGoto},
                                                               {"DPRNT[X]", kOutput},
                                                               {"BPRNT[]", kOutput},
                                                               {"POPEN", kOutput},
                                                               {"PCLOS", kOutput},
                                                               {"FOPEN1", kOutput},
                                                               {"FCLOS", kOutput},
                                                               {"G0 X1", kBlock},
                                                               {"I5", kBlock},
                                                               {"D1", kBlock},
                                                               {"F100", kBlock},
                                                               {"", kBlock},
                                                               {"W1", kBlock},
                                                               {"P1", kBlock}}) {
    EXPECT_EQ(classify(text, 0), kind) << text;
  }
  FixedExpression hook;
  LexRules rules;
  rules.expressions = &hook;
  Lexer lexer(rules, nctAlarms());
  Block block;
  ASSERT_TRUE(lexer.lex("/2 N30 (note) IF[#1EQ2] X5 (open", block));
  EXPECT_EQ(block.kind, kIf);
  EXPECT_EQ(block.number, 30);
  EXPECT_EQ(block.skip, 2);
  EXPECT_EQ(block.text.substr(block.statement, 3), "IF[");
  EXPECT_FALSE(block.empty());
  EXPECT_TRUE(lexer.inComment()) << "the comment goes on";
  ASSERT_TRUE(lexer.lexRest(block.text.find("X5"), block));
  EXPECT_EQ(block.kind, kBlock);
  EXPECT_EQ(block.find('X')->value, 5);
}

TEST(Lexer, TheLongestConfiguredNameWins) {
  FixedExpression hook;
  LexNames names;
  names.addAxis("X", 0, 1);
  names.addAxis("Z1", 1, 4);
  names.addAxis("XDE", 2, 7);
  names.addAxis("C", 3, 6);
  names.addSpindle("S1", 0);
  LexRules rules;
  rules.expressions = &hook;
  rules.names = &names;
  Lexer lexer(rules, nctAlarms());
  Block block;
  ASSERT_TRUE(lexer.lex("XI40 xde127.81 Z1=87.257 S1=8700 S50 CI-3", block)) << lexer.error().message;
  EXPECT_TRUE(block.find('X')->incremental);
  EXPECT_EQ(block.find('X')->axis, 0);
  EXPECT_EQ(block.findAxis(2)->value, 127.81);
  EXPECT_EQ(block.findAxis(1)->value, 87.257);
  EXPECT_EQ(block.findAxis(3)->value, -3);
  EXPECT_EQ(block.find('S')->value, 50);
  EXPECT_EQ(block.words[3].spindle, 0);
  EXPECT_EQ(block.words[3].value, 8700);
  ASSERT_TRUE(lexer.lex("Z1=I100", block));
  EXPECT_TRUE(block.findAxis(1)->incremental);
  ASSERT_TRUE(lexer.lex("AX[#2]=10 AX[#3]=5", block)) << lexer.error().message;  // axes 4 and 6
  EXPECT_EQ(block.findAxis(1)->value, 10);
  EXPECT_EQ(block.find('C')->value, 5);
  EXPECT_FALSE(lexer.lex("Z1 5", block)) << "'=' is missing";
  EXPECT_FALSE(lexer.lex("Z1=5 Z1=6", block));
  EXPECT_EQ(lexer.error().code, "nct-duplicate-word");
  EXPECT_FALSE(lexer.lex("AX[#4]=5", block));
  EXPECT_EQ(lexer.error().code, "nct-2018");
}

TEST(Lexer, RepeatsAreKeptForCalls) {
  LexRules rules;
  rules.keep_repeats = true;
  Lexer lexer(rules, nctAlarms());
  Block block;
  ASSERT_TRUE(lexer.lex("N1 I1 J2 I3 N4", block));
  EXPECT_EQ(block.number, 1);
  EXPECT_EQ(block.words.size(), 4u);
  EXPECT_TRUE(block.repeated.has('I'));
  EXPECT_TRUE(block.repeated.has('N'));
  EXPECT_FALSE(block.repeated.has('J'));
  EXPECT_EQ(block.repeated_at.begin, 10);
  lexer.setMode(LexMode::kData);
  ASSERT_TRUE(lexer.lex("N1339 P2", block));
  EXPECT_EQ(block.number, -1);
  EXPECT_EQ(block.find('N')->value, 1339);
}

TEST(Lexer, NoLineCrashesIt) {
  FixedExpression hook;
  LexNames names;
  names.addAxis("X", 0, 1);
  names.addAxis("Z1", 1, 4);
  LexRules full;
  full.expressions = &hook;
  full.names = &names;
  full.keep_repeats = true;
  Lexer plain{LexRules{}, nctAlarms()}, rich{full, nctAlarms()};
  Block block;
  unsigned seed = 12345;
  for (int round = 0; round < 20000; ++round) {
    std::string line;
    for (int k = 0; k < 12; ++k) {
      seed = seed * 1664525u + 1013904223u;
      line += "XGNMO/(),.-+I0123456789 %<>=#[;\x80"[(seed >> 16) % 33];
    }
    for (Lexer* lexer : {&plain, &rich}) {
      lexer->setInComment(false);
      if (lexer->lex(line, block)) continue;
      EXPECT_FALSE(lexer->error().message.empty()) << line;
      EXPECT_GE(lexer->error().columns.begin, 1) << line;
      EXPECT_LE(lexer->error().columns.end, static_cast<int>(line.size()) + 2) << line;
    }
  }
}

}  // namespace
}  // namespace proveout::nc
