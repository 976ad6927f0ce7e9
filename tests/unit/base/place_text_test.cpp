#include "core/geometry/place_text.h"

#include <gtest/gtest.h>

namespace proveout {
namespace {

TEST(PlaceText, IsToAMicrometreWithoutANegativeZero) {
  EXPECT_EQ(placeText({-1.5e-8, -0.0004999, 12.3456}), "X0.000 Y0.000 Z12.346");
  EXPECT_EQ(placeText({-0.00051, -2.5, 0.0}), "X-0.001 Y-2.500 Z0.000");
}

TEST(PlaceText, ExtentHasBothEndsOfEachAxis) {
  EXPECT_EQ(extentText(Box3{{-1e-9, -3, -20}, {80, 3, -1e-9}}),
            "X0.000..80.000 Y-3.000..3.000 Z-20.000..0.000");
}

}  // namespace
}  // namespace proveout
