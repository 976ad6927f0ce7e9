// Words found in lines, and the table of words that are told by number.
#include "core/nc/origins/origin_words.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/nc/iso/model/codes.h"
#include "core/nc/nct/dialect.h"
#include "core/path/line_word.h"

namespace proveout {
namespace {

using enum OriginKind;

std::string wordIn(std::string_view line, OriginKind kind) {
  const auto word = findWord(line, kind);
  return word ? std::string(line.substr(word->begin - 1u, static_cast<std::size_t>(word->end - word->begin)))
              : "";
}

TEST(LineWords, AreFoundByAddressAndNumber) {
  const char* line = "/N10 G90 G1 G41 x-1.5 (X9 G0) y+.25 Z 3 F100 M3 M8";
  EXPECT_EQ(wordIn(line, kX), "x-1.5");
  EXPECT_EQ(findWord(line, kX)->value, -1.5);
  EXPECT_EQ(findWord(line, kY)->value, 0.25);
  EXPECT_EQ(wordIn(line, kZ), "Z 3");
  EXPECT_EQ(wordIn(line, kMotionCode), "G1");
  EXPECT_EQ(wordIn(line, kDistance), "G90");
  EXPECT_EQ(wordIn(line, kCompensation), "G41");
  EXPECT_EQ(wordIn(line, kSpindleDirection), "M3");
  EXPECT_EQ(wordIn(line, kPlane), "");
  EXPECT_EQ(blockNumberIn(line), 10);
  EXPECT_EQ(blockNumberIn("G1 N10"), -1);
}

TEST(LineWords, TheBestAddressGoesFirstAndTheLastWordCounts) {
  EXPECT_EQ(wordIn("U5 X1", kX), "X1");
  EXPECT_EQ(wordIn("U5", kX), "U5");
  EXPECT_EQ(wordIn("X1 X2", kX), "X2");
  EXPECT_EQ(wordIn("G50.1 X0", kMirror), "G50.1");
  EXPECT_EQ(wordIn("G51 X-1", kMirror), "G51");
  EXPECT_EQ(wordIn("G51 X0 P2", kScaling), "G51");
  EXPECT_EQ(wordIn("G1 X5 ,C2 R1", kCorner), ",C2");
  EXPECT_EQ(wordIn("G81 G99 Z-5 R2", kCycle), "G81");
  EXPECT_EQ(wordIn("XI40", kX), "XI40");
  EXPECT_EQ(wordIn("G1 X5 $ X6", kX), "X5");
  EXPECT_EQ(wordIn("G1 X.5 .X6", kX), "X.5");
  EXPECT_EQ(wordIn("", kX), "");
}

TEST(LineWords, KnowTheCodesThatTheControlTellsOf) {
  nc::KindSet told;
  for (const nc::GCode* code : nc::nctCodes().allG()) {
    const std::string word = code->code10 % 10 == 0
                                 ? fmt::format("G{}", code->code10 / 10)
                                 : fmt::format("G{}.{}", code->code10 / 10, code->code10 % 10);
    told.add(code->kinds);
    code->kinds.each([&](OriginKind kind) {
      EXPECT_EQ(wordIn("N5 " + word + " X1 Y2 M8", kind), word) << originKindName(kind);
    });
  }
  for (const OriginKind kind :
       {kCycle, kCycleReturn, kLengthCode, kCompensation, kWorkOffset, kShift, kUnits, kDistance, kPlane,
        kMirror, kScaling, kRotation, kPolar, kVirtualPlane, kDiameter, kMotionCode, kFeedMode, kSpindleMode})
    EXPECT_TRUE(told.has(kind)) << originKindName(kind);
}

TEST(LineWords, EveryKindHasAName) {
  for (int k = 0; k <= static_cast<int>(kData); ++k)
    EXPECT_FALSE(originKindName(static_cast<OriginKind>(k)).empty()) << k;
  EXPECT_EQ(originKindName(kCycleDepth), "depth of the cycle");
  EXPECT_EQ(originKindName(kSpindleDirection), "spindle direction");
  EXPECT_TRUE(isCoordinate(kCyclePlane));
  EXPECT_FALSE(isLength(kFeed));
}

TEST(OriginCodes, HoldWhatTheyAreMadeOf) {
  const OriginCode::Reading step{true, false, OriginCode::Reading::As::kCycleStep};
  const OriginCode back = OriginCode::linesBack(15, step),
                   line = OriginCode::line(OriginCode::kMostLines, {});
  EXPECT_TRUE(back.isLinesBack());
  EXPECT_EQ(back.lines(), 15u);
  EXPECT_EQ(back.reading(), step);
  EXPECT_EQ(writtenAs(kZ, back.reading()), kCycleStep);
  EXPECT_FALSE(line.isLinesBack() || line.isWord() || line.none());
  EXPECT_EQ(line.lines(), OriginCode::kMostLines);
  EXPECT_TRUE(OriginCode::word(7).isWord());
  EXPECT_EQ(OriginCode::word(7).number(), 7u);
  EXPECT_TRUE(OriginCode().none());
}

class Words : public testing::Test {
 protected:
  Toolpath path_;
  ToolpathBuilder sink_{path_};
  nc::OriginWords words_;

  std::uint32_t word(std::uint32_t line, std::vector<std::uint32_t> reads = {}, double value = 1.0,
                     int channel = 0) {
    WordOrigin w;
    w.line = line;
    w.begin = 1;
    w.end = 5;
    w.value = value;
    return words_.numberOf(w, words_.listOf(reads), channel, sink_);
  }
  const std::vector<std::uint32_t>& from(std::uint32_t number) const {
    return path_.origins.words[number - 1].from;
  }
};

TEST_F(Words, EqualOnesAreKeptOnce) {
  const std::uint32_t a = word(1), b = word(2);
  EXPECT_EQ(word(1), a);
  EXPECT_NE(a, b);
  EXPECT_NE(word(1, {}, 1.0, 1), a) << "of another channel";
  const std::uint32_t sum = word(3, {a, b});
  EXPECT_EQ(word(3, {a, b, a}), sum);
  EXPECT_EQ(from(sum), (std::vector<std::uint32_t>{a, b}));
  EXPECT_NE(word(3, {a}), sum);
  EXPECT_EQ(path_.origins.words.size(), 5u);
}

TEST_F(Words, NoPlaceComesTwiceInAChain) {
  const std::uint32_t start = word(1);
  std::uint32_t counter = word(2, {start});
  for (int k = 0; k < 50; ++k) counter = word(2, {counter});
  EXPECT_EQ(from(counter), std::vector<std::uint32_t>{start});
  std::uint32_t a = start, b = 0;
  for (int k = 0; k < 50; ++k) {
    b = word(5, {a});
    a = word(6, {b, start});
  }
  for (const std::uint32_t behind : from(a)) {
    if (path_.origins.words[behind - 1].line == 5) {
      EXPECT_EQ(from(behind), std::vector<std::uint32_t>{start});
    }
  }
  EXPECT_LT(path_.origins.words.size(), 12u);
}

TEST_F(Words, AfterManyValuesAPlaceHasNone) {
  const std::uint32_t start = word(1);
  std::uint32_t number = 0;
  for (int k = 0; k < 1000; ++k) number = word(2, {start}, k);
  EXPECT_TRUE(std::isnan(path_.origins.words[number - 1].value));
  EXPECT_EQ(word(2, {start}, 3), word(2, {start}, 3));
  EXPECT_LE(path_.origins.words.size(), 66u);
}

}  // namespace
}  // namespace proveout
