// What the cycles of the FlexNC control refuse (digest flexnc, 12), each with a text that says what to do.
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "flexnc_call.h"

namespace proveout {
namespace {

using nc::CycleAnswer;

struct Refusal {
  std::string block, id;
};
void PrintTo(const Refusal& refusal, std::ostream* out) { *out << refusal.block; }

class FlexncRefusal : public testing::TestWithParam<Refusal> {};

TEST_P(FlexncRefusal, HasItsAlarm) {
  const CycleAnswer answer = test::flexncAnswer(GetParam().block);
  ASSERT_TRUE(answer.alarm);
  EXPECT_EQ(answer.alarm->id, GetParam().id) << answer.alarm->text;
  EXPECT_EQ(answer.alarm->text.substr(0, 1), "G");
  EXPECT_TRUE(answer.moves.empty());
}

// Rows: fnc-3.5-none fnc-3.1-P fnc-3.1-C fnc-3.1-K
INSTANTIATE_TEST_SUITE_P(
    Letters, FlexncRefusal,
    testing::Values(Refusal{"G12X60R20Z10P0C2B2V0", "fnc-p-rough"},
                    Refusal{"G12X60R20Z10P-1C2B2V0", "fnc-p-rough"}, Refusal{"G12X60R20P1C2K1", "fnc-p-fin"},
                    Refusal{"G12X60R20Z10P1.5C0B2V0", "fnc-c-sign"},
                    Refusal{"G3.1X60A50R20Z10P1.5B2C-2V0", "fnc-c-sign"},
                    Refusal{"G8.1X100A10Z0R25U25P2C-3B2V0", "fnc-c-sign"},
                    Refusal{"G13.5X80A8R10G45Z35P1C-2B3V0", "fnc-c-sign"},
                    Refusal{"G13.5X80A8R10G45P0C-2K1", "fnc-c-sign"}, Refusal{"G12X60R20P0C2K2", "fnc-k"},
                    Refusal{"G12X60R20P0C2K0", "fnc-k"}, Refusal{"G12X-60R20Z10P1.5C2B2V0", "fnc-param-sign"},
                    Refusal{"G12X60R0Z10P1.5C2B2V0", "fnc-param-sign"},
                    Refusal{"G12X60R20Z-10P1.5C2B2V0", "fnc-param-sign"},
                    Refusal{"G12X60R20Z10P1.5C2B0V0", "fnc-param-sign"},
                    Refusal{"G12X60R20Z10P1.5C2B2V-1", "fnc-param-sign"},
                    Refusal{"G77X60A0Y10Z0P3C2B2V0", "fnc-param-sign"},
                    Refusal{"G12.2A0Y25Z0R12G45P2C-3B3V0", "fnc-param-sign"},
                    Refusal{"G12X60R20P1.5C2B2V0", "fnc-param-missing"},
                    Refusal{"G12X60R20Z10C2B2V0", "fnc-param-missing"},
                    Refusal{"G12X60R20Z10P1.5B2V0", "fnc-param-missing"},
                    Refusal{"G12X60A20R20Z10P1.5C2B2V0", "fnc-param-extra"},
                    Refusal{"G77.1X120Y30Z12G90P1.3C2B2V0", "fnc-angle-90"},
                    Refusal{"G77.1X120Y30Z12G0P1.3C2B2V0", "fnc-angle-90"},
                    Refusal{"G22.1X170Y48Z5G-5R10U12P1B3C2V0", "fnc-angle-90"},
                    Refusal{"G12X60R20Z10P0.0001C2B2V0", "fnc-passes"},
                    Refusal{"G12X6000000R20Z10P1C2B2V0", "fnc-num"}));

/// Y0 has its own alarm in all that have a cone and an arc, or a cone alone by its angle.
INSTANTIATE_TEST_SUITE_P(NoLength, FlexncRefusal,
                         testing::Values(Refusal{"G77.1X120Y0Z12G37P1.3C2B2V0", "fnc-y-zero"},
                                         Refusal{"G77.2A20Y0Z12G37P1.3C2B2V0", "fnc-y-zero"},
                                         Refusal{"G13.1X80Y0Z5R10G45P1C2B3V0", "fnc-y-zero"},
                                         Refusal{"G13.2A8Y0Z5R10G45P1C2B3V0", "fnc-y-zero"},
                                         Refusal{"G12.1X80Y0Z5R10G45P1C2B3V0", "fnc-y-zero"},
                                         Refusal{"G12.2A8Y0Z5R10G45P1C2B3V0", "fnc-y-zero"},
                                         Refusal{"G12.3A20Y0Z5R10G45P1C2B3V0", "fnc-y-zero"}));

INSTANTIATE_TEST_SUITE_P(Geometry, FlexncRefusal,
                         testing::Values(Refusal{"G12X39R20Z10P1.5C2B2V0", "fnc-x-2r"},
                                         Refusal{"G13X39R20Z10P1.5C2B2V0", "fnc-x-2r"},
                                         Refusal{"G77X40A40Y10Z0P3C2B2V0", "fnc-x-le-a"},
                                         Refusal{"G77.3A80X20Z12G27P2.5C2B2V0", "fnc-x-le-a"},
                                         Refusal{"G3.1X50A60R20Z10P1.5B2C2V0", "fnc-x-le-a"},
                                         Refusal{"G77X40A10Y15Z0C-2P1.5B2V0", "fnc-a-le-x"},
                                         Refusal{"G13.1X80Y7Z5R10G45P1C2B3V0", "fnc-tangent"},
                                         Refusal{"G12.1X80Y2Z5R10G45P1C2B3V0", "fnc-tangent"},
                                         Refusal{"G12.5A80X90Z35R10G55P1C2B3V0", "fnc-tangent"},
                                         Refusal{"G22.1X170Y10Z5G55R10U12P1B3C2V0", "fnc-tangent"},
                                         Refusal{"G23.2A25Y3Z5G55R10U12P1B2C2V0", "fnc-tangent"},
                                         Refusal{"G3.1X60A50R12Z10P1.5B2C2V0", "fnc-tangent"},
                                         Refusal{"G8.1X101A0Z0R25U25P2C3B2V0", "fnc-tangent"},
                                         Refusal{"G8.1X40A50Z0R25U25P2C3B2V0", "fnc-tangent"},
                                         Refusal{"G77.1X40Y30Z12G37P1.3C2B2V0", "fnc-dia-neg"},
                                         Refusal{"G13.1X20Y30Z5R10G45P1C2B3V0", "fnc-dia-neg"},
                                         Refusal{"G12X10R20Z10P1.5C-6B2V0", "fnc-dia-neg"},
                                         Refusal{"G13.5X80A8R10G45Z-50P1C2B3V0", "fnc-z-front"}));

INSTANTIATE_TEST_SUITE_P(
    Special, FlexncRefusal,
    testing::Values(Refusal{"G79X12Y22Z6P1C2B2", "fnc-x-le-a"}, Refusal{"G79X22Y12Z6P1C-2B2", "fnc-c-sign"},
                    Refusal{"G79X22Y12Z0P1C2B2", "fnc-param-sign"},
                    Refusal{"G79X22Y12Z6P1C2", "fnc-param-missing"},
                    Refusal{"G79X22Y12Z6P1C2B2V1", "fnc-param-extra"},
                    Refusal{"G5P5Y5Z20B2V0", "fnc-param-sign"}, Refusal{"G5P0Y0Z20B2V0", "fnc-param-sign"},
                    Refusal{"G79.1X50A40H9P1C2Y8V13Q0.75", "fnc-groove-width"},
                    Refusal{"G79.1X50A40H2P1C2Y8V13Q1.1", "fnc-param-sign"},
                    Refusal{"G79.1X50A50H2P1C2Y8V13Q0.75", "fnc-x-le-a"},
                    Refusal{"G79.1X50A40H2P1C-2Y8V13Q0.75", "fnc-c-sign"},
                    Refusal{"G79.2X80A60Z5P1B2V0H11Q0.8", "fnc-groove-width"},
                    Refusal{"G76P010060Q0R0", "fnc-param-sign"}, Refusal{"G76P1.5Q0.1R0", "fnc-num"},
                    Refusal{"G76X20Z-10P1Q0.1R0F1.5", "fnc-param-missing"},
                    Refusal{"G76X20P1Q0.1R0F1.5", "fnc-param-missing"},
                    Refusal{"G30A30X50Z60R10Q11F24H0.5P1U56L8K3", "fnc-groove-width"},
                    Refusal{"G30A30X50Z60R10Q3F24H0.5P1U50L8K3", "fnc-x-le-a"},
                    Refusal{"G30A30X50Z60R10Q3F24H0.5P1U56L8K1.5", "fnc-num"}));

TEST(FlexncRefusals, RefusesAThreadThatDoesNotFit) {
  nc::CycleCall call = test::flexncCall("G76X20Z-10P1Q0.1R0F1.5", Vec2(16, 25));
  call.thread = nc::ThreadData{.spring_passes = 1, .run_out = 20.0, .angle_deg = 60.0, .second_depth = 0.1};
  EXPECT_EQ(performCycle(call).alarm.value().id, "fnc-param-sign");
  call.thread->run_out = 0.0;
  call.arguments = test::flexncCall("G76X2Z-10P1Q0.1R0F1.5").arguments;
  EXPECT_EQ(performCycle(call).alarm.value().id, "fnc-dia-neg");
}

TEST(FlexncRefusals, RefusesApproachesOnTheWrongSide) {
  nc::CycleCall call = test::flexncCall("G12X40R15P0C2K1", Vec2(0, 5.5));
  call.approached = true;
  EXPECT_EQ(performCycle(call).alarm.value().id, "fnc-equi-x");
  call = test::flexncCall("G12X9R14P0C-2K1", Vec2(0, 18));
  call.approached = true;
  EXPECT_EQ(performCycle(call).alarm.value().id, "fnc-equi-x");
}

TEST(FlexncRefusals, TellsWhatIsOdd) {
  const auto warns = [](const std::string& block) {
    const CycleAnswer answer = test::flexncAnswer(block);
    EXPECT_FALSE(answer.alarm) << block;
    return answer.warnings.empty() ? std::string() : std::string(answer.warnings.front().id);
  };
  EXPECT_EQ(warns("G12X40R15P0C2"), "fnc-k");                           // no K
  EXPECT_EQ(warns("G22.2A20Y48Z5G55R0U12P1B3C2V0"), "fnc-param-sign");  // R0 is not described there
  EXPECT_EQ(warns("G22.1X100Y40Z0G30R0U0P2B2C2V0"), "");                // but here
  EXPECT_EQ(warns("G77X60A40Y0Z20P3C2B2V0"), "");
  nc::CycleCall next = test::flexncCall("G12X40R15P0C2K0", Vec2(-5, 5.01));
  next.chain = nc::ContourChain{};
  EXPECT_EQ(performCycle(next).warnings.at(0).id, "fnc-k");  // it begins elsewhere than the one before ends
}

TEST(FlexncRefusals, RefusesWhatIsNoNumber) {
  for (const double value :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (const char letter : {'X', 'R', 'Z', 'P', 'C', 'B', 'V'}) {
      nc::CycleCall call = test::flexncCall("G12");
      for (const char other : {'X', 'R', 'Z', 'P', 'C', 'B', 'V'})
        call.arguments.set(other, other == letter ? value : other == 'X' ? 60.0 : 10.0);
      EXPECT_TRUE(performCycle(call).alarm) << letter;
    }
  }
}

}  // namespace
}  // namespace proveout
