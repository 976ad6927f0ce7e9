// Tools with undercuts, necks and several parts in the stock: removed volumes against closed forms, and
// contacts of what does not cut.
#include <cmath>

#include "tests/unit/removal/cut_fixture.h"

namespace proveout::test {
namespace {

constexpr double kGrid = 0.5;
const BoxShape kBlank{{-10, -15.1, -20}, {10, 15.1, 0}};  // 20 mm long in x

double removed(const Cut& c) { return c.initial - c.volume; }

/// A cut with tool 1 all through the blank along x at a height, then the same with tool 2.
Cut cutBoth(const char* first, double first_z, const char* second, double second_z) {
  PathMaker path(1), then(2);
  path.line({-40, 0.13, first_z}, {40, 0.13, first_z});
  then.line({-40, 0.13, second_z}, {40, 0.13, second_z});
  Toolpath both = path.path();
  both.motions.push_back(then.path().motions[0]);
  return cut(kBlank, both, {tool(first), tool(second)}, kGrid);
}

/// Leaves that lie on one face of the blank are meshed and measured as a whole: wherever the slot and its end
/// stand beside their borders, nothing of its edges may get into them.
TEST(ToolCut, SlotsBesideLeavesOfTheBlanksFaces) {
  constexpr double kFine = 0.25;
  for (int k = 0; k < 16; ++k) {  // a leaf is 8 steps of the grid wide
    const double shift = 0.5 * k * kFine + 0.03, depth = 3.0 + 0.6 * k * kFine, end = 6.2 - 0.7 * k * kFine;
    const Cut c = cut(kBlank, PathMaker().line({-40, shift, -depth}, {end, shift, -depth}).path(),
                      {tool("1=flat:6")}, kFine);
    const double expected = depth * (6 * (end + 10) + kPi * 9 / 2);
    EXPECT_NEAR(removed(c), expected, 1e-4 * expected) << k;
    EXPECT_NEAR(c.initial - c.mesh_volume, expected, 2e-3 * expected) << k;
  }
}

TEST(ToolCut, TSlotInAnOpenSlot) {
  const Cut c = cutBoth("1=flat:10", -15.2, "2=tslot:20:5:8", -15.2);
  EXPECT_NEAR(removed(c), 20 * (10 * 15.2 + 10 * 5), 0.02);
  EXPECT_NEAR(c.initial - c.mesh_volume, 20 * (10 * 15.2 + 10 * 5), 0.02);
  EXPECT_TRUE(c.summary.contacts.empty());
}

TEST(ToolCut, TSlotWithoutAnOpenSlotRubsItsNeck) {
  const Cut c = cut(kBlank, PathMaker().line({-40, 0.13, -15.2}, {40, 0.13, -15.2}).path(),
                    {tool("1=tslot:20:5:8")}, kGrid);
  EXPECT_NEAR(removed(c), 20 * 20 * 5, 0.02);  // the neck finds, it does not cut
  ASSERT_EQ(c.summary.contacts.size(), 1u);
  EXPECT_EQ(c.summary.contacts[0].kind, ContactKind::kShank);
}

TEST(ToolCut, DovetailUndercutsItsWalls) {
  const Cut c = cutBoth("1=flat:8", -8.2, "2=dovetail:20:60:8.3:9", -8.2);
  const double slope = 1 / std::tan(degToRad(60));
  const double expected = 20 * 8.2 * (10 + 10 - 8.2 * slope);
  EXPECT_NEAR(removed(c), expected, 0.02);
  EXPECT_NEAR(c.initial - c.mesh_volume, expected, 0.05);
  EXPECT_TRUE(c.summary.contacts.empty());
}

TEST(ToolCut, LollipopLeavesARoundGroove) {
  const Cut c = cutBoth("1=flat:5", -10.2, "2=lollipop:12:4", -14.2);
  // A round bar of 12 whose centre is at -8.2, and the open slot of 5 above and beside it.
  const double half = std::sqrt(36 - 2.5 * 2.5);  // where the slot's walls meet the bar
  const double segment = 36 * std::asin(2.5 / 6) - 2.5 * half;
  const double expected = 20 * (kPi * 36 + 5 * (8.2 - half) - segment);
  EXPECT_NEAR(removed(c), expected, 2e-4 * expected);
}

TEST(ToolCut, CornerRoundingFormLeavesARoundEdge) {
  Tool form;
  form.number = 1;
  form.type = ToolType::kForm;
  form.diameter = 10;
  form.outline = {{2, 0}, {5, 3, -3}, {5, 6}};
  ASSERT_TRUE(validateTool(form).ok());
  const BoxShape block{{-10, -15.1, -20}, {10, 0.1, 0}};
  const Cut c = cut(block, PathMaker().line({-40, 2.1, -3}, {40, 2.1, -3}).path(), {form}, 0.25);
  // A radius of 3 takes a square less a quarter disc; the tool may be thicker by its chords.
  const double expected = 20 * (9 - kPi * 9 / 4);
  EXPECT_GE(removed(c), expected - 2e-3 * expected);
  EXPECT_LE(removed(c), expected + 2e-3 * expected + 20 * 3 * kPi / 2 * kHollowArcToleranceMm);
}

TEST(ToolCut, ThreadMillCutsARingForEveryTooth) {
  Tool mill;
  mill.number = 1;
  mill.type = ToolType::kThreadMill;
  mill.diameter = 10;
  mill.pitch = 3;
  mill.teeth = 2;
  mill.crest_flat = 0.5;
  mill.root_diameter = 8;
  mill.neck_diameter = 6;
  ASSERT_TRUE(validateTool(mill).ok());
  // A bore of 24, and a full circle of radius 9.2 inside it: crests reach 14.2, roots 13.2.
  const BoxShape block{{-15.1, -15.1, -10}, {15.1, 15.1, 0}};
  PathMaker bore(2), thread(1);
  bore.line({7, 0, 5}, {7, 0, -12}).arc({7, 0, -12}, Vec3::Zero(), Vec3::UnitZ(), 360);
  thread.arc({9.2, 0, -7.1}, Vec3::Zero(), Vec3::UnitZ(), 360);
  Toolpath both = bore.path();
  both.arcs.push_back(thread.path().arcs[0]);
  Motion turn = thread.path().motions[0];
  turn.arc = 1;
  both.motions.push_back(turn);
  Tool cutter = tool("2=flat:10");
  const Cut c = cut(block, both, {mill, cutter}, 0.25);
  const double flank = std::tan(degToRad(30)), height = 3 + 2 * flank + 0.5;
  const auto disc = [](double r) { return kPi * r * r; };
  const auto frustum = [](double a, double b, double h) { return kPi / 3 * h * (a * a + a * b + b * b); };
  const double teeth = 2 * (2 * frustum(13.2, 14.2, flank) + disc(14.2) * 0.5);
  const double core = disc(13.2) * (height - 2 * (2 * flank + 0.5));
  // The bore ends where the flat's circle of radius 7 + 5 is, its middle is cut where the cutter reaches it.
  const double middle = disc(2.0);
  const double expected = (disc(12) - middle) * 10 + teeth + core - disc(12) * height;
  EXPECT_NEAR(removed(c), expected, 2e-4 * expected);
}

}  // namespace
}  // namespace proveout::test
