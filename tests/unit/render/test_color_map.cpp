#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "render/color_map.h"
#include "render/srgb.h"

namespace proveout {
namespace {

const DeviationScale kScale{0.02, 0.05, 0.5};

float luminance(const Rgb& c) {
  const Eigen::Vector3f l = render_detail::SrgbTable().toLinear(c);
  return 0.2126F * l[0] + 0.7152F * l[1] + 0.0722F * l[2];
}

TEST(DeviationColor, NeutralExactlyWithinTolerance) {
  const Rgb neutral = deviationColor(kScale, 0.0);
  EXPECT_EQ(deviationColor(kScale, -0.02), neutral);
  EXPECT_EQ(deviationColor(kScale, 0.05), neutral);
  EXPECT_NE(deviationColor(kScale, -0.0201), neutral);
  EXPECT_NE(deviationColor(kScale, 0.0501), neutral);
}

TEST(DeviationColor, GougeIsBlueExcessIsRedAndBothDarkenOutwards) {
  float last_gouge = luminance(deviationColor(kScale, 0)), last_excess = last_gouge;
  for (double d = 0.06; d <= 0.5; d += 0.02) {
    const Rgb gouge = deviationColor(kScale, -d), excess = deviationColor(kScale, d);
    EXPECT_GT(gouge[2], gouge[0]);
    EXPECT_GT(excess[0], excess[2]);
    EXPECT_LT(luminance(gouge), last_gouge);
    EXPECT_LT(luminance(excess), last_excess);
    last_gouge = luminance(gouge);
    last_excess = luminance(excess);
  }
  EXPECT_EQ(deviationColor(kScale, 9), deviationColor(kScale, 0.5));
  EXPECT_EQ(deviationColor(kScale, -9), deviationColor(kScale, -0.5));
}

TEST(DeviationColor, NotMeasuredIsItsOwnColour) {
  const Rgb none = deviationColor(kScale, std::numeric_limits<double>::quiet_NaN());
  EXPECT_NE(none, deviationColor(kScale, 0));
  EXPECT_EQ(none, deviationColor(kScale, std::numeric_limits<double>::infinity()));
}

TEST(DeviationScale, LimitIsRoundAndTakesEverythingIn) {
  EXPECT_DOUBLE_EQ(deviationScaleFor(0.02, 0.05, 0.0).limit, 0.2);
  EXPECT_DOUBLE_EQ(deviationScaleFor(0.02, 0.05, 0.22).limit, 0.5);
  EXPECT_DOUBLE_EQ(deviationScaleFor(0.02, 0.05, 1.0).limit, 1.0);
  EXPECT_DOUBLE_EQ(deviationScaleFor(0.02, 0.05, 5.1).limit, 10.0);
  EXPECT_DOUBLE_EQ(deviationScaleFor(0.02, 0.05, std::nan("")).limit, 0.2);
  EXPECT_DOUBLE_EQ(deviationScaleFor(0.0, 0.0, 3.55e-15).limit, 1e-4) << "rounding is no deviation";
  EXPECT_DOUBLE_EQ(deviationScaleFor(0.0, 0.0, 0.0).limit, 1e-4);
}

TEST(Srgb, BytesSurviveTheRoundTrip) {
  const render_detail::SrgbTable table;
  const render_detail::LinearToByte to_byte;
  for (int i = 0; i < 256; ++i) EXPECT_EQ(to_byte(table.toLinear(static_cast<float>(i) / 255.0F)), i);
}

}  // namespace
}  // namespace proveout
