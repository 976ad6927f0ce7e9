// Parts that turning tools cut, without a grid, and what touches them: the exact part, contacts and measuring
// moves must answer as they do for upright tools.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "removal/contact/contact_query.h"
#include "removal/exact/swept_part.h"
#include "tests/property/random_moves.h"
#include "tests/support/exact_part_reference.h"
#include "tests/support/posed_motions.h"
#include "tests/unit/removal/cut_fixture.h"

namespace proveout {
namespace posed_part_test {
namespace {

Tool numbered(const std::string& option, int number) {
  Tool tool = test::tool(option);
  tool.number = number;
  tool.flute_length = 120.0;
  return tool;
}

struct Cuts {
  Toolpath path;
  std::vector<Tool> tools{numbered("1=flat:6", 1), numbered("1=ball:6", 2)};

  Cuts() { path.files = {"test"}; }
  Motion& add(int tool, const test::PosedMotion& motion, MotionKind kind = MotionKind::kFeed) {
    const Toolpath one = motion.path();
    Motion m = one.motions[0];
    m.tool = tool;
    m.kind = kind;
    m.axis = static_cast<std::int32_t>(path.axes.size());
    m.source.line = static_cast<std::uint32_t>(path.motions.size() + 1);
    path.axes.push_back(one.axes[0]);
    if (m.arc >= 0) {
      m.arc = static_cast<std::int32_t>(path.arcs.size());
      path.arcs.push_back(one.arcs[0]);
    }
    path.motions.push_back(m);
    return path.motions.back();
  }

