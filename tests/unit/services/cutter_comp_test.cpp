// Cutter compensation against worked examples (NCT milling manual 15.5) and closed forms.
#include "core/nc/services/cutter_comp.h"

#include <gtest/gtest.h>

#include <limits>

#include "comp_mill.h"

namespace proveout {
namespace {

using comp_test::Expected;
using comp_test::Mill;

TEST(CutterComp, SquareOutsideRight) {
  Mill r({-40, -40});
  r.side(-5).line(0, 0).line(60, 0).line(60, 60).line(0, 60).line(0, 0).off().line(-40, -40);
  r.expectPath({{0, -5}, {65, -5}, {65, 65}, {-5, 65}, {-5, 0}, {-40, -40}});
  EXPECT_FALSE(r.comp.pending());
  EXPECT_FALSE(r.comp.active());
}

TEST(CutterComp, CircleInsideWithTangentEntry) {
  Mill r({0, 0});
  r.side(-10).line(10, 50).arc(60, 0, 10, 0, false).arc(60, 0, 0, 0, false).arc(10, -50, 10, 0, false);
  r.off().line(0, 0);
  r.expectPath(
      {{10, 40}, {50, 0, Vec2(10, 0), -90}, {50, 0, Vec2(0, 0), -360}, {10, -40, Vec2(10, 0), -90}, {0, 0}});
}

TEST(CutterComp, StartWithoutMotionBeginsPerpendicular) {
  const std::vector<Expected> path = {
      {-36.4645, -43.5355}, {2.0711, -5}, {65, -5}, {65, 65}, {-5, 65}, {-5, 0}, {0, 0}, {-40, -40}};
  Mill r({-40, -40});
  r.side(-5).none().line(0, 0).line(60, 0).line(60, 60).line(0, 60).line(0, 0).off().none().line(-40, -40);
  r.expectPath(path);
  Mill zero({-40, -40});
  zero.side(-5).line(-40, -40).line(0, 0).line(60, 0).line(60, 60).line(0, 60).line(0, 0);
  zero.off().line(0, 0).line(-40, -40);
  zero.expectPath(path);
}

TEST(CutterComp, BlocksWithoutDisplacementStandPerpendicular) {
  Mill r({-10, -40});
  r.side(-5).line(0, 0).line(0, 0).line(60, 0).line(60, 60).line(0, 60).line(0, 0).line(0, 0);
  r.off().line(-40, -10);
  r.expectPath({{4.8507, -1.2127}, {0, -5}, {65, -5}, {65, 65}, {-5, 65}, {-5, 0}, {-40, -10}});
}

TEST(CutterComp, HexagonInsideWithAuxiliaryLines) {
  Mill r({0, 0});
  const double h = 86.602540378;
  r.side(10).lineTowards(100, 0, {50, h}).line(50, h).line(-50, h).line(-100, 0).line(-50, -h).line(50, -h);
  r.line(100, 0).off().lineTowards(0, 0, {-50, h});
  r.expectPath({{88.453, 0},
                {44.2265, 76.603},
                {-44.2265, 76.603},
                {-88.453, 0},
                {-44.2265, -76.603},
                {44.2265, -76.603},
                {88.453, 0},
                {0, 0}});
}

TEST(CutterComp, SideChangeOnAFullCircleTakesMoreThanATurn) {
  Mill r({100, 0});
  r.side(10).line(80, 0).line(50, 0).side(-10).arc(50, 0, 0, 0, true).side(10).line(80, 0).off().line(100, 0);
  r.expectPath({{80, -10}, {59.1608, -10}, {59.1608, 10, Vec2(0, 0), 379.1881}, {80, 10}, {100, 0}});
}

TEST(CutterComp, KeptVectorsDoNotTurnAtCorners) {
  Mill r({-100, 0});
  r.side(-5).line(-50, 0).line(0, 0).line(40, 0).keep(90, 0).keep(90, 70).keep(90, 0).line(150, 0).line(200,
                                                                                                        0);
  r.off().line(250, 0);
  r.expectPath({{-50, -5}, {0, -5}, {40, -5}, {90, -5}, {90, 65}, {90, -5}, {150, -5}, {200, -5}, {250, 0}});
}

TEST(CutterComp, CornerArcsRollAboutTheCorner) {
  Mill r({-50, 0});
  r.side(5).line(0, 0).line(100, 0).cornerArc().arc(180, -80, 180, 0, true).line(250, -80).off().line(300, 0);
  const auto pieces = r.moves();
  ASSERT_TRUE(r.status.ok());
  ASSERT_GE(pieces.size(), 4u);
  EXPECT_NEAR((pieces[1].to - Vec3(100, 5, 0)).norm(), 0, 1e-9);
  EXPECT_TRUE(pieces[2].is_arc);
  EXPECT_NEAR(pieces[2].sweep_rad, -kPi / 2, 1e-9);
  EXPECT_NEAR((pieces[2].to - Vec3(105, 0, 0)).norm(), 0, 1e-9);
  EXPECT_TRUE(pieces[3].is_arc);
  EXPECT_NEAR((pieces[3].center - Vec2(180, 0)).norm(), 0, 1e-9);
  Mill given({-50, 0});
  given.side(5).line(0, 0).line(100, 0).cornerArc(Vec2(50, -60)).off().line(210, 30);
  given.expectPath({{0, 5}, {100, 5}, {103.8411, 3.2009, Vec2(100, 0)}, {210, 30}});
}

TEST(CutterComp, GrooveWithCornerArcsAndPlunge) {
  Mill r({-30, 150});
  r.side(-5).line(0, 86.603).none(-2).line(-50, 0).cornerArc().line(50, 0).cornerArc().line(0, 86.603);
  r.cornerArc(Vec2(-50, -86.603)).none(5).line(-40, 86.603).off().line(-40, 120);
  r.expectPath({{-4.3301, 89.103},
                {-54.3301, 2.5},
                {-50, -5, Vec2(-50, 0), 120},
                {50, -5},
                {54.3301, 2.5, Vec2(50, 0), 120},
                {4.3301, 89.103},
                {-4.3301, 89.103, Vec2(0, 86.603), 120},
                {-40, 91.603},
                {-40, 120}},
               1e-3);
  // The plunge comes after the start-up move, the retract after the last corner arc.
  ASSERT_EQ(r.out.pieces[1].role, CompPiece::Role::kPassThrough);
  EXPECT_EQ(r.out.pieces[1].to.z(), -2);
  EXPECT_EQ(r.out.pieces[8].role, CompPiece::Role::kPassThrough);
  EXPECT_EQ(r.out.pieces[8].to.z(), 5);
}

TEST(CutterComp, SpiralsUseTheLocalRadius) {
  const auto spiral = [](double x) {
    Mill r({x, 0});
    CompBlock b;
    r.side(5).line(x < 50 ? x + 10 : x - 10, 0).line(50, 0);
    b.shape = CompBlock::Shape::kArc;
    b.to = {-20, 0, 0};
    b.sweep_rad = kPi;
    b.active = true;
    b.offset = 5;
    if (r.status.ok()) r.status = r.comp.push(b, r.out);
    return r;
  };
  Mill from_inside = spiral(0);
  from_inside.line(-30, 0).off().line(-60, 0);  // the spiral ends at (-20, 0) heading -Y
  auto pieces = from_inside.moves();
  ASSERT_TRUE(from_inside.status.ok());
  EXPECT_NEAR((pieces[1].to - Vec3(44.7214, 5, 0)).norm(), 0, 1e-4);
  EXPECT_NEAR((pieces[2].to - Vec3(-15, 0, 0)).norm(), 0, 1e-9);
  EXPECT_NEAR((pieces[3].to - Vec3(-15, -5, 0)).norm(), 0, 1e-9);
  Mill from_outside = spiral(90);
  from_outside.line(-30, 0).off().line(-60, 0);
  pieces = from_outside.moves();
  ASSERT_TRUE(from_outside.status.ok());
  EXPECT_NEAR((pieces[1].to - Vec3(45, -5, 0)).norm(), 0, 1e-9);
  EXPECT_NEAR((pieces[2].to - Vec3(45, 0, 0)).norm(), 0, 1e-9);
  EXPECT_NEAR(pieces[3].sweep_rad, kPi, 1e-9);
}

TEST(CutterComp, FlushRunsToTheProgrammedPointAndGoesOnFromThere) {
  Mill r({-100, 0});
  r.side(10).line(-50, 0).line(0, 0).line(80, -50).flush().none().line(160, 0).line(200, 0).off().line(250,
                                                                                                       0);
  r.expectPath({{-50, 10}, {2.868, 10}, {80, -50}, {157.132, 10}, {200, 10}, {250, 0}});
}

TEST(CutterComp, ZeroDisplacementInside) {
  Mill r({-80, -100});
  r.side(-10).line(-40, -50).line(0, 0).line(40, 50).line(40, 50).line(130, 50).line(180, 30).off().line(300,
                                                                                                         30);
  const auto pieces = r.moves();
  ASSERT_TRUE(r.status.ok());
  ASSERT_GE(pieces.size(), 5u);
  EXPECT_NEAR((pieces[2].to - Vec3(47.8087, 43.753, 0)).norm(), 0, 1e-3);
  EXPECT_NEAR((pieces[3].to - Vec3(40, 40, 0)).norm(), 0, 1e-9);
  EXPECT_NEAR((pieces[4].to - Vec3(128.0742, 40, 0)).norm(), 0, 1e-3);
}

/// The points between the line (-50,0)->(0,0) and a line at `delta` degrees.
std::vector<Vec2> cornerPoints(double delta, double rho, CutterCompPolicy policy = {}) {
  Mill r({-100, 0}, policy);
  const double a = degToRad(delta);
  r.side(rho).line(-50, 0).line(0, 0).line(60 * std::cos(a), 60 * std::sin(a));
  r.line(120 * std::cos(a), 120 * std::sin(a)).off().line(180 * std::cos(a), 180 * std::sin(a));
  EXPECT_TRUE(r.status.ok());
  std::vector<Vec2> points;
  for (const CompPiece& p : r.moves()) {
    if (p.tag == 2) points.push_back(p.to.head<2>());
  }
  return points;
}

void expectPoints(const std::vector<Vec2>& got, const std::vector<Vec2>& expected) {
  ASSERT_EQ(got.size(), expected.size());
  for (std::size_t i = 0; i < got.size(); ++i) {
    EXPECT_NEAR((got[i] - expected[i]).norm(), 0, 1e-4) << got[i].transpose();
  }
}

TEST(CutterComp, CornerListsOfLines) {
  expectPoints(cornerPoints(90, 10), {{-10, 10}});
  expectPoints(cornerPoints(45, 10), {{-4.1421, 10}});
  expectPoints(cornerPoints(0, 10), {{0, 10}});
  expectPoints(cornerPoints(-60, 10), {{5.7735, 10}});
  expectPoints(cornerPoints(-90, 10), {{10, 10}});
  expectPoints(cornerPoints(-135, 10), {{10, 10}, {14.1421, 0}});
  expectPoints(cornerPoints(180, 10), {{10, 10}, {10, -10}});
  expectPoints(cornerPoints(90, -10), {{10, -10}});
  expectPoints(cornerPoints(-60, -10), {{-5.7735, -10}});
  expectPoints(cornerPoints(-135, -10), {{-24.1421, -10}});
  expectPoints(cornerPoints(180, -10), {{10, -10}, {10, 10}});
}

TEST(CutterComp, RoundOuterCornersOnRequest) {
  CutterCompPolicy policy;
  policy.outer_corner = CompOuterCorner::kArc;
  expectPoints(cornerPoints(-90, 10, policy), {{0, 10}, {10, 0}});
  expectPoints(cornerPoints(90, -10, policy), {{0, -10}, {10, 0}});
  expectPoints(cornerPoints(180, 10, policy), {{0, 10}, {0, -10}});
  expectPoints(cornerPoints(90, 10, policy), {{-10, 10}});
}

/// Points of block `tag` in a run.
std::vector<Vec2> pointsOf(const Mill& r, std::uint64_t tag) {
  std::vector<Vec2> points;
  for (const CompPiece& p : r.moves()) {
    if (p.tag == tag) points.push_back(p.to.head<2>());
  }
  return points;
}

TEST(CutterComp, CornerListsWithArcs) {
  const auto lineArc = [](double cx, double cy, bool ccw) {
    Mill r({-100, 0});
    const Vec2 c(cx, cy);
    const Vec2 end = 2 * c;  // half a turn on
    r.side(10).line(-50, 0).line(0, 0).arc(end.x(), end.y(), cx, cy, ccw).flush();
    return pointsOf(r, 2);
  };
  expectPoints(lineArc(-30, 0, true), {{-12.6795, 10}});
  expectPoints(lineArc(-30, 0, false), {{10, 10}, {10, 0}});
  expectPoints(lineArc(-25.980762, -15, false), {{5.7735, 10}, {8.6603, 5}});
  expectPoints(lineArc(-21.213203, 21.213203, false), {{10, 10}, {14.1421, 0}, {7.0711, -7.0711}});
  const auto arcLine = [](double delta) {
    Mill r({-30, 100});
    const double a = degToRad(delta);
    r.side(10)
        .line(-30, 60)
        .line(-30, 30)
        .arc(0, 0, 0, 30, true)
        .line(60 * std::cos(a), 60 * std::sin(a))
        .flush();
    return pointsOf(r, 3);
  };
  // The arc's own end comes first; at an inner corner it is the corner.
  expectPoints(arcLine(90), {{-10, 12.6795}});
  expectPoints(arcLine(-90), {{0, 10}, {10, 10}});
  expectPoints(arcLine(-135), {{0, 10}, {10, 10}, {14.1421, 0}});
  Mill inner({-30, 100});
  inner.side(10).line(-30, 60).line(-30, 30).arc(0, 0, 0, 30, true).arc(-80, 0, -40, 0, true).flush();
  expectPoints(pointsOf(inner, 3), {{-16, 18}});
  Mill outer({-30, -100});
  outer.side(10).line(-30, -60).line(-30, -30).arc(0, 0, 0, -30, false).arc(-80, 0, -40, 0, false).flush();
  expectPoints(pointsOf(outer, 3), {{0, 10}, {10, 10}, {10, 0}});
}

TEST(CutterComp, StartAndCancelTypes) {
  const auto start = [](double delta, CompRamp ramp) {
    CutterCompPolicy policy;
    policy.start_ramp = ramp;
    Mill r({-50, 0}, policy);
    const double a = degToRad(delta);
    r.side(10).line(0, 0).line(60 * std::cos(a), 60 * std::sin(a)).flush();
    return pointsOf(r, 1);
  };
  expectPoints(start(90, CompRamp::kA), {{-10, 0}});
  expectPoints(start(90, CompRamp::kB), {{-10, 0}});
  expectPoints(start(-60, CompRamp::kA), {{8.6603, 5}});
  expectPoints(start(-60, CompRamp::kB), {{5.7735, 10}});
  expectPoints(start(-135, CompRamp::kA), {{7.0711, -7.0711}});
  expectPoints(start(-135, CompRamp::kB), {{10, 10}, {14.1421, 0}});
  const auto cancel = [](double delta, CompRamp ramp) {
    CutterCompPolicy policy;
    policy.cancel_ramp = ramp;
    Mill r({-100, 0}, policy);
    const double a = degToRad(delta);
    r.side(10).line(-50, 0).line(0, 0).off().line(60 * std::cos(a), 60 * std::sin(a));
    return pointsOf(r, 2);
  };
  expectPoints(cancel(90, CompRamp::kB), {{0, 10}});
  expectPoints(cancel(-60, CompRamp::kA), {{0, 10}});
  expectPoints(cancel(-60, CompRamp::kB), {{5.7735, 10}});
  expectPoints(cancel(-135, CompRamp::kA), {{0, 10}});
  expectPoints(cancel(-135, CompRamp::kB), {{10, 10}, {14.1421, 0}});
}

TEST(CutterComp, NewRadiusActsAtTheEndOfItsBlock) {
  Mill r({-100, 0});
  r.side(10).line(-50, 0).line(0, 0).side(5).line(50, 0).line(50, 50).flush();
  r.expectPath({{-50, 10}, {0, 10}, {45, 5}, {50, 50}});
  Mill zero({-100, 0});
  zero.side(10).line(-50, 0).line(0, 0).side(0).line(50, 0).side(10).line(50, 50).line(0, 50).flush();
  zero.expectPath({{-50, 10}, {0, 10}, {50, 0}, {40, 40}, {0, 50}});
  Mill arc({-100, 0});
  arc.side(10).line(-50, 0).line(0, 0).side(5).arc(30, 30, 0, 30, true).line(30, 60).line(30, 90).off();
  arc.line(30, 120);
  arc.expectPath({{-50, 10}, {0, 10}, {25, 30, Vec2(0, 30), 90}, {25, 60}, {25, 90}, {30, 120}});
}

TEST(CutterComp, SideChangeWithoutIntersection) {
  Mill straight({-100, 0});
  straight.side(-10).line(-50, 0).line(0, 0).side(10).line(50, 0).line(90, 0).off().line(120, 0);
  straight.expectPath({{-50, -10}, {0, 10}, {50, 10}, {90, 10}, {120, 0}});
  Mill back({-100, 0});
  back.side(-10).line(-50, 0).line(0, 0).side(10).line(-50, 0).line(-90, 0).off().line(-120, 0);
  back.expectPath({{-50, -10}, {0, -10}, {-50, -10}, {-90, -10}, {-120, 0}});
  Mill arc({-30, -100});
  arc.side(-10).line(-30, -60).line(-30, -30).arc(0, 0, 0, -30, false).side(10).line(50, 0).line(90, 0).off();
  arc.line(120, 0);
  arc.expectPath(
      {{-20, -60}, {-20, -30}, {0, 10, Vec2(7.8885, -18.9443), -96.379}, {50, 10}, {90, 10}, {120, 0}});
}

TEST(CutterComp, ContourOfLinesAndLargeArcs) {
  // The contour of manual 17.3.5 with its meeting points filled in.
  Mill r({280, 0});
  r.side(-5).line(230, 20).line(199.7612, 35.1194).arc(135.7571, 87.9285, 150, 40, true);
  r.arc(61.0208, 78.9792, 100, 70, true).line(32, 108).line(10, 108).off().line(10, 130);
  r.expectPath({{232.2361, 24.4721},
                {204.9674, 38.1065},
                {138.2363, 93.7272, Vec2(150, 40), 104.3231},
                {58.8528, 88.2183, Vec2(100, 70), 124.2969},
                {34.0711, 113},
                {10, 113},
                {10, 130}});
}

TEST(CutterComp, HelixKeepsItsHeightAndTags) {
  Mill r({60, 0});
  r.side(-5).line(50, 0);
  CompBlock b;
  b.shape = CompBlock::Shape::kArc;
  b.to = {50, 0, -3};
  b.sweep_rad = 2 * kPi;
  b.active = true;
  b.offset = -5;
  b.tag = 99;
  ASSERT_TRUE(r.comp.push(b, r.out).ok());
  ASSERT_TRUE(r.comp.flush(r.out).ok());
  const CompPiece& helix = r.out.pieces.back();
  EXPECT_EQ(helix.tag, 99u);
  EXPECT_EQ(helix.from.z(), 0);
  EXPECT_EQ(helix.to.z(), -3);
  EXPECT_NEAR(helix.sweep_rad, 2 * kPi, 0.2);
}

TEST(CutterComp, WithoutCompensationEverythingGoesThrough) {
  Mill r({0, 0});
  r.line(10, 0).arc(20, 10, 10, 10, true).none(-4).line(20, 40);
  r.expectPath({{10, 0}, {20, 10, Vec2(10, 10), 90}, {20, 40}});
  ASSERT_EQ(r.out.pieces.size(), 4u);
  EXPECT_EQ(r.out.pieces[2].role, CompPiece::Role::kPassThrough);
  EXPECT_EQ(r.out.pieces[3].from.z(), -4);
}

TEST(CutterComp, RefusesWhatTheModeForbids) {
  EXPECT_EQ(Mill({10, 0}).side(5).arc(0, 10, 0, 0, true).status.error, CompError::kStartInArc);
  EXPECT_EQ(Mill({0, 0}).side(5).line(10, 0).off().arc(0, 10, 0, 0, true).status.error,
            CompError::kCancelInArc);
  EXPECT_EQ(Mill({0, 0}).keep(10, 0).status.error, CompError::kNotActive);
  EXPECT_EQ(Mill({0, 0}).cornerArc().status.error, CompError::kNotActive);
  EXPECT_EQ(Mill({0, 0}).side(std::numeric_limits<double>::quiet_NaN()).line(1, 0).status.error,
            CompError::kNotFinite);
  // Corner arc on an inner corner.
  Mill inner({-50, 0});
  inner.side(5).line(0, 0).line(50, 0).cornerArc().line(50, 50).line(50, 90).off().line(50, 120);
  EXPECT_EQ(inner.status.error, CompError::kCornerArcInside);
  // Inner corner with an arc that the cutter does not fit in at all.
  Mill none({-100, 0});
  none.side(10).line(-50, 0).line(0, 0).arc(-16, 0, -8, 0, true).line(-16, -50).off().line(-50, -90);
  EXPECT_EQ(none.status.error, CompError::kNoIntersection);
  EXPECT_EQ(none.status.stop_tag, 2u);
}

TEST(CutterComp, TooManyBlocksWithoutMotionFillTheBuffer) {
  CutterCompPolicy policy;
  policy.max_pass_through = 4;
  Mill r({0, 0}, policy);
  r.side(5).line(10, 0).none().none().none().none();
  EXPECT_TRUE(r.status.ok());
  ASSERT_EQ(r.out.notes.size(), 1u);
  EXPECT_EQ(r.out.notes[0].warning, CompWarning::kManyPassThrough);
  r.none();
  EXPECT_EQ(r.status.error, CompError::kBufferFull);
  EXPECT_EQ(r.status.tag, 1u);
}

TEST(CutterComp, HaltEndsTheBlockBeforeTheRefusedOne) {
  Mill inside({0, -10});
  CompBlock arc = inside.side(8).line(10, -10).line(10, 10).block(CompBlock::Shape::kArc, 4, 16);
  arc.center = {4, 10};
  arc.sweep_rad = kPi / 2;
  inside.halt(arc).expectPath({{2, -10}, {2, 10}});
  EXPECT_FALSE(inside.comp.pending());
  // On the way in the refused block says which normal it is.
  CutterCompPolicy direct;
  direct.start_ramp = CompRamp::kA;
  Mill way_in({10, -20}, direct);
  CompBlock turned = way_in.side(8).line(10, 0).block(CompBlock::Shape::kArc, 10, 12);
  turned.center = {10, 6};
  turned.sweep_rad = kPi;
  way_in.halt(turned).expectPath({{10, 8}});
  // Data out of range say nothing.
  turned.center = {std::nan(""), 6};
  Mill unknown({10, -20}, direct);
  unknown.side(8).line(10, 0).halt(turned).expectPath({{2, 0}});
  Mill nothing({10, -20}, direct);
  nothing.halt(turned).expectPath({});
}

TEST(CutterComp, ProgramEndWhileActiveRunsToTheProgrammedPoint) {
  Mill r({-50, 0});
  r.side(5).line(0, 0).line(50, 0).flush();
  r.expectPath({{0, 5}, {50, 0}});
  EXPECT_TRUE(r.comp.active());
  EXPECT_FALSE(r.comp.pending());
}

}  // namespace
}  // namespace proveout
