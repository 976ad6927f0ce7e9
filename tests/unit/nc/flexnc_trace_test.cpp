// All moves of FlexNC cycles, against the traces of the digest's chapters 7, 8 and 10.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "flexnc_call.h"

namespace proveout {
namespace {

using nc::CycleAnswer;
using nc::CycleMove;

double rounded(double value) { return std::round(value * 1000.0) / 1000.0 + 0.0; }

/// "G00 X64 Z2; G01 X57; Z-8.174": X a diameter; an axis that stays is left out, and a word that is the same
/// as in the move before.
std::string traced(const std::vector<CycleMove>& moves) {
  static constexpr const char* kWords[] = {"G00", "G01", "G33"};
  std::string text;
  const char* before = "";
  for (const CycleMove& move : moves) {
    const ContourElement& e = move.element;
    const char* word = e.arc ? (e.sweep > 0.0 ? "CCW" : "CW") : kWords[static_cast<int>(move.kind)];
    text += text.empty() ? "" : "; ";
    if (word != before) text += std::string(word) + " ";
    before = word;
    const Vec2 way = e.to - e.from;
    std::string target;
    if (std::abs(way.y()) > 1e-9) target = fmt::format("X{:g}", rounded(2.0 * e.to.y()));
    if (std::abs(way.x()) > 1e-9)
      target += fmt::format("{}Z{:g}", target.empty() ? "" : " ", rounded(e.to.x()));
    text += target;
    if (e.arc) text += fmt::format(" about X{:g} Z{:g}", rounded(2.0 * e.center.y()), rounded(e.center.x()));
  }
  return text;
}

double wayOf(const ContourElement& e) {
  return e.arc ? std::abs(e.sweep) * (e.from - e.center).norm() : (e.to - e.from).norm();
}

double feedWay(const CycleAnswer& answer) {
  double way = 0.0;
  for (const CycleMove& move : answer.moves)
    way += move.kind == CycleMove::Kind::kFeed ? wayOf(move.element) : 0.0;
  return way;
}

// Rows: fnc-3.1-C5 fnc-3.1-rough fnc-3.2-G3.1
TEST(FlexncTrace, RoughsAShaft) {
  const CycleAnswer answer = test::flexncAnswer("G03.1X60A50R20Z10P1.5B2C2V0");
  EXPECT_EQ(traced(answer.moves),
            "G00 X64 Z2; G01 X57; Z-8.174; X57.8; G00 Z2; G01 X54; Z-5.77; X54.8; G00 Z2; G01 X51; Z-2.095; "
            "X51.8; G00 Z2; G01 X50; Z0; CW X60 Z-10 about X89.351 Z3.588; G00 X64; Z2");
  // Infeeds 9.4 mm, passes to -8.174494, -5.770339 and -2.095328, the arc 40 asin(sqrt(125) / 40); the
  // digest's 44.770 adds rounded ways.
  EXPECT_NEAR(feedWay(answer), 9.4 + 6.0 + 16.040161 + 2.0 + 11.331287, 2e-6);
}

// Rows: fnc-3.1-C5 fnc-3.1-rough fnc-3.3-G77
TEST(FlexncTrace, RoughsAHole) {
  std::string wanted = "G00 X6 Z2; G01 ";
  for (int pass = 1; pass <= 9; ++pass) {
    const double x = 10.0 + 3.0 * pass;
    wanted += fmt::format("X{:g}; Z{:g}; X{:g}; G00 Z2; G01 ", x, -15.0 + 1.5 * pass, x - 0.8);
  }
  wanted += "X40; Z0; X10 Z-15; G00 Z2";
  const CycleAnswer answer = test::flexncAnswer("G77X10A40Y15Z0C-2P1.5B2V0");
  EXPECT_EQ(traced(answer.moves), wanted);
  EXPECT_NEAR(feedWay(answer), 132.913, 0.0005);
  EXPECT_EQ(answer.moves.back().element.to, Vec2(2, 5));
}

// Row: fnc-3.1-V
TEST(FlexncTrace, RoughsBehindTheFace) {
  EXPECT_EQ(traced(test::flexncAnswer("G77X60A40Y10Z0P3C2B2V15").moves),
            "G00 X64 Z-13; G01 X54; Z-22; X54.8; G00 Z-13; G01 X48; Z-19; X48.8; G00 Z-13; G01 X42; Z-16; "
            "X42.8; G00 Z-13; G01 X40; Z-15; X60 Z-25; G00 X64; Z-13");
}

// A cone of 45 degrees behind a concave arc, from diameter 8 to 16 and from in front of the start plane Z1 to
// Z-2. Row: fnc-3.2-G13.5
TEST(FlexncTrace, LeavesPassesInFrontOut) {
  const CycleAnswer answer = test::flexncAnswer("G13.5X16A8R2G45Z2P0.5C1B1V0");
  ASSERT_FALSE(answer.alarm);
  // The arc rises by 2 - sqrt(2) over sqrt(2), the cone by what is left of 4 over as much.
  const double length = 4.0 - (2.0 - std::sqrt(2.0)) + std::sqrt(2.0);
  ASSERT_GT(length - 2.0, 1.0);
  for (const CycleMove& move : answer.moves)
    EXPECT_LE(move.element.to.x(), answer.moves.front().element.to.x());
  EXPECT_EQ(answer.warnings.size(), 2U);
  // On the cone r = 8 - (z + 2): passes at 7.5, 7, 6.5, 6 and 5.5 end behind Z1, where r is 5.
  EXPECT_EQ(answer.passes, 6);
  EXPECT_EQ(traced({answer.moves.end() - 4, answer.moves.end()}), "G01 X10; X16 Z-2; G00 X18; Z1");
}

/// A block, and behind it the next ones of its chain.
std::vector<CycleAnswer> chained(const std::vector<std::string>& blocks, const Vec2& at, bool approached) {
  std::vector<CycleAnswer> answers;
  nc::CycleCall call;
  Vec2 from = at;
  for (const std::string& block : blocks) {
    call = test::flexncCall(block, from);
    call.approached = approached && answers.empty();
    if (!answers.empty()) call.chain = answers.back().chain;
    answers.push_back(performCycle(call));
    from = answers.back().moves.back().element.to;
  }
  return answers;
}

// The chain of chapter 8, behind G81.1X0Z5. Rows: fnc-3.1-K fnc-3.1-contour fnc-3.4-G12 fnc-3.4-G77
TEST(FlexncTrace, ChainsContoursBehindAnApproach) {
  const std::vector<CycleAnswer> answers =
      chained({"G12X40R15P0C2K1", "G77X60A40Y10P0C2K0"}, Vec2(0, 0), true);
  EXPECT_EQ(traced(answers[0].moves), "G01 X10; CCW X40 Z-15 about X10 Z-15");
  EXPECT_EQ(traced(answers[1].moves), "G01 X60 Z-25");
  EXPECT_TRUE(answers[0].warnings.empty() && answers[1].warnings.empty());
  EXPECT_TRUE(answers[1].chain_return.empty());
}

// The chain of a hole, behind G81.2X40Z5. Row: fnc-3.5-G12
TEST(FlexncTrace, CutsAContourOfAHole) {
  const std::vector<CycleAnswer> answers = chained({"G12X9R14P0C-2K1"}, Vec2(0, 20), true);
  EXPECT_EQ(traced(answers[0].moves), "G01 X37; CW X9 Z-14 about X37 Z-14");
}

// The approach ends at Z0, the contour begins at the local face. Row: fnc-3.1-V
TEST(FlexncTrace, BeginsContoursAtTheLocalFace) {
  EXPECT_EQ(traced(chained({"G12X40R15P0C2V3K1"}, Vec2(0, 2), true)[0].moves),
            "G01 X10 Z-3; CCW X40 Z-18 about X10 Z-18");
  EXPECT_EQ(traced(chained({"G12X40R15Z1P0C2V3K1"}, Vec2(0, 2), true)[0].moves),
            "G01 X10 Z-3; Z-4; CCW X40 Z-19 about X10 Z-19");
}

// Row: fnc-3.1-contour
TEST(FlexncTrace, GoesToContoursItself) {
  const std::vector<CycleAnswer> answers =
      chained({"G12X40R15Z4P0C2B3V1K1", "G77X60A40Y10Z2P0C2K0"}, Vec2(100, 100), false);
  EXPECT_EQ(traced(answers[0].moves), "G00 X14 Z2; G01 X10; Z-5; CCW X40 Z-20 about X10 Z-20");
  EXPECT_EQ(traced(answers[0].chain_return), "G00 X44; Z2");
  EXPECT_EQ(traced(answers[1].moves), "G01 Z-22; X60 Z-32");
  EXPECT_EQ(traced(answers[1].chain_return), "G00 X64; Z2");
}

// A hole is left along Z. Row: fnc-3.5-G77
TEST(FlexncTrace, LeavesAHoleAlongZ) {
  const std::vector<CycleAnswer> answers = chained({"G77X10A40Y15P0C-2K1"}, Vec2(100, 100), false);
  EXPECT_EQ(traced(answers[0].moves), "G00 X36 Z0; G01 X40; X10 Z-15");
  EXPECT_EQ(traced(answers[0].chain_return), "G00 Z0");
}

// Row: fnc-3.6-G79
TEST(FlexncTrace, Faces) {
  const CycleAnswer answer = test::flexncAnswer("G79X22Y12Z6P1C2B2");
  std::string wanted = "G00 X26 Z8; G01 ";
  for (int z = 5; z >= 0; --z) {
    wanted += fmt::format("Z{}; X12; Z{}; G00 X26; {}", z, z + 2, z > 0 ? "G01 " : "");
  }
  EXPECT_EQ(traced(answer.moves), wanted + "Z8");
  EXPECT_EQ(answer.passes, 6);
  // One pass at 0 where the allowance is less than a pass, and a last pass that is thinner.
  EXPECT_EQ(traced(test::flexncAnswer("G79X22Y0Z1P2C2B2").moves), "G00 X26 Z3; G01 Z0; X0; Z2; G00 X26; Z3");
  EXPECT_EQ(traced(test::flexncAnswer("G79X22Y0Z3P2C2B2").moves),
            "G00 X26 Z5; G01 Z1; X0; Z3; G00 X26; G01 Z0; X0; Z2; G00 X26; Z5");
}

// Row: fnc-3.6-G5
TEST(FlexncTrace, DrillsDeep) {
  const CycleAnswer answer = test::flexncAnswer("G5P5Y1Z20B2V0");
  EXPECT_EQ(
      traced(answer.moves),
      "G00 X0 Z2; G01 Z-5; G00 Z2; Z-4; G01 Z-10; G00 Z2; Z-9; G01 Z-15; G00 Z2; Z-14; G01 Z-20; G00 Z2");
  EXPECT_NEAR(feedWay(answer), 25.0, 1e-9);
  // The last depth is what is left; in one go where P is not below Z.
  EXPECT_EQ(traced(test::flexncAnswer("G5P8Y1Z10B2V3").moves),
            "G00 X0 Z-1; G01 Z-11; G00 Z-1; Z-10; G01 Z-13; G00 Z-1");
  EXPECT_EQ(traced(test::flexncAnswer("G5P20Y1Z20B2V0").moves), "G00 X0 Z2; G01 Z-20; G00 Z2");
}

// Row: fnc-3.6-G79.1
TEST(FlexncTrace, CutsARadialGroove) {
  const CycleAnswer answer = test::flexncAnswer("G79.1X50A40H2P1C2Y8V13Q0.75");
  std::string wanted = "G00 X54 Z-15; ";
  for (int layer = 1; layer <= 5; ++layer) {
    for (int step = 0; step < 5; ++step) {
      if (step > 0 || layer > 1) wanted += fmt::format("Z{:g}; ", -15.0 - 1.5 * step);
      wanted += fmt::format("G01 X{}; G00 X54; ", 50 - 2 * layer);
    }
  }
  EXPECT_EQ(traced(answer.moves), wanted + "Z-15");
  EXPECT_EQ(answer.passes, 25);
  // Last step and last layer are what is left.
  EXPECT_EQ(traced(test::flexncAnswer("G79.1X50A47H2P1C2Y3V0Q1").moves),
            "G00 X54 Z-2; G01 X48; G00 X54; Z-3; G01 X48; G00 X54; Z-2; G01 X47; G00 X54; Z-3; G01 X47; "
            "G00 X54; Z-2");
}

// Row: fnc-3.6-G79.2
TEST(FlexncTrace, CutsAFaceGroove) {
  const CycleAnswer answer = test::flexncAnswer("G79.2X80A60Z5P1B2V0H2Q0.8");
  std::string wanted = "G00 X60 Z2; ";
  for (int layer = 1; layer <= 5; ++layer) {
    for (int step = 0; step < 6; ++step) {
      if (step > 0 || layer > 1) wanted += fmt::format("X{:g}; ", step < 5 ? 60.0 + 3.2 * step : 76.0);
      wanted += fmt::format("G01 Z{}; G00 Z2; ", -layer);
    }
  }
  EXPECT_EQ(traced(answer.moves), wanted + "X60");
  EXPECT_EQ(answer.passes, 30);
}

/// What rectangles of the tool's width, from each plunge's end to its start, take: the groove's area where
/// they leave neither ridges nor walls.
void expectPlungesCover(const std::string& block, int across, double tool, double from, double to) {
  std::vector<double> edges;
  for (const CycleMove& move : test::flexncAnswer(block).moves) {
    if (move.role == CycleMove::Role::kPass) edges.push_back(move.element.to[across]);
  }
  std::sort(edges.begin(), edges.end());
  EXPECT_NEAR(edges.front(), from, 1e-12);
  EXPECT_NEAR(edges.back() + tool, to, 1e-12);
  for (std::size_t k = 1; k < edges.size(); ++k) EXPECT_LE(edges[k] - edges[k - 1], tool + 1e-12);
}

// Grooves of 5654.9 and 10995.6 mm^3: pi (25^2 - 20^2) 8 and pi (40^2 - 30^2) 5. Rows: fnc-3.6-G79.1
// fnc-3.6-G79.2
TEST(FlexncTrace, LeavesNothingInGrooves) {
  expectPlungesCover("G79.1X50A40H2P1C2Y8V13Q0.75", 0, 2.0, -21.0, -13.0);
  expectPlungesCover("G79.2X80A60Z5P1B2V0H2Q0.8", 1, 2.0, 30.0, 40.0);
  EXPECT_NEAR(kPi * (25.0 * 25.0 - 20.0 * 20.0) * 8.0, 5654.9, 0.05);
  EXPECT_NEAR(kPi * (40.0 * 40.0 - 30.0 * 30.0) * 5.0, 10995.6, 0.05);
  EXPECT_NEAR(kPi * (11.0 * 11.0 - 6.0 * 6.0) * 6.0, 1602.2, 0.05);
}

}  // namespace
}  // namespace proveout
