// Expected step lists: tables of the NCT milling manual 18.1 and worked examples.
#include "core/nc/services/drilling.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace proveout {
namespace {

/// One letter a step, numbers where they matter: "r2" rapid, "f-4" feed, "s-2,0" shift, "d1" dwell, M codes.
std::string text(const DrillCycle& cycle) {
  std::vector<DrillStep> steps;
  EXPECT_EQ(expandDrillCycle(cycle, steps), DrillError::kNone);
  std::string out;
  for (const DrillStep& s : steps) {
    if (!out.empty()) out += ' ';
    switch (s.kind) {
      case DrillStepKind::kRapid:
        out += fmt::format("r{:g}", s.position);
        break;
      case DrillStepKind::kFeed:
        out += fmt::format("f{:g}", s.position);
        break;
      case DrillStepKind::kShift:
        out += fmt::format("s{:g},{:g}", s.shift.x() + 0.0, s.shift.y() + 0.0);
        break;
      case DrillStepKind::kDwell:
        out += fmt::format("d{:g}", s.dwell);
        break;
      case DrillStepKind::kSpindleForward:
        out += "M3";
        break;
      case DrillStepKind::kSpindleReverse:
        out += "M4";
        break;
      case DrillStepKind::kSpindleStop:
        out += "M5";
        break;
      case DrillStepKind::kSpindleOrient:
        out += "M19";
        break;
      case DrillStepKind::kCloseLoop:
        out += "loop";
        break;
      case DrillStepKind::kProgramStop:
        out += "M0";
        break;
    }
  }
  return out;
}

DrillCycle cycle(DrillCode code, double initial, double r, double bottom, bool to_r) {
  DrillCycle c;
  c.code = code;
  c.initial = initial;
  c.r = r;
  c.bottom = bottom;
  c.return_to_r = to_r;
  return c;
}

TEST(Drilling, PecksAsTheManualsExample) {
  DrillCycle c = cycle(DrillCode::kPeck, 20, 2, -30, true);
  c.peck = 6;
  c.clearance = 1;
  EXPECT_EQ(text(c), "r2 f-4 r2 r-3 f-10 r2 r-9 f-16 r2 r-15 f-22 r2 r-21 f-28 r2 r-27 f-30 r2");
  c.return_to_r = false;
  EXPECT_EQ(text(c), "r2 f-4 r2 r-3 f-10 r2 r-9 f-16 r2 r-15 f-22 r2 r-21 f-28 r2 r-27 f-30 r20");
  c.code = DrillCode::kChipBreak;
  c.return_to_r = true;
  EXPECT_EQ(text(c), "r2 f-4 r-3 f-10 r-9 f-16 r-15 f-22 r-21 f-28 r-27 f-30 r2");
}

TEST(Drilling, PecksTowardsPlusMirrorThoseTowardsMinus) {
  DrillCycle c = cycle(DrillCode::kPeck, -20, -2, 10, true);
  c.peck = 5;
  c.clearance = 1;
  EXPECT_EQ(text(c), "r-2 f3 r-2 r2 f8 r-2 r7 f10 r-2");
}

TEST(Drilling, PeckThatDividesTheDepthMakesNoEmptyPeck) {
  DrillCycle c = cycle(DrillCode::kChipBreak, 5, 0, -0.3, true);
  c.peck = 0.1;
  c.clearance = 0.05;
  EXPECT_EQ(text(c), "r0 f-0.1 r-0.05 f-0.2 r-0.15 f-0.3 r0");
}

TEST(Drilling, ApproachNeverGoesAboveR) {
  DrillCycle c = cycle(DrillCode::kPeck, 5, 0, -3, true);
  c.peck = 2;
  c.clearance = 5;
  EXPECT_EQ(text(c), "r0 f-2 r0 r0 f-3 r0");
}

TEST(Drilling, SimpleCyclesFollowTheTable) {
  DrillCycle c = cycle(DrillCode::kDrill, 50, 2, -25, false);
  c.dwell = 1;
  const std::pair<DrillCode, const char*> initial[] = {
      {DrillCode::kDrill, "r2 f-25 r50"},
      {DrillCode::kDrillDwell, "r2 f-25 d1 r50"},
      {DrillCode::kTapLeft, "r2 f-25 d1 M3 f2 M4 r50"},
      {DrillCode::kTap, "r2 f-25 d1 M4 f2 M3 r50"},
      {DrillCode::kRigidTap, "r2 loop f-25 d1 f2 r50"},
      {DrillCode::kBoreFeedOut, "r2 f-25 f2 r50"},
      {DrillCode::kBoreDwellFeedOut, "r2 f-25 d1 f2 r50"},
      {DrillCode::kBoreStop, "r2 f-25 M5 r50 M3"},
      {DrillCode::kBackBoreManual, "r2 f-25 M5 M0 r50 M3"},
      {DrillCode::kBoreManual, "r2 f-25 d1 M5 M0 r50 M3"},
  };
  for (const auto& [code, expected] : initial) {
    c.code = code;
    EXPECT_EQ(text(c), expected) << static_cast<int>(code);
  }
  c.return_to_r = true;
  const std::pair<DrillCode, const char*> at_r[] = {
      {DrillCode::kDrill, "r2 f-25 r2"},
      {DrillCode::kTap, "r2 f-25 d1 M4 f2 M3"},
      {DrillCode::kBoreFeedOut, "r2 f-25 f2"},
      {DrillCode::kBoreStop, "r2 f-25 M5 r2 M3"},
      {DrillCode::kBoreManual, "r2 f-25 d1 M5 M0 r2 M3"},
  };
  for (const auto& [code, expected] : at_r) {
    c.code = code;
    EXPECT_EQ(text(c), expected) << static_cast<int>(code);
  }
}

TEST(Drilling, FineBoringShiftsAtTheBottomAndBack) {
  DrillCycle c = cycle(DrillCode::kFineBore, 50, 2, -25, true);
  c.dwell = 1;
  c.shift = {-1, 0};
  EXPECT_EQ(text(c), "r2 f-25 d1 M19 s-1,0 r2 s1,0 M3");
  c.return_to_r = false;
  EXPECT_EQ(text(c), "r2 f-25 d1 M19 s-1,0 r50 s1,0 M3");
}

TEST(Drilling, BackBoringEntersShiftedAndBoresUpwards) {
  DrillCycle c = cycle(DrillCode::kBackBore, 50, -30, -20, false);
  c.shift = {-2, 0};
  const char* expected = "M19 s-2,0 r-30 s2,0 M3 f-20 M19 s-2,0 r50 s2,0 M3";
  EXPECT_EQ(text(c), expected);
  c.return_to_r = true;  // returns to the initial point all the same
  EXPECT_EQ(text(c), expected);
}

TEST(Drilling, TappingIsLockedAndBoringOutHasItsOwnFeed) {
  DrillCycle c = cycle(DrillCode::kTap, 10, 2, -8, false);
  std::vector<DrillStep> steps;
  ASSERT_EQ(expandDrillCycle(c, steps), DrillError::kNone);
  for (const DrillStep& s : steps) EXPECT_EQ(s.locked && s.thread, s.kind == DrillStepKind::kFeed);
  c.code = DrillCode::kBoreFeedOut;
  c.retract_factor = 2.5;
  ASSERT_EQ(expandDrillCycle(c, steps), DrillError::kNone);
  ASSERT_EQ(steps.size(), 4u);
  EXPECT_EQ(steps[1].feed_factor, 1.0);
  EXPECT_EQ(steps[2].feed_factor, 2.5);
  EXPECT_EQ(steps[2].operation, 7);
}

TEST(Drilling, PeckingRigidTapsBreakChipsOrReturnToR) {
  DrillCycle c = cycle(DrillCode::kRigidTapLeft, 10, 2, -8, true);
  c.peck = 6;
  c.clearance = 1;
  EXPECT_EQ(text(c), "r2 loop f-4 f-3 f-8 f2");
  c.tap_returns_to_r = true;
  c.orient_before_rigid_tap = true;
  EXPECT_EQ(text(c), "r2 M19 f-4 f2 f-3 f-8 f2");
}

TEST(Drilling, RefusesBadNumbers) {
  std::vector<DrillStep> steps(3);
  DrillCycle c = cycle(DrillCode::kPeck, 20, 2, -30, true);
  c.peck = 1e-9;
  EXPECT_EQ(expandDrillCycle(c, steps), DrillError::kTooManySteps);
  EXPECT_TRUE(steps.empty());
  c.peck = -1;
  EXPECT_EQ(expandDrillCycle(c, steps), DrillError::kBadPeck);
  c.peck = 1;
  c.clearance = -1;
  EXPECT_EQ(expandDrillCycle(c, steps), DrillError::kBadPeck);
  c.clearance = 1;
  c.retract_factor = 0;
  EXPECT_EQ(expandDrillCycle(c, steps), DrillError::kBadRetract);
  c.retract_factor = 1;
  c.bottom = std::numeric_limits<double>::infinity();
  EXPECT_EQ(expandDrillCycle(c, steps), DrillError::kNotFinite);
}

}  // namespace
}  // namespace proveout
