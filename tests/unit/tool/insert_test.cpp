// Outlines of lathe inserts against what their dimensions say.
#include "core/tool/insert.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/geometry/plane.h"
#include "core/tool/tool.h"

namespace proveout {
namespace {

using testing::HasSubstr;

constexpr double kTight = 1e-9;

struct NamedInsert {
  std::string name;
  Insert insert;
};

Insert corner(int orientation, double radius, double angle, double lead, double length) {
  Insert insert;
  insert.orientation = orientation;
  insert.nose_radius = radius;
  insert.insert_angle_deg = angle;
  insert.lead_angle_deg = lead;
  insert.edge_length = length;
  return insert;
}

Insert groove(int orientation, double radius, double width, double relief, double length) {
  Insert insert;
  insert.shape = InsertShape::kGroove;
  insert.orientation = orientation;
  insert.nose_radius = radius;
  insert.width = width;
  insert.side_relief_deg = relief;
  insert.edge_length = length;
  return insert;
}

Insert tooth(int orientation, double radius, double flat, double angle, double length) {
  Insert insert;
  insert.shape = InsertShape::kThread;
  insert.orientation = orientation;
  insert.nose_radius = radius;
  insert.tip_flat = flat;
  insert.insert_angle_deg = angle;
  insert.edge_length = length;
  return insert;
}

Insert button(int orientation, double radius) {
  Insert insert;
  insert.shape = InsertShape::kRound;
  insert.orientation = orientation;
  insert.nose_radius = radius;
  return insert;
}

std::vector<NamedInsert> allInserts() {
  std::vector<NamedInsert> all;
  const auto add = [&](const std::string& name, const Insert& insert) {
    all.push_back({name + " " + std::to_string(insert.orientation), insert});
  };
  for (int o = 1; o <= 4; ++o) {
    add("CNMG", corner(o, 0.8, 80, 95, 12));
    add("VNMG sharp", corner(o, 0, 35, 93, 16));
    add("DNMG", corner(o, 0.4, 55, 107.5, 11));
    add("SNMG", corner(o, 1.2, 90, 45, 12));
    add("blade", groove(o, 0.2, 3, 0, 18));
    add("blade relieved", groove(o, 0.3, 4, 2, 10));
    add("blade sharp relieved", groove(o, 0, 2, 1.5, 8));
    add("thread", tooth(o, 0.1, 0, 60, 3));
  }
  for (int o = 5; o <= 8; ++o) {
    add("VCMT", corner(o, 0.4, 35, 0, 11));
    add("obtuse", corner(o, 2, 120, 0, 11));
    add("blade", groove(o, 0.25, 3, 1, 18));
    add("full radius", groove(o, 1.5, 3, 0, 18));
    if (o % 2 == 0) {
      add("thread rounded", tooth(o, 0.2, 0, 55, 4));
      add("thread flat", tooth(o, 0, 0.25, 60, 4));
      add("thread sharp", tooth(o, 0, 0, 30, 4));
    }
  }
  for (int o = 1; o <= 8; ++o) add("button", button(o, 4));
  for (std::size_t i = 0, count = all.size(); i < count; ++i) {
    Insert by_center = all[i].insert;
    by_center.at_center = true;
    add(all[i].name + " by its centre", by_center);
  }
  return all;
}

/// Points on the boundary, dense; of straight sides both ends.
std::vector<Vec2> densePoints(const ConvexOutline& outline, double step) {
  std::vector<Vec2> points;
  for (const OutlineSide& side : outline.sides()) {
    if (!side.arc) {
      const int n = 1 + static_cast<int>((side.to - side.from).norm() / step);
      for (int i = 0; i <= n; ++i) points.emplace_back(side.from + (side.to - side.from) * (1.0 * i / n));
      continue;
    }
    const Vec2 a = side.from - side.center, b = side.to - side.center;
    double sweep = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    if (sweep <= 0.0) sweep += 2.0 * kPi;
    const int n = 1 + static_cast<int>(side.radius * sweep / step);
    for (int i = 0; i <= n; ++i) {
      const double angle = std::atan2(a.y(), a.x()) + sweep * i / n;
      points.emplace_back(side.center + side.radius * Vec2(std::cos(angle), std::sin(angle)));
    }
  }
  return points;
}

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Of the polygon of dense points.
bool insidePolygon(const std::vector<Vec2>& points, const Vec2& p) {
  bool in = false;
  for (std::size_t i = 0, j = points.size() - 1; i < points.size(); j = i++) {
    const Vec2 &a = points[i], &b = points[j];
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x())
      in = !in;
  }
  return in;
}

Vec2 tangentAt(const OutlineSide& side, bool end) {
  if (!side.arc) return (side.to - side.from).normalized();
  const Vec2 arm = ((end ? side.to : side.from) - side.center).normalized();
  return {-arm.y(), arm.x()};
}

TEST(Insert, OutlinesAreClosedConvexAndTurnOnce) {
  for (const auto& [name, insert] : allInserts()) {
    ASSERT_TRUE(validateInsert(insert).ok()) << name << ": " << validateInsert(insert).error().message;
    const ConvexOutline outline = insertOutline(insert);
    const auto& sides = outline.sides();
    double turned = 0.0;
    for (std::size_t k = 0; k < sides.size(); ++k) {
      const OutlineSide& next = sides[(k + 1) % sides.size()];
      EXPECT_LT((sides[k].to - next.from).norm(), kTight) << name << " side " << k;
      const Vec2 a = tangentAt(sides[k], true), b = tangentAt(next, false);
      const double turn = std::atan2(cross(a, b), a.dot(b));
      EXPECT_GT(turn, -kTight) << name << " side " << k;
      turned += turn;
      if (sides[k].arc) {
        EXPECT_NEAR((sides[k].from - sides[k].center).norm(), sides[k].radius, kTight) << name;
        EXPECT_NEAR((sides[k].to - sides[k].center).norm(), sides[k].radius, kTight) << name;
        const Vec2 c = tangentAt(sides[k], false);
        double sweep = std::atan2(cross(c, a), c.dot(a));
        if (sweep <= 0.0) sweep += 2.0 * kPi;
        turned += sweep;
        // The nose is tangent to its neighbours.
        EXPECT_NEAR(turn, 0.0, 1e-7) << name << " side " << k;
      } else if (next.arc) {
        EXPECT_NEAR(turn, 0.0, 1e-7) << name << " side " << k;
      }
    }
    EXPECT_NEAR(turned, 2.0 * kPi, 1e-7) << name;
  }
}

TEST(Insert, ControlPointIsTouchOffOnBothSides) {
  constexpr int kTips[10][2] = {{0, 0}, {1, 1}, {1, -1}, {-1, -1}, {-1, 1},
                                {0, 1}, {1, 0}, {0, -1}, {-1, 0},  {0, 0}};
  for (const auto& [name, insert] : allInserts()) {
    if (insert.at_center) {
      Insert by_corner = insert;
      by_corner.at_center = false;
      const Vec2 shift = noseCenter(by_corner);
      EXPECT_EQ(noseCenter(insert), Vec2(0, 0)) << name;
      EXPECT_LT((insertOutline(insert).min() - insertOutline(by_corner).min() + shift).norm(), kTight)
          << name;
      continue;
    }
    const Vec2 tip(kTips[insert.orientation][0], kTips[insert.orientation][1]);
    const ConvexOutline outline = insertOutline(insert);
    const bool is_tooth = insert.shape == InsertShape::kThread;
    const Vec2 s = noseCenter(insert);
    if (!is_tooth) {
      EXPECT_LT((s + insert.nose_radius * tip).norm(), kTight) << name;
    }
    for (int axis = 0; axis < 2; ++axis) {
      if (tip[axis] == 0.0 || (is_tooth && axis == 1)) continue;
      // A leading edge that leans forward reaches farther along Z than the nose.
      if (axis == 1 && insert.lead_angle_deg > 0.0 && insert.lead_angle_deg < 90.0) continue;
      const double reach = tip[axis] > 0.0 ? outline.max()[axis] : outline.min()[axis];
      EXPECT_NEAR(reach, 0.0, kTight) << name << " axis " << axis;
    }
    if (is_tooth) {
      EXPECT_NEAR(outline.max().y(), -outline.min().y(), kTight) << name;
    }
  }
}

TEST(Insert, ACornerHasItsAnglesAndUses) {
  // A usual turning tool: 95 degrees to the feed, 80 degrees of corner, cutting towards the chuck.
  const ConvexOutline outline = insertOutline(corner(3, 0.8, 80, 95, 12));
  const OutlineSide *leading = nullptr, *trailing = nullptr;
  int backs = 0;
  for (const OutlineSide& side : outline.sides()) {
    if (side.use == SideUse::kBack) ++backs;
    if (side.arc) {
      EXPECT_EQ(side.use, SideUse::kCuts);
      EXPECT_NEAR(side.center.x(), 0.8, kTight);
      EXPECT_NEAR(side.center.y(), 0.8, kTight);
    } else if (side.use == SideUse::kCuts) {
      leading = &side;
    } else if (side.use == SideUse::kTrails) {
      trailing = &side;
    }
  }
  ASSERT_TRUE(leading != nullptr && trailing != nullptr);
  EXPECT_EQ(backs, 2);
  const Vec2 a = (leading->to - leading->from).normalized(), b = (trailing->from - trailing->to).normalized();
  EXPECT_NEAR(radToDeg(std::acos(a.dot(Vec2(0, -1)))), 95, 1e-9);
  EXPECT_GT(a.x(), 0.0);
  EXPECT_NEAR(radToDeg(std::acos(b.dot(Vec2(0, -1)))), 175, 1e-9);
  EXPECT_GT(b.x(), 0.0);
  // The sharp corner is an edge length before the end of both edges.
  const Vec2 sharp = leading->to - 12 * a;
  EXPECT_LT((sharp - (trailing->from - 12 * b)).norm(), kTight);
  EXPECT_NEAR((sharp - Vec2(0.8, 0.8)).norm(), 0.8 / std::sin(degToRad(40)), kTight);
}

TEST(Insert, OrientationsAreMirrorImages) {
  const Insert third = corner(3, 0.4, 55, 107.5, 11);
  for (int o = 1; o <= 4; ++o) {
    Insert other = third;
    other.orientation = o;
    const Vec2 flip(o <= 2 ? -1.0 : 1.0, o == 1 || o == 4 ? -1.0 : 1.0);
    const ConvexOutline a = insertOutline(third), b = insertOutline(other);
    for (double x = -2; x < 12; x += 0.37) {
      for (double z = -5; z < 12; z += 0.41) {
        const Vec2 p(x, z);
        EXPECT_NEAR(a.sample(p).value, b.sample(p.cwiseProduct(flip)).value, kTight) << o;
      }
    }
  }
}

TEST(Insert, BladesAndTeethHaveTheirSizes) {
  // A blade that touches off with its left side and front, 3 wide, relieved by a degree.
  ConvexOutline blade = insertOutline(groove(3, 0.2, 3, 1, 18));
  EXPECT_NEAR(blade.min().x(), 0, kTight);
  EXPECT_NEAR(blade.max().x(), 18, kTight);
  EXPECT_NEAR(blade.min().y(), 0, kTight);
  EXPECT_NEAR(blade.max().y(), 3, kTight);
  const double in =
      0.2 * (1 - std::cos(degToRad(1))) + (18 - 0.2 * (1 + std::sin(degToRad(1)))) * std::tan(degToRad(1));
  EXPECT_NEAR(blade.sample({18, in}).value, 0, 1e-9);
  EXPECT_NEAR(blade.sample({18, 3 - in}).value, 0, 1e-9);
  blade = insertOutline(groove(4, 0.2, 3, 0, 18));  // named by its other side
  EXPECT_NEAR(blade.min().y(), -3, kTight);
  EXPECT_NEAR(blade.max().y(), 0, kTight);
  blade = insertOutline(groove(7, 0.2, 3, 0, 18));  // a face groove
  EXPECT_NEAR(blade.min().x(), -1.5, kTight);
  EXPECT_NEAR(blade.max().x(), 1.5, kTight);
  EXPECT_NEAR(blade.min().y(), 0, kTight);
  EXPECT_NEAR(blade.max().y(), 18, kTight);
  blade = insertOutline(groove(1, 0.2, 3, 0, 18));  // for a bore
  EXPECT_NEAR(blade.min().x(), -18, kTight);
  EXPECT_NEAR(blade.max().x(), 0, kTight);

  const double t30 = std::tan(degToRad(30.0));
  ConvexOutline thread = insertOutline(tooth(8, 0, 0.25, 60, 4));
  EXPECT_NEAR(thread.max().y(), 0.125 + 4 * t30, kTight);
  thread = insertOutline(tooth(8, 0, 0, 60, 4));
  EXPECT_NEAR(thread.max().y(), 4 * t30, kTight);
  // Rounded, the flanks meet r (1 / sin - 1) in front of the tip.
  thread = insertOutline(tooth(8, 0.2, 0, 60, 4));
  EXPECT_NEAR(thread.max().y(), (4 + 0.2 * (1 / 0.5 - 1)) * t30, kTight);
  EXPECT_NEAR(thread.sample({0, 0}).value, 0, kTight);
  EXPECT_NEAR(noseCenter(tooth(6, 0.2, 0, 60, 4)).x(), -0.2, kTight);
  for (const OutlineSide& side : thread.sides())
    EXPECT_EQ(side.use,
              std::abs(side.from.x() - side.to.x()) < kTight && !side.arc ? SideUse::kBack : SideUse::kCuts);
}

TEST(Insert, DistancesAgreeWithDensePoints) {
  constexpr double kStep = 0.005;
  for (const auto& [name, insert] : allInserts()) {
    if (insert.orientation != 3 && insert.orientation < 6) continue;
    const ConvexOutline outline = insertOutline(insert);
    const std::vector<Vec2> points = densePoints(outline, kStep);
    const Vec2 size = outline.max() - outline.min();
    for (int i = 0; i <= 12; ++i) {
      for (int j = 0; j <= 12; ++j) {
        const Vec2 p = outline.min() + Vec2(size.x() * (i / 8.0 - 0.25), size.y() * (j / 8.0 - 0.26));
        double nearest = 1e9;
        for (const Vec2& q : points) nearest = std::min(nearest, (q - p).norm());
        const auto sample = outline.sample(p);
        // The next of the points is at most half a step along the boundary from the nearest.
        EXPECT_LE(std::abs(sample.value), nearest + kTight) << name << " " << p.transpose();
        EXPECT_NEAR(std::hypot(sample.value, 0.5 * kStep), nearest, 0.5 * kStep) << name << p.transpose();
        if (nearest > kStep) {
          EXPECT_EQ(sample.value < 0.0, insidePolygon(points, p)) << name << p.transpose();
        }
        // The gradient leads to the boundary.
        EXPECT_NEAR(sample.gradient.norm(), 1.0, kTight) << name;
        EXPECT_NEAR(outline.sample(p - sample.value * sample.gradient).value, 0.0, 1e-8) << name;
      }
    }
  }
}

TEST(Insert, SupportIsTheFarthestPoint) {
  for (const auto& [name, insert] : allInserts()) {
    const ConvexOutline outline = insertOutline(insert);
    const std::vector<Vec2> points = densePoints(outline, 0.002);
    for (int i = -70; i < 75; ++i) {
      const double direction = 0.1 * i + 0.03;
      const Vec2 d(std::cos(direction), std::sin(direction));
      double most = -1e9;
      for (const Vec2& p : points) most = std::max(most, d.dot(p));
      const Vec2 support = outline.support(direction);
      EXPECT_NEAR(d.dot(support), most, 1e-5) << name << " " << direction;
      EXPECT_NEAR(outline.sample(support).value, 0.0, kTight) << name << " " << direction;
    }
    // Across a straight side: the end that the outline reaches last. Of sides in line, and where a shift has
    // rounded the points, it may be any of their ends.
    const auto& sides = outline.sides();
    const auto inLine = [](const OutlineSide& one, const OutlineSide& other) {
      return !one.arc && !other.arc &&
             std::abs(cross2((one.to - one.from).normalized(), (other.to - other.from).normalized())) < 1e-9;
    };
    for (std::size_t i = 0; i < sides.size() && !insert.at_center; ++i) {
      const OutlineSide& side = sides[i];
      const auto neighbour = [&](std::size_t k) { return inLine(side, sides[(i + k) % sides.size()]); };
      if (side.arc || neighbour(1) || neighbour(sides.size() - 1)) continue;
      const Vec2 d = side.to - side.from;
      const Vec2 support = outline.support(std::atan2(-d.x(), d.y()));
      EXPECT_LT((support - side.to).norm(), 1e-8) << name;
    }
  }
}

TEST(Insert, ChainsStayOnTheOutline) {
  constexpr double kTolerance = 1e-3;
  for (const auto& [name, insert] : allInserts()) {
    const ConvexOutline outline = insertOutline(insert);
    for (int i = -9; i < 9; ++i) {
      for (const double sweep : {0.0, 0.3, 1.0, kPi, 5.0, 2.0 * kPi}) {
        const double from = 0.8 * i, to = from + sweep;
        std::vector<Vec2> points;
        outline.chain(from, to, kTolerance, points);
        ASSERT_FALSE(points.empty()) << name;
        EXPECT_LT((points.front() - outline.support(from)).norm(), 1e-8) << name << " " << from;
        for (std::size_t k = 0; k < points.size(); ++k) {
          EXPECT_NEAR(outline.sample(points[k]).value, 0.0, kTight) << name;
          if (k == 0) continue;
          const auto middle = outline.sample(0.5 * (points[k - 1] + points[k]));
          EXPECT_LE(middle.value, kTight) << name;
          EXPECT_GE(middle.value, -kTolerance) << name << " " << from << " " << sweep;
        }
        // It reaches as far as the outline in every direction between.
        for (double at = from; at <= to; at += 0.17) {
          const Vec2 d(std::cos(at), std::sin(at));
          double most = -1e9;
          for (const Vec2& p : points) most = std::max(most, d.dot(p));
          EXPECT_NEAR(most, d.dot(outline.support(at)), kTolerance) << name << " " << at;
        }
      }
    }
  }
}

TEST(Insert, ChainsOfAllDirectionsEncloseTheOutline) {
  for (const auto& [name, insert] : allInserts()) {
    const ConvexOutline outline = insertOutline(insert);
    const std::vector<Vec2> dense = densePoints(outline, 0.001);
    const auto area = [](const std::vector<Vec2>& points) {
      double sum = 0.0;
      for (std::size_t k = 0; k < points.size(); ++k)
        sum += 0.5 * cross(points[k], points[(k + 1) % points.size()]);
      return sum;
    };
    for (const double split : {0.4, 0.5 * kPi, 2.0, kPi}) {
      std::vector<Vec2> points;
      outline.chain(-1.0, -1.0 + split, 1e-5, points);
      outline.chain(-1.0 + split, -1.0 + 2.0 * kPi, 1e-5, points);
      EXPECT_NEAR(area(points), area(dense), 1e-3) << name;
    }
  }
}

TEST(ConvexOutline, LeavesOutSidesWithoutLengthAndShifts) {
  const auto side = [](const Vec2& a, const Vec2& b) { return OutlineSide{a, b}; };
  OutlineSide point{Vec2(1, 1), Vec2(1, 1), SideUse::kCuts, true, Vec2(0, 1), 1.0};
  const ConvexOutline square({side({0, 0}, {1, 0}), side({1, 0}, {1, 0}), side({1, 0}, {1, 1}), point,
                              side({1, 1}, {0, 1}), side({0, 1}, {0, 0})});
  EXPECT_EQ(square.sides().size(), 4u);
  EXPECT_NEAR(square.support(0.25 * kPi).x(), 1.0, kTight);
  const ConvexOutline moved = shifted(square, {2, -3});
  EXPECT_NEAR(moved.min().x(), 2.0, kTight);
  EXPECT_NEAR(moved.max().y(), -2.0, kTight);
  EXPECT_NEAR(moved.sample({2.5, -2.5}).value, -0.5, kTight);
  EXPECT_NEAR(moved.sample({4, -2}).value, 1.0, kTight);
  // Two sides in one line are allowed.
  const ConvexOutline halved({side({0, 0}, {0.5, 0}), side({0.5, 0}, {1, 0}), side({1, 0}, {1, 1}),
                              side({1, 1}, {0, 1}), side({0, 1}, {0, 0})});
  EXPECT_NEAR(halved.support(-0.5 * kPi).x(), 1.0, kTight);
}

TEST(ConvexOutline, CircleStepsKeepTheTolerance) {
  for (const double radius : {0.01, 0.4, 12.7, 500.0}) {
    for (const double tolerance : {1e-4, 1e-3, 0.05}) {
      const int steps = circleSteps(radius, tolerance);
      EXPECT_EQ(steps % 4, 0);
      if (radius <= tolerance) continue;
      EXPECT_LE(radius * (1 - std::cos(kPi / steps)), tolerance * (1 + 1e-9));
    }
  }
}

double areaOf(const ConvexOutline& outline) {
  double sum = 0.0;
  for (const OutlineSide& side : outline.sides()) sum += 0.5 * cross(side.from, side.to);
  return sum;
}

TEST(InsertHolder, PiecesCoverThePolygon) {
  const std::vector<std::vector<Vec2>> polygons = {
      {{5, 1}, {100, 1}, {100, 26}, {8, 26}},
      {{0, 0}, {10, 0}, {10, 10}, {6, 10}, {6, 4}, {4, 4}, {4, 10}, {0, 10}},           // a U
      {{0, 0}, {0, 10}, {4, 10}, {4, 4}, {6, 4}, {6, 10}, {10, 10}, {10, 0}},           // the same, clockwise
      {{0, 0}, {2, 0}, {5, 0}, {5, 5}, {2.5, 5}, {0, 5}},                               // points within sides
      {{0, -5}, {1, -1}, {5, 0}, {1, 1}, {0, 5}, {-1, 1}, {-5, 0}, {-1, -1}},           // a star
      {{0, 0}, {9, 0}, {9, 9}, {1, 9}, {1, 2}, {7, 2}, {7, 7}, {3, 7}, {3, 4}, {5, 4},  // a spiral
       {5, 5}, {4, 5}, {4, 6}, {6, 6}, {6, 3}, {2, 3}, {2, 8}, {8, 8}, {8, 1}, {0, 1}},
  };
  for (const std::vector<Vec2>& polygon : polygons) {
    Insert insert = corner(3, 0.8, 80, 95, 12);
    insert.holder = polygon;
    ASSERT_TRUE(validateInsert(insert).ok()) << validateInsert(insert).error().message;
    const auto pieces = holderPieces(insert);
    double area = 0.0, whole = 0.0;
    for (const ConvexOutline& piece : pieces) {
      area += areaOf(piece);
      EXPECT_GT(areaOf(piece), 0.0);
      for (const OutlineSide& side : piece.sides()) EXPECT_EQ(side.use, SideUse::kBack);
    }
    for (std::size_t k = 0; k < polygon.size(); ++k)
      whole += 0.5 * cross(polygon[k], polygon[(k + 1) % polygon.size()]);
    EXPECT_NEAR(area, std::abs(whole), 1e-9);
    for (double x = -5.93; x < 101; x += x < 11 ? 0.37 : 7.3) {
      for (double z = -5.91; z < 27; z += 0.61) {
        const Vec2 p(x, z);
        bool in = false;
        for (const ConvexOutline& piece : pieces) in = in || piece.sample(p).value < 0.0;
        EXPECT_EQ(in, insidePolygon(polygon, p)) << p.transpose();
      }
    }
  }
  Insert insert = corner(3, 0.8, 80, 95, 12);
  EXPECT_TRUE(holderPieces(insert).empty());
  insert.holder = polygons[0];
  EXPECT_EQ(holderPieces(insert).size(), 1u);
  insert.holder = polygons[1];
  EXPECT_EQ(holderPieces(insert).size(), 3u);
}

std::string refusal(const Insert& insert) {
  const Status status = validateInsert(insert);
  return status.ok() ? "accepted" : status.error().message;
}

std::string refusedHolder(const std::vector<Vec2>& holder) {
  Insert insert = button(3, 4);
  insert.holder = holder;
  return refusal(insert);
}

TEST(InsertHolder, RefusesWhatIsNoSimplePolygon) {
  EXPECT_THAT(refusedHolder({{0, 0}, {1, 0}}),
              HasSubstr("holder: a polygon has at least three points, not 2"));
  EXPECT_THAT(refusedHolder({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), HasSubstr("holder: the border meets itself"));
  EXPECT_THAT(refusedHolder({{0, 0}, {1, 0}, {1, 0}, {0, 1}}), HasSubstr("points 2 and 3 are the same"));
  EXPECT_THAT(refusedHolder({{0, 0}, {2, 0}, {1, 0}}), HasSubstr("the border folds back on itself"));
  EXPECT_THAT(refusedHolder({{0, 0}, {1, 0}, {2, 0}}), HasSubstr("the border folds back on itself"));
  // A border that touches itself in a point.
  EXPECT_THAT(refusedHolder({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}), HasSubstr("meets itself"));
  EXPECT_THAT(refusedHolder({{0, 0}, {1e6, 0}, {0, 1}}), HasSubstr("an x of the holder must be between"));
  EXPECT_THAT(refusedHolder({{0, 0}, {1, std::nan("")}, {0, 1}}), HasSubstr("a z of the holder"));
  EXPECT_THAT(refusedHolder(std::vector<Vec2>(501, Vec2::Zero())), HasSubstr("at most 500"));
}

TEST(Insert, RefusalsNameTheField) {
  const auto with = [](Insert insert, const std::function<void(Insert&)>& change) {
    change(insert);
    return refusal(insert);
  };
  const Insert usual = corner(3, 0.8, 80, 95, 12), blade = groove(3, 0.2, 3, 1, 18),
               thread = tooth(8, 0.1, 0, 60, 3), round = button(3, 4);
  EXPECT_EQ(refusal(usual), "accepted");
  EXPECT_THAT(with(usual, [](Insert& i) { i.orientation = 0; }), HasSubstr("directions 1 to 8, not 0"));
  EXPECT_THAT(with(usual, [](Insert& i) { i.orientation = 9; }), HasSubstr("directions 1 to 8, not 9"));
  EXPECT_THAT(with(usual, [](Insert& i) { i.nose_radius = -1; }), HasSubstr("nose_radius must be"));
  EXPECT_THAT(with(usual, [](Insert& i) { i.nose_radius = std::nan(""); }), HasSubstr("nose_radius must be"));
  EXPECT_THAT(with(usual, [](Insert& i) { i.lead_angle_deg = 0; }), HasSubstr("lead_angle must be above 0"));
  EXPECT_THAT(with(usual, [](Insert& i) { i.insert_angle_deg = 85; }),
              HasSubstr("insert_angle must be above 0 and below 85 degrees"));
  EXPECT_THAT(with(usual, [](Insert& i) { i.orientation = 8; }), HasSubstr("lead_angle has no meaning"));
  EXPECT_THAT(with(usual, [](Insert& i) { i.edge_length = 0; }), HasSubstr("edge_length must be"));
  EXPECT_THAT(with(usual, [](Insert& i) { i.edge_length = 0.9; }),
              HasSubstr("edge_length must be above 0.95"));
  EXPECT_THAT(with(usual, [](Insert& i) { i.width = 3; }),
              HasSubstr("width has no meaning for an insert of"));
  EXPECT_THAT(with(blade, [](Insert& i) { i.width = 0; }), HasSubstr("width must be"));
  EXPECT_THAT(with(blade, [](Insert& i) { i.nose_radius = 1.6; }), HasSubstr("nose_radius is larger"));
  EXPECT_THAT(with(blade, [](Insert& i) { i.side_relief_deg = 5; }), HasSubstr("side_relief leaves nothing"));
  EXPECT_THAT(with(blade, [](Insert& i) { i.side_relief_deg = -1; }), HasSubstr("side_relief must be"));
  EXPECT_THAT(with(blade, [](Insert& i) { i.edge_length = 0.1; }),
              HasSubstr("edge_length must be above 0.20"));
  EXPECT_THAT(with(blade, [](Insert& i) { i.tip_flat = 1; }), HasSubstr("tip_flat has no meaning"));
  EXPECT_THAT(with(thread, [](Insert& i) { i.orientation = 7; }),
              HasSubstr("orientation of a thread insert"));
  EXPECT_THAT(with(thread, [](Insert& i) { i.tip_flat = 0.1; }), HasSubstr("nose_radius or tip_flat"));
  EXPECT_THAT(with(thread, [](Insert& i) { i.insert_angle_deg = 180; }), HasSubstr("insert_angle must be"));
  EXPECT_THAT(with(thread, [](Insert& i) { i.insert_angle_deg = 179.999; }), HasSubstr("insert_angle and"));
  EXPECT_THAT(with(round, [](Insert& i) { i.nose_radius = 0; }), HasSubstr("nose_radius must be between"));
  EXPECT_THAT(with(round, [](Insert& i) { i.edge_length = 2; }), HasSubstr("edge_length has no meaning"));
}

TEST(InsertTool, IsATypeOfItsOwn) {
  EXPECT_EQ(toolTypeOf("insert"), ToolType::kInsert);
  EXPECT_EQ(toolTypeName(ToolType::kInsert), "insert");
  Tool tool;
  tool.number = 5;
  tool.type = ToolType::kInsert;
  EXPECT_EQ(validateTool(tool).error().message, "tool 5: an insert without its shape");
  tool.insert = corner(3, 0.8, 80, 95, 12);
  EXPECT_TRUE(validateTool(tool).ok());
  tool.diameter = 3;
  EXPECT_THAT(validateTool(tool).error().message,
              HasSubstr("no dimensions and no hand of a tool that turns"));
  tool.diameter = 0;
  tool.insert->edge_length = 0;
  EXPECT_THAT(validateTool(tool).error().message, HasSubstr("tool 5: edge_length must be"));
  tool.type = ToolType::kFlat;
  tool.diameter = 3;
  EXPECT_THAT(validateTool(tool).error().message, HasSubstr("only tools of type insert"));
  EXPECT_THAT(parseToolOption("5=insert:0.8").error().message,
              HasSubstr("'insert' needs a job file ([[tool]])"));
}

}  // namespace
}  // namespace proveout
