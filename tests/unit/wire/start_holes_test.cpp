#include "removal/wire/start_holes.h"

#include <gtest/gtest.h>

namespace proveout {
namespace {

PrismBlank plate() { return *prismOf(BoxShape{{0, 0, 0}, {40, 30, 10}}); }

std::string refusal(PrismBlank blank, const std::vector<StartHole>& holes) {
  const Status status = addStartHoles(blank, holes);
  return status ? "accepted" : status.error().message;
}

TEST(StartHoles, AreHollowsOfTheBlank) {
  PrismBlank blank = plate();
  ASSERT_TRUE(addStartHoles(blank, {{{10, 15}, 3.0}, {{30, 15}, 1.0}}).ok());
  EXPECT_EQ(blank.loops.size(), 3u);
  const WireStock stock(blank);
  EXPECT_NEAR(stock.initialVolume(), 10 * (1200 - kPi * (2.25 + 0.25)), 1e-9);
  ASSERT_EQ(stock.bodies().size(), 1u);
  EXPECT_NEAR(stock.volume(), stock.initialVolume(), 1e-6);
}

TEST(StartHoles, MustLieInTheStockAndApart) {
  EXPECT_NE(refusal(plate(), {{{41, 15}, 3.0}}).find("X41 Y15 is not in the stock"), std::string::npos);
  EXPECT_NE(refusal(plate(), {{{40, 15}, 3.0}}).find("is not in the stock"), std::string::npos);
  EXPECT_NE(refusal(plate(), {{{1, 15}, 3.0}}).find("reaches the border of the stock: its middle is 1 mm"),
            std::string::npos);
  EXPECT_NE(refusal(plate(), {{{1.5, 15}, 3.0}}).find("reaches the border"), std::string::npos);
  EXPECT_EQ(refusal(plate(), {{{1.51, 15}, 3.0}}), "accepted");
  const std::string both = refusal(plate(), {{{10, 15}, 3.0}, {{12, 15}, 2.0}});
  EXPECT_NE(both.find("the start hole of 2 at X12 Y15 comes to another one, the start hole of 3 at X10 Y15"),
            std::string::npos)
      << both;
  EXPECT_EQ(refusal(plate(), {{{10, 15}, 3.0}, {{12.6, 15}, 2.0}}), "accepted");
  // One in the other.
  EXPECT_NE(refusal(plate(), {{{10, 15}, 3.0}, {{10, 15}, 1.0}}).find("comes to another one"),
            std::string::npos);
}

TEST(StartHoles, InTubes) {
  const PrismBlank tube = *prismOf(CylinderShape{2, {0, 0, 0}, 20, 10, 5});
  EXPECT_EQ(refusal(tube, {{{15, 0}, 2.0}}), "accepted");
  EXPECT_NE(refusal(tube, {{{0, 0}, 2.0}}).find("is not in the stock"), std::string::npos);
  EXPECT_NE(refusal(tube, {{{11, 0}, 2.5}}).find("reaches the border"), std::string::npos);
}

}  // namespace
}  // namespace proveout
