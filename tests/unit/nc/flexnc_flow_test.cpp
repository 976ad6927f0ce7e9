// Blocks, labels, subprograms and repeats of the FlexNC control, and every error of its digest once (flexnc,
// 2 and 12).
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/path/origin_query.h"
#include "flexnc_path.h"

namespace proveout::test {
namespace {

TEST(FlexncFlow, RunsWordsFromLeftToRight) {
  const FlexncPath run(kStart + "G90G00X10Z5G01Z-5M05G91Z1\nM02\n");
  ASSERT_EQ(run.count(), 3u);
  EXPECT_EQ(run.end(1), Vec2(10.0, -5.0));
  EXPECT_EQ(run.end(2), Vec2(10.0, -4.0));
  EXPECT_EQ(run.motion(1).spindle, 300.0);
  EXPECT_EQ(run.motion(2).spindle, 0.0);
}

TEST(FlexncFlow, ReadsSmallLettersBlanksAndLeadingZeros) {
  const FlexncPath run("t01m6d1\ns300 m03\ng98 f100\ng00x+10z5\ng1 z-5. // down\nG003X12I1\nm2\n");
  EXPECT_TRUE(run.summary.ok()) << run.first(Severity::kError).message;
  EXPECT_EQ(run.count(), 3u);
}

TEST(FlexncFlow, RunsTheManualsSkeleton) {
  const FlexncPath run(
      "T4M06D3\nS300M03\nG90F100\nG00X0Z30\nGOSUB20\nGOSUB21\nGOSUB20\nGOSUB21\nM02\n"
      "N20\nG00X30Z20\nG80\nRET\nN21\nG00X40\nGOSUB22\nRETURN\nN22\nG00Z21\nRET\n");
  ASSERT_TRUE(run.summary.ok()) << run.first(Severity::kError).message;
  std::vector<double> x;
  for (const Vec2& end : run.ends()) x.push_back(end.x());
  EXPECT_EQ(x, (std::vector<double>{0, 30, 40, 40, 30, 40, 40}));
  EXPECT_EQ(run.motion(3).source.depth, 2);
}

TEST(FlexncFlow, NestsRepeatsWithCountersOfTheirOwn) {
  const std::string body = "G00X20Z0\nG91\nN1\nG01Z-1\nN2\nX1\nREPEAT2(P200)FROM2\nREPEAT1(P201)FROM1\nM02\n";
  const FlexncPath run(kStart + body);
  ASSERT_TRUE(run.summary.ok());
  EXPECT_EQ(run.end(run.count() - 1), Vec2(26.0, -2.0));
  EXPECT_EQ(FlexncPath(kStart + "N1\nN2\nREPEAT2(P200)FROM2\nREPEAT1(P200)FROM1\nM02\n").error(),
            "fnc-repeat");
  EXPECT_EQ(FlexncPath(kStart + "N1\nREPEAT2(P200)FROM1\nREPEAT1FROM1\nM02\n").error(), "");
}

TEST(FlexncFlow, LetsAProgramChangeTheCounter) {
  const FlexncPath run(kStart + "G91G00X1\nN1\nX1\nP200=0\nREPEAT9(P200)FROM1\nM02\n");
  ASSERT_TRUE(run.summary.ok());
  EXPECT_EQ(run.count(), 3u);  // armed with 9, repeated once, set to 0
}

TEST(FlexncFlow, StopsRepeatsWithoutAnEnd) {
  const FlexncPath run(kStart + "G00X10\nN1\nP200=5\nREPEAT9(P200)FROM1\nM02\n");
  EXPECT_EQ(run.error(), "fnc-endless-loop");
  EXPECT_EQ(run.summary.end, ProgramEnd::kBlockLimit);
}

TEST(FlexncFlow, StopsBehindABlock) {
  ControlSettings settings;
  settings.until = UntilBlock{5, {}};
  const FlexncPath run(kStart + "G00X10\nG00X20\nG00X30\nM02\n", settings);
  EXPECT_EQ(run.count(), 2u);
  EXPECT_EQ(run.summary.end, ProgramEnd::kUntil);
}

TEST(FlexncFlow, ComputesAsTheExpressionsSay) {
  const auto x = [](const std::string& expression) {
    const FlexncPath run("P1100=" + expression + "\nG00X(P1100)\nM02\n");
    return run.count() == 1 ? run.end(0).x() : NAN;
  };
  EXPECT_NEAR(x("2+3*4/6-1"), 3.0, 1e-12);
  EXPECT_NEAR(x("(2+3)*-4+30"), 10.0, 1e-12);
  EXPECT_NEAR(x("10*sin(90)*cos(60)"), 5.0, 1e-12);
  EXPECT_NEAR(x("SIN(360000030)"), 0.5, 1e-9);
  EXPECT_NEAR(x("8-4-2"), 2.0, 1e-12);
  EXPECT_NEAR(x("16/4/2 // 7"), 2.0, 1e-12);
  std::string deep = "1";
  for (int k = 0; k < 200; ++k) deep = "(" + deep + ")";
  EXPECT_TRUE(std::isnan(x(deep)));
  EXPECT_TRUE(FlexncPath("P5=1\nM02\n").warns("fnc-variable"));
}

TEST(FlexncFlow, NamesAWordOfAVariable) {
  const FlexncPath run(kStart + "P1100=12\nG00X(P1100+1)\nM02\n");
  const LineText text = [](std::uint32_t, std::uint32_t) { return std::string(20, ' '); };
  ASSERT_EQ(run.count(), 1u);
  const auto x = originOf(run.path, 0, OriginKind::kX, text);
  ASSERT_TRUE(x);
  EXPECT_EQ(x->line, 5u);
  ASSERT_EQ(x->from.size(), 1u);
  EXPECT_EQ(x->from[0].line, 4u);
}

struct Refusal {
  const char* id;
  const char* block;
};
void PrintTo(const Refusal& refusal, std::ostream* out) { *out << refusal.id << ": " << refusal.block; }

class FlexncRefuses : public testing::TestWithParam<Refusal> {};

TEST_P(FlexncRefuses, WithItsLine) {
  const FlexncPath run(kStart + GetParam().block + "\nM02\n");
  EXPECT_EQ(run.error(), GetParam().id) << run.first(Severity::kError).message;
  EXPECT_GE(run.first(Severity::kError).where.line, 4);
  EXPECT_FALSE(run.first(Severity::kError).message.empty());
  EXPECT_EQ(run.summary.errors, 1);
}

INSTANTIATE_TEST_SUITE_P(
    Digest, FlexncRefuses,
    testing::Values(
        Refusal{"fnc-p-rough", "G12X60R20Z10P-1C2B2V0"}, Refusal{"fnc-p-fin", "G12X60R20P1C2K1"},
        Refusal{"fnc-c-sign", "G12X60R20Z10P1C0B2V0"}, Refusal{"fnc-param-sign", "G77X60A-4Y10Z0P1C2B2V0"},
        Refusal{"fnc-param-missing", "G77X60A40Z0P1C2B2V0"}, Refusal{"fnc-param-missing", "G81X10"},
        Refusal{"fnc-param-extra", "G81X10Z5P1"}, Refusal{"fnc-param-extra", "G77X60A40Y10Z0P1C2B2V0Q1"},
        Refusal{"fnc-param-extra", "G77X60X60A40Y10Z0P1C2B2V0"}, Refusal{"fnc-x-2r", "G12X30R20Z10P1C2B2V0"},
        Refusal{"fnc-x-le-a", "G77X40A40Y10Z0P1C2B2V0"}, Refusal{"fnc-a-le-x", "G77X40A30Y10Z0P1C-2B2V0"},
        Refusal{"fnc-angle-90", "G77.1X120Y30Z12G90P1.3C2B2V0"},
        Refusal{"fnc-y-zero", "G77.1X120Y0Z12G37P1.3C2B2V0"},
        Refusal{"fnc-tangent", "G13.1X80Y5Z5R10G45P1C2B3V0"},
        Refusal{"fnc-tangent", "G3.1X60A50R5Z10P1.5B2C2V0"},
        Refusal{"fnc-tangent", "G8.1X100A0Z0R20U20P2C3B2V0"},
        Refusal{"fnc-dia-neg", "G77.1X20Y30Z12G37P1.3C2B2V0"},
        Refusal{"fnc-groove-width", "G79.1X50A40H9P1C2Y8V13Q0.75"},
        Refusal{"fnc-groove-width", "G79.2X80A60Z5P1B2V0H11Q0.8"},
        Refusal{"fnc-equi-x", "G81.1X30Z5\nG12X40R15P0C2K1"},
        Refusal{"fnc-equi-x", "G81.2X10Z5\nG12X9R14P0C-2K1"}, Refusal{"fnc-equi-z", "G81.1X0Z0"},
        Refusal{"fnc-k", "G12X40R15P0C2K2"}, Refusal{"fnc-k", "G12X40R15P0C2K0"},
        Refusal{"fnc-label", "GOSUB7"}, Refusal{"fnc-label", "GOSUB7\nM02\nN7\nRET\nN7"},
        Refusal{"fnc-ret", "RET"}, Refusal{"fnc-repeat", "REPEAT2FROM7\nN7"},
        Refusal{"fnc-repeat", "N7\nREPEAT0FROM7"}, Refusal{"fnc-num", "G00X1,5"},
        Refusal{"fnc-num", "G00X1.2.3"}, Refusal{"fnc-num", "G00X"},
        Refusal{"fnc-arc", "G00X10Z0\nG02X12Z-2"}, Refusal{"fnc-arc", "G00X10Z0\nG02X12Z-2R2"},
        Refusal{"fnc-arc", "G00X10I2"}, Refusal{"fnc-arc", "G00X10Z0\nG02X12Z-2I0K0"},
        Refusal{"fnc-spindle", "M05\nS0\nM03"},
        Refusal{"fnc-spindle", "M05\nG00X25Z16\nG76P010060Q0.1R0\nG76X20Z-10P1Q0.1R0F1.5"},
        Refusal{"fnc-tool", "T0\nM06"}, Refusal{"fnc-dwell", "G04"}, Refusal{"fnc-unknown", "G55"},
        Refusal{"fnc-unknown", "G12.4X1"}, Refusal{"fnc-unknown", "M30"}, Refusal{"fnc-unknown", "Q5"},
        Refusal{"fnc-unknown", "P1100=SQRT(4)"}, Refusal{"fnc-value", "P1100=1/0"},
        Refusal{"fnc-motion", "X10"}, Refusal{"fnc-syntax", "G00X10 ; text"},
        Refusal{"fnc-syntax", "P1100=1 G00X5"}, Refusal{"fnc-syntax", "GOSUB20 G00X5"},
        Refusal{"fnc-gosub", "GOSUB7\nM02\nN7\nGOSUB7"}, Refusal{"fnc-param-missing", "G52"}));

TEST(FlexncFlow, RefusesTheEndInsideASubprogram) {
  EXPECT_EQ(FlexncPath(kStart + "GOSUB7\nN7\nG00X10\nM02\n").error(), "fnc-ret");
  EXPECT_EQ(FlexncPath(kStart + "GOSUB7\nM02\nN7\nG00X10\n").error(), "fnc-ret");
}

TEST(FlexncFlow, WarnsWhereM02IsMissing) {
  const FlexncPath run(kStart + "G00X10\n");
  EXPECT_TRUE(run.summary.ok());
  EXPECT_TRUE(run.warns("fnc-no-m02"));
}

TEST(FlexncFlow, WarnsWhereCompensationStaysOn) {
  EXPECT_TRUE(FlexncPath(kStart + "G00X20Z5\nG42G01Z0\nZ-9\nM02\n").warns("fnc-comp-end"));
}

TEST(FlexncFlow, WarnsOfAProfileBehindItsFace) {
  EXPECT_TRUE(FlexncPath(kStart + "G13.5X80A8R10G45Z35P1C2B3V0\nM02\n").warns("fnc-z-front"));
}

TEST(FlexncFlow, GoesOnBehindErrorsWhereItIsAsked) {
  ControlSettings settings;
  settings.max_errors = 10;
  const FlexncPath run(kStart + "G55\nG00X10\nG12X30R20Z10P1C2B2V0\nG00X20\nM02\n", settings);
  EXPECT_EQ(run.summary.errors, 2);
  EXPECT_EQ(run.count(), 2u);
}

/// Texts that are cut, doubled and swapped at random end with an answer, and with the same one each time.
TEST(FlexncFlow, AnswersBrokenPrograms) {
  const std::string good = kStart +
                           "P1100=50\nG81.1X0Z5\nG12X40R15P0C2K1\nG77X60A40Y10P0C2K0\nG81X100Z100\n"
                           "N600\nG01Z20F400\nG42X(P1100/2)\nG02X30Z10I2K3\nG40X50\nREPEAT3(P293)FROM600\n"
                           "GOSUB20\nG76P010060Q0.1R0\nG76X20Z-10P1Q0.1R0F1.5\nG52X1Z2\nM02\nN20\nRET\n";
  std::mt19937 random(20);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  int failed = 0;
  for (int round = 0; round < 400; ++round) {
    std::string text = good;
    for (std::size_t k = 0, n = 1 + below(4); k < n; ++k) {
      const std::size_t at = below(text.size());
      if (const std::size_t how = below(3); how == 0) {
        text.erase(at, 1 + below(6));
      } else if (how == 1) {
        text.insert(at, text.substr(below(text.size()), below(9)));
      } else {
        text[at] = static_cast<char>(32 + below(95));
      }
    }
    ControlSettings settings;
    settings.block_limit = 2000;
    settings.max_errors = 5;
    const FlexncPath first(text, settings), second(text, settings);
    EXPECT_EQ(first.count(), second.count()) << text;
    EXPECT_EQ(first.summary.errors, second.summary.errors) << text;
    for (const Motion& motion : first.path.motions) {
      ASSERT_TRUE(motion.to.allFinite() && std::isfinite(motion.time_s)) << text;
    }
    failed += first.summary.ok() ? 0 : 1;
  }
  EXPECT_GT(failed, 100);
}

}  // namespace
}  // namespace proveout::test