  /// The distance to the nearest of many places of the tools, and how far a point of them goes between two.
  std::pair<double, double> nearest(const Vec3& p) const {
    constexpr int kPlaces = 3000;
    double least = 1e9, gap = 0.0;
    for (const Motion& m : path.motions) {
      const PosedWay way = posedWayOf(path, m);
      const PosedWay::Bounds bounds = way.boundsOn(0.0, 1.0);
      gap = std::max(gap, (bounds.tip.velocity + 40.0 * bounds.axis.velocity) / kPlaces);
      for (int i = 0; i <= kPlaces; ++i)
        least = std::min(least, test::fromTool(m.tool, p, way.at(static_cast<double>(i) / kPlaces)));
    }
    return {least, gap};
  }
};

const BoxShape& kBlank = test::kReferenceBlank;

/// One motion of each law.
Cuts randomCuts(test::RandomMoves& moves) {
  const auto point = [&] { return Vec3(moves.number(5, 35), moves.number(5, 25), moves.number(-6, -0.5)); };
  const auto axis = [&] { return Vec3(moves.number(-0.6, 0.6), moves.number(-0.6, 0.6), 1.0); };
  const auto swing = [&] {
    const Vec3 origin(400.0, 300.0, -480.0);
    const double a = moves.number(-30, 30), c = moves.number(-90, 90);
    return test::axesMotion(test::trunnion('A'),
                            test::axesAt(origin + Vec3(10, 8, 45.0) + moves.point(), a, c),
                            test::axesAt(origin + Vec3(20, 12, 45.0) + moves.point(),
                                         a + moves.number(-25, 25), c + moves.number(-50, 50)),
                            50.0, origin);
  };
  Cuts cuts;
  for (const int tool : {1, 2}) {
    cuts.add(tool, test::vectorMotion(point(), point(), axis(), axis()));
    cuts.add(tool, swing());
    test::PosedMotion tip = swing();
    tip.axis.law = PoseLaw::kTip;
    tip.motion.from = point(), tip.motion.to = point();
    cuts.add(tool, tip);
    test::PosedMotion cone = test::vectorMotion(point(), point(), axis(), axis());
    cone.is_arc = true;
    cone.arc.center = cone.motion.from + Vec3(moves.number(2, 6), 0, 0);
    cone.arc.sweep_rad = moves.number(-3, 3);
    cone.motion.to = cone.arc.center + Eigen::AngleAxisd(cone.arc.sweep_rad, Vec3::UnitZ()) *
                                           Vec3(cone.motion.from - cone.arc.center);
    cone.axis.law = PoseLaw::kCone;
    cuts.add(tool, cone);
  }
  return cuts;
}

TEST(PosedPart, IsTheBlankLessEveryPlaceOfTheTools) {
  test::RandomMoves moves(21);
  double off = 0.0, slack = 0.0;
  int material = 0, cut = 0;
  for (int round = 0; round < 3; ++round) {
    const Cuts cuts = randomCuts(moves);
    const auto part = makeSweptPart(kBlank, {{&cuts.path, &cuts.tools, {}}});
    ASSERT_TRUE(part.ok());
    for (int i = 0; i < 60; ++i) {
      const Vec3 p(moves.number(-1, 41), moves.number(-1, 31), moves.number(-11, 1));
      const auto [tool, gap] = cuts.nearest(p);
      const double depth = std::min(test::insideBlank(p), tool);
      const ExactPart::Sample s = (*part)->at(p, 100.0);
      slack = std::max(slack, gap);
      if (depth > 0.0) {
        ++material;
        off = std::max(off, std::abs(-s.value - depth));
        EXPECT_NEAR(-s.value, depth, gap) << p.transpose();
        EXPECT_LE(-s.value, depth + 1e-6) << p.transpose();  // places of the reference are places of the tool
      } else if (depth < -gap) {
        ++cut;
        EXPECT_GT(s.value, 0.0) << p.transpose();
      }
    }
  }
  std::printf("exact part: %d points of material within %.3g mm (reference %.3g), %d cut\n", material, off,
              slack, cut);
  EXPECT_GT(material, 30);
  EXPECT_GT(cut, 10);
}

TEST(PosedPart, PointsSettleOnTheSurfaceAndKnowTheirMotion) {
  test::RandomMoves moves(22);
  int made = 0;
  for (int round = 0; round < 2; ++round) {
    const Cuts cuts = randomCuts(moves);
    const auto part = makeSweptPart(kBlank, {{&cuts.path, &cuts.tools, {}}});
    ASSERT_TRUE(part.ok());
    for (int i = 0; i < 400; ++i) {
      const Vec3 from(moves.number(1, 39), moves.number(1, 29), moves.number(-7, 0));
      made += test::settles(**part, cuts, from) ? 1 : 0;
    }
  }
  EXPECT_GT(made, 30);
}

Vec3 leaning(double degrees) { return {std::sin(degToRad(degrees)), 0.0, std::cos(degToRad(degrees))}; }

/// The middle of a ball goes along a line while its axis turns in the plane of that: a round groove.
test::PosedMotion groove(const Vec3& from, const Vec3& to) {
  test::PosedMotion m =
      test::vectorMotion(from - 3.0 * leaning(-20), to - 3.0 * leaning(25), leaning(-20), leaning(25));
  auto pose = std::make_shared<PoseSweep>();
  pose->beyond = -3.0;
  m.axis.pose = pose;
  return m;
}

TEST(PosedContacts, ATiltThatDipsIsAsDeepAsItsRim) {
  for (const double grid : {0.37, 0.5, 1.0}) {
    Cuts cuts;
    cuts.add(1, test::vectorMotion({20, 15, 1}, {20, 15, 1}, leaning(0), leaning(25)), MotionKind::kRapid);
    const test::Cut cut = test::cut(kBlank, cuts.path, cuts.tools, grid);
    ASSERT_EQ(cut.summary.contacts.size(), 1u) << grid;
    const Contact& contact = cut.summary.contacts[0];
    const double deep = 3.0 * std::sin(degToRad(25.0)) - 1.0;
    std::printf("dipping rim on %g mm: depth off by %.3g, place by %.3g mm\n", grid, contact.depth_mm - deep,
                contact.where.z() + deep);
    EXPECT_EQ(contact.kind, ContactKind::kRapid);
    EXPECT_NEAR(contact.depth_mm, deep, 1e-3) << grid;
    EXPECT_NEAR(contact.where.z(), -deep, 1e-3) << grid;
    EXPECT_NEAR(contact.where.x(), 20.0 + 3.0 * std::cos(degToRad(25.0)), 0.05) << grid;
  }
}

TEST(PosedContacts, BelowAGrooveTheyCountFromThere) {
  for (const double grid : {0.5, 0.8}) {
    Cuts cuts;
    cuts.add(2, groove({14, 15, 0}, {26, 15, 0}));
    // The same again takes nothing; and lower by 0.2 mm.
    cuts.add(2, groove({26, 15, 0}, {14, 15, 0}), MotionKind::kRapid);
    EXPECT_TRUE(test::cut(kBlank, cuts.path, cuts.tools, grid).summary.contacts.empty()) << grid;
    cuts.add(2, groove({14, 15, -0.2}, {26, 15, -0.2}), MotionKind::kRapid);
    const test::Cut cut = test::cut(kBlank, cuts.path, cuts.tools, grid);
    ASSERT_EQ(cut.summary.contacts.size(), 1u) << grid;
    std::printf("below a groove on %g mm: depth off by %.3g\n", grid, cut.summary.contacts[0].depth_mm - 0.2);
    EXPECT_EQ(cut.summary.contacts[0].motion, 2u);
    EXPECT_NEAR(cut.summary.contacts[0].depth_mm, 0.2, 1e-3) << grid;
  }
}

TEST(PosedContacts, EachBlockHasItsOwn) {
  Cuts cuts;
  for (const double x : {10.0, 20.0, 30.0})
    cuts.add(1, test::vectorMotion({x, 15, 0.5}, {x, 15, 0.5}, leaning(0), leaning(25)), MotionKind::kRapid);
  cuts.path.motions[1].source.line = cuts.path.motions[0].source.line;
  const test::Cut cut = test::cut(kBlank, cuts.path, cuts.tools, 0.5);
  ASSERT_EQ(cut.summary.contacts.size(), 2u);
  EXPECT_EQ(cut.summary.contacts[0].motion, 0u);
  EXPECT_EQ(cut.summary.contacts[0].last, 1u);
  EXPECT_EQ(cut.summary.contacts[1].motion, 2u);
}

/// A measuring ball of radius 2 in a groove of radius 3: their middles are 1 mm apart.
TEST(PosedContacts, AProbeFindsTheGroove) {
  Cuts cuts;
  cuts.add(2, groove({-10, 15, 0}, {50, 15, 0}));
  cuts.tools.push_back(numbered("1=ball:4", 9));
  Progress progress;
  RemovalOptions options;
  options.resolution_mm = 0.8;
  const StockShape blank = kBlank;
  Result<Stock> stock = Stock::create(blank, options, progress);
  ASSERT_TRUE(stock.ok());
  ASSERT_TRUE(stock->remove(cuts.path, cuts.tools, options, progress).ok());
  SurfaceOptions fine;
  fine.simplify_mm = ContactQuery::kMeshMm;
  Result<StockSurface> surface = stock->surface(fine, progress);
  ASSERT_TRUE(surface.ok());
  const ContactQuery query(std::move(*surface), cuts.path, cuts.tools, &blank, options.resolution_mm);
  double off = 0.0;
  for (const double x : {8.3, 20.0, 31.1}) {
    for (const double y : {0.0, 0.3, 0.8}) {
      const Vec3 from(x, 15 + y, 4), to(x, 15 + y, -6);
      const auto t = query.firstContact(cuts.tools.back(), from, to);
      ASSERT_TRUE(t.has_value()) << x << ' ' << y;
      const double z = (from + *t * (to - from)).z();
      off = std::max(off, std::abs(z - (-std::sqrt(1.0 - y * y) - 2.0)));
    }
  }
  std::printf("probe in a groove: off by %.3g mm\n", off);
  EXPECT_LT(off, 1e-3);
}

}  // namespace
}  // namespace posed_part_test
}  // namespace proveout
