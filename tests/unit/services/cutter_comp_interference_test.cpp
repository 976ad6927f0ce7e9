// Interference check: the cases that the NCT milling manual 15.5.7 describes, with numbers of our own.
#include <gtest/gtest.h>

#include "comp_mill.h"
#include "core/nc/services/cutter_comp.h"

namespace proveout {
namespace {

using comp_test::Mill;

CutterCompPolicy policy(bool alarm, int look_ahead = 0) {
  CutterCompPolicy p;
  p.interference_alarm = alarm;
  p.extra_look_ahead = look_ahead;
  return p;
}

Mill& filletTooSmall(Mill& r) {
  return r.side(10)
      .line(-50, 0)
      .line(0, 0)
      .line(40, 0)
      .arc(45, 5, 40, 5, true)
      .line(45, 45)
      .line(45, 90)
      .off()
      .line(45, 140);
}

TEST(Interference, FilletSmallerThanTheCutter) {
  Mill mend({-100, 0}, policy(false));
  filletTooSmall(mend).expectPath({{-50, 10}, {0, 10}, {35, 10}, {35, 45}, {35, 90}, {45, 140}});
  ASSERT_EQ(mend.out.notes.size(), 1u);
  EXPECT_EQ(mend.out.notes[0].warning, CompWarning::kRepaired);
  EXPECT_EQ(mend.out.notes[0].tag, 4u);
  Mill stop({-100, 0}, policy(true));
  filletTooSmall(stop);
  EXPECT_EQ(stop.status.error, CompError::kInterference);
  EXPECT_EQ(stop.status.tag, 4u);
  EXPECT_EQ(stop.status.stop_tag, 3u);
}

TEST(Interference, FilletAsLargeAsTheCutterFits) {
  Mill r({-100, 0}, policy(true));
  r.side(5);
  r.line(-50, 0).line(0, 0).line(40, 0).arc(45, 5, 40, 5, true).line(45, 45).line(45, 90).off().line(45, 140);
  r.expectPath({{-50, 5}, {0, 5}, {40, 5}, {40, 45}, {40, 90}, {45, 140}});
}

TEST(Interference, StepSmallerThanTheCutter) {
  Mill r({-100, 0}, policy(false));
  r.side(10)
      .line(-50, 0)
      .line(0, 0)
      .line(40, 0)
      .line(41.5, 2.598076)
      .line(21.5, 37.239092)
      .line(1.5, 71.880108);
  r.off().line(-20, 120);
  ASSERT_TRUE(r.status.ok());
  EXPECT_NEAR((r.moves()[2].to - Vec3(25.6795, 10, 0)).norm(), 0, 1e-3);
}

TEST(Interference, NarrowSlotIsSkippedOnlyWithMoreLookAhead) {
  const auto slot = [](int look_ahead) {
    Mill r({-100, 0}, policy(false, look_ahead));
    r.side(5).line(-50, 0).line(0, 0).line(40, 0).line(40, -30).line(48, -30).line(48, 0).line(90, 0).line(
        120, 0);
    r.off().line(150, 0);
    return r;
  };
  EXPECT_EQ(slot(0).status.error, CompError::kInterference);
  EXPECT_EQ(slot(0).status.stop_tag, 4u);
  for (int look_ahead : {1, 2, 3}) {
    slot(look_ahead).expectPath({{-50, 5}, {0, 5}, {43, 5}, {90, 5}, {120, 5}, {150, 0}});
  }
}

TEST(Interference, SmallArcBetweenOuterCornersIsPeeledOff) {
  Mill r({-100, 0}, policy(false));
  const double c30 = std::cos(degToRad(30)), s30 = 0.5;
  const Vec2 p(10.9282032, -2.9282032);
  r.side(10).line(-50, 0).line(0, 0).arc(p.x(), p.y(), 6.9282032, 4, true);
  r.line(p.x() + 60 * c30, p.y() - 60 * s30).line(p.x() + 90 * c30, p.y() - 90 * s30).off();
  r.line(p.x() + 150 * c30, p.y() - 150 * s30);
  ASSERT_TRUE(r.status.ok());
  const auto pieces = r.moves();
  EXPECT_NEAR((pieces[1].to - Vec3(5.7735, 10, 0)).norm(), 0, 1e-3);
  EXPECT_NEAR((pieces[2].to - Vec3(7.6603, 6.7321, 0)).norm(), 0, 1e-3);
  EXPECT_NEAR((pieces[3].to - Vec3(10.9282, 8.6188, 0)).norm(), 0, 1e-3);
}

TEST(Interference, ParallelNeighboursCannotBeMended) {
  Mill r({-100, 0}, policy(false));
  r.side(10).line(-50, 0).line(0, 0).line(40, 0).line(40, 3).line(0, 3).line(-50, 3).off().line(-90, 3);
  EXPECT_EQ(r.status.error, CompError::kInterference);
  EXPECT_EQ(r.status.tag, 4u);
}

TEST(Interference, NarrowNeckNeedsLongLookAhead) {
  const auto neck = [](int look_ahead) {
    Mill r({-100, 0}, policy(false, look_ahead));
    r.side(5).line(-50, 0).line(0, 0).line(40, 0).line(40, -10).line(20, -10).line(20, -40).line(68, -40);
    r.line(68, -10).line(48, -10).line(48, 0).line(90, 0).line(120, 0).off().line(150, 0);
    return r.status;
  };
  for (int n = 0; n <= 3; ++n) EXPECT_TRUE(neck(n).ok()) << n;
  for (int n = 4; n <= 5; ++n) {
    EXPECT_EQ(neck(n).error, CompError::kInterference) << n;
    EXPECT_EQ(neck(n).stop_tag, 4u) << n;
  }
  for (int n = 6; n <= 8; ++n) {
    EXPECT_EQ(neck(n).error, CompError::kInterference) << n;
    EXPECT_EQ(neck(n).stop_tag, 3u) << n;
  }
}

TEST(Interference, LookAheadMendsWhereLeastIsLost) {
  // A pocket with one fillet too small: seen early, yet only the fillet is left out.
  for (int look_ahead = 0; look_ahead <= 8; ++look_ahead) {
    Mill r({50, 20}, policy(false, look_ahead));
    r.side(5)
        .line(50, 0)
        .line(100, 0)
        .line(100, 57)
        .arc(97, 60, 97, 57, true)
        .line(0, 60)
        .line(0, 0)
        .line(50, 0);
    r.off().line(50, 20);
    r.expectPath({{50, 5}, {95, 5}, {95, 55}, {5, 55}, {5, 5}, {50, 5}, {50, 20}});
  }
}

TEST(Interference, DroppedBlocksKeepTheirFunctions) {
  Mill r({-100, 0}, policy(false));
  r.side(10)
      .line(-50, 0)
      .line(0, 0)
      .line(40, 0)
      .arc(45, 5, 40, 5, true)
      .none(-3)
      .line(45, 45)
      .line(45, 90)
      .off();
  r.line(45, 140);
  ASSERT_TRUE(r.status.ok());
  int found = 0;
  for (const CompPiece& p : r.out.pieces) {
    if (p.role != CompPiece::Role::kPassThrough) continue;
    ++found;
    EXPECT_EQ(p.tag, 5u);
    EXPECT_NEAR((p.to - Vec3(35, 10, -3)).norm(), 0, 1e-9);
  }
  EXPECT_EQ(found, 1);
}

TEST(Interference, SwitchedOffItCutsIn) {
  CutterCompPolicy p;
  p.interference_check = false;
  Mill r({-100, 0}, p);
  r.side(10).line(-50, 0).line(0, 0).line(40, 0).line(40, 3).line(0, 3).line(-50, 3).off().line(-90, 3);
  EXPECT_TRUE(r.status.ok());
  r.expectContinuous();
}

}  // namespace
}  // namespace proveout
