// Parts of tools that overlap the stock by less than the grid tells, or just miss it, against closed forms:
// on which side, under which turn and where on the grid must not count.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "tests/unit/removal/cut_fixture.h"

namespace proveout::test {
namespace {

constexpr double kDepthMm = 0.01;  ///< what depths may be off by, and the least that is told

/// One planted case: the last motion overlaps by `depth`, or misses by minus that.
struct Planted {
  std::string what;
  StockShape blank;
  Toolpath path;
  std::vector<Tool> tools;
  ContactKind kind = ContactKind::kRapid;
  bool fixture = false;
  int quarters = 0;  ///< turns of the stock after all motions but the last, about Z
};

class Planter {
 public:
  explicit Planter(unsigned seed) : random_(seed) {}

  double within(double low, double high) { return std::uniform_real_distribution<>(low, high)(random_); }
  int oneOf(int count) { return std::uniform_int_distribution<>(0, count - 1)(random_); }

  Planted make(double depth) {
    Planted p = plant(depth);
    if (p.path.motions.size() == 1 && oneOf(4) == 0) {
      p.fixture = true;
      if (p.kind == ContactKind::kRapid) p.kind = ContactKind::kFixture;
    } else if (oneOf(3) == 0) {
      p.quarters = 1 + oneOf(3);
    }
    return p;
  }

 private:
  Planted plant(double depth) {
    switch (oneOf(8)) {
      case 0:
        return besideTheBlank(depth);
      case 1:
        return besideAnEarlierStep(depth);
      case 2:
        return inAnEarlierHole(depth);
      case 3:
        return besideACylinder(depth);
      case 4:
        return inATube(depth);
      case 5:
        return inARing(depth);
      case 6:
        return aboveASlope(depth);
      default:
        return aboveTheTop(depth);
    }
  }
  /// A tool whose radius is `radius` from `above` over its tip on.
  Tool endMill(double& radius, double& above) {
    radius = within(1.5, 6.0);
    const int shape = oneOf(4);
    above = shape == 0 ? 0.0 : shape == 1 ? radius : 0.4 * radius;
    const double d = 2.0 * radius;
    if (shape == 0) return tool(fmt::format("1=flat:{}", d));
    if (shape == 1) return tool(fmt::format("1=ball:{}", d));
    if (shape == 2) return tool(fmt::format("1=bull:{}:{}", d, 0.4 * radius));
    above = 0.0;
    return tool(fmt::format("1=tslot:{}:{}:{}", d, 4.0, 0.9 * d));
  }
  /// A tool whose shank, neck or holder is wider than what cuts: `radius` from `above` on.
  Tool withWidePart(double& radius, double& above, ContactKind& kind) {
    const double cutter = within(1.0, 3.0);
    Tool t = tool(fmt::format("1=flat:{}", 2.0 * cutter));
    t.flute_length = 8.0;
    t.overall_length = 30.0;
    radius = cutter + within(1.5, 3.0);
    above = 8.0;
    kind = ContactKind::kShank;
    const int part = oneOf(3);
    if (part == 0) {
      t.shank_diameter = 2.0 * radius;
    } else if (part == 1) {
      t.neck_diameter = 2.0 * radius;
      t.neck_length = 25.0;
      t.shank_diameter = 1.0;
    } else {
      t.shank_diameter = 2.0 * cutter;
      t.overall_length = above = 12.0;
      t.holder = {{0.0, radius}, {20.0, radius}};
      kind = ContactKind::kHolder;
    }
    return t;
  }
  /// What moves, and how.
  struct Mover {
    Tool tool;
    double radius, above;
    ContactKind kind = ContactKind::kRapid;
    MotionKind motion() const { return kind == ContactKind::kRapid ? MotionKind::kRapid : MotionKind::kFeed; }
  };
  Mover mover() {
    Mover m;
    if (oneOf(2) == 0) {
      m.tool = endMill(m.radius, m.above);
    } else {
      m.tool = withWidePart(m.radius, m.above, m.kind);
    }
    return m;
  }
  Vec3 shift() { return {within(-50, 50), within(-50, 50), within(-50, 50)}; }

  /// Along one of the four sides of a block, on all of it or a part, level, rising or upright.
  Planted besideTheBlank(double depth) {
    const Mover m = mover();
    const Vec3 low = shift();
    const double wide = within(20, 40), high = within(12, 18);
    Planted p{"side", BoxShape{low, low + Vec3(wide, wide, high)}, {}, {m.tool}, m.kind};
    const int side = oneOf(4);
    const double angle = 0.5 * kPi * side, off = 0.5 * wide + m.radius - depth;
    const Vec3 middle = low + Vec3(0.5 * wide, 0.5 * wide, 0.0);
    const Vec3 out(std::round(std::cos(angle)), std::round(std::sin(angle)), 0), along(-out.y(), out.x(), 0);
    const double a = within(-0.4, 0.4) * wide, b = oneOf(3) == 0 ? a : within(-0.4, 0.4) * wide;
    const double tip = within(0.2, 0.5) * high - m.above, end = oneOf(2) == 0 ? tip : tip + within(0.5, 4.0);
    p.path = line(m, middle + off * out + a * along + tip * Vec3::UnitZ(),
                  middle + off * out + b * along + end * Vec3::UnitZ());
    return p;
  }
  /// Along the wall of a slot at any angle that another tool has cut.
  Planted besideAnEarlierStep(double depth) {
    const Mover m = mover();
    const Vec3 low = shift();
    const double high = within(16, 20), angle = within(0, 2.0 * kPi), r = m.radius + within(1.0, 3.0);
    Planted p{"step", BoxShape{low, low + Vec3(60, 60, high)}, {}, {m.tool}, m.kind};
    p.tools.push_back(tool(fmt::format("2=flat:{}", 2.0 * r)));
    const Vec3 middle = low + Vec3(30, 30, 0), along(std::cos(angle), std::sin(angle), 0),
               out(-along.y(), along.x(), 0);
    const Vec3 floor(0, 0, 1.0);
    PathMaker first(2);
    first.line(middle - 80 * along + floor, middle + 80 * along + floor);
    const double a = within(-15, 15), b = within(-15, 15);
    const double tip = std::max(1.1, 0.5 * high - m.above);
    const Vec3 off = (r - m.radius + depth) * out + tip * Vec3::UnitZ();
    p.path = joined(first.path(), line(m, middle + off + a * along, middle + off + b * along));
    return p;
  }
  /// Down in a hole, off its middle.
  Planted inAnEarlierHole(double depth) {
    Mover m;
    m.tool = endMill(m.radius, m.above);
    const Vec3 low = shift();
    const double high = within(12, 18), angle = within(0, 2.0 * kPi), r = m.radius + within(0.3, 3.0);
    Planted p{"hole", BoxShape{low, low + Vec3(40, 40, high)}, {}, {m.tool}};
    p.tools.push_back(tool(fmt::format("2=flat:{}", 2.0 * r)));
    const Vec3 middle = low + Vec3(20, 20, 0), top(0, 0, high + 5);
    PathMaker first(2);
    first.line(middle + top, middle + Vec3(0, 0, 1));
    const Vec3 off = (r - m.radius + depth) * Vec3(std::cos(angle), std::sin(angle), 0);
    p.path = joined(first.path(), line(m, middle + off + top, middle + off + Vec3(0, 0, 1.2)));
    return p;
  }
  /// Down beside a round bar.
  Planted besideACylinder(double depth) {
    const Mover m = mover();
    const Vec3 low = shift();
    const double r = within(8, 20), high = within(12, 18), angle = within(0, 2.0 * kPi);
    Planted p{"cylinder", CylinderShape{}, {}, {m.tool}, m.kind};
    CylinderShape bar;
    bar.base = low;
    bar.radius = r;
    bar.length = high;
    p.blank = bar;
    const Vec3 at = low + (r + m.radius - depth) * Vec3(std::cos(angle), std::sin(angle), 0);
    p.path = line(m, at + Vec3(0, 0, high + 40), at + Vec3(0, 0, 0.5 * high - m.above));
    return p;
  }
  /// Down in the bore of a tube, which lies along any axis if the tool is a mill.
  Planted inATube(double depth) {
    Mover m;
    m.tool = endMill(m.radius, m.above);
    const Vec3 low = shift();
    const double r = m.radius + within(0.5, 8), high = within(12, 18), angle = within(0, 2.0 * kPi);
    Planted p{"tube", CylinderShape{2, low, r + within(3, 6), r, high}, {}, {m.tool}};
    const Vec3 at = low + (r - m.radius + depth) * Vec3(std::cos(angle), std::sin(angle), 0);
    p.path = line(m, at + Vec3(0, 0, high + 5), at + Vec3(0, 0, 2 - m.above));
    return p;
  }
  /// Round the inside of a groove that another tool has cut on a circle.
  Planted inARing(double depth) {
    const Mover m = wideMover();
    const Vec3 low = shift();
    const double r = m.radius + within(0.5, 2), ring = within(1.2, 3.0) * r, high = within(16, 20);
    const double half = ring + r + 6;
    Planted p{"ring", BoxShape{low, low + Vec3(2 * half, 2 * half, high)}, {}, {m.tool}, m.kind};
    p.tools.push_back(tool(fmt::format("2=flat:{}", 2.0 * r)));
    const Vec3 middle = low + Vec3(half, half, 0);
    PathMaker first(2), last;
    first.arc(middle + Vec3(ring, 0, 1), middle, Vec3::UnitZ(), 360.0);
    const double inner = ring + (oneOf(2) == 0 ? 1 : -1) * (r - m.radius + depth),
                 angle = within(0, 2.0 * kPi);
    last.arc(middle + Vec3(inner * std::cos(angle), inner * std::sin(angle), 1.1), middle, Vec3::UnitZ(),
             (oneOf(2) == 0 ? 1 : -1) * within(40, 300));
    p.path = first.path();
    for (Motion motion : last.path().motions) {
      motion.source.line += 10;
      motion.arc = 1;
      p.path.motions.push_back(motion);
    }
    p.path.arcs.push_back(last.path().arcs[0]);
    return p;
  }
  /// Over a slope that a flat end has cut on its way down: a rapid with a ball that follows it.
  Planted aboveASlope(double depth) {
    const Vec3 low = shift();
    const double angle = within(0, 2.0 * kPi), slope = within(0.1, 0.6), r = within(2, 4);
    Planted p{"slope", BoxShape{low, low + Vec3(60, 60, 20)}, {}, {tool(fmt::format("1=ball:{}", 2 * r))}};
    p.tools.push_back(tool(fmt::format("2=ball:{}", 2.0 * r)));
    const Vec3 middle = low + Vec3(30, 30, 12), along(std::cos(angle), std::sin(angle), slope),
               off = (-depth / std::hypot(1.0, slope)) *
                     Vec3(-slope * std::cos(angle), -slope * std::sin(angle), 1.0);
    PathMaker first(2), last;
    first.line(middle - 12 * along, middle + 12 * along);
    last.line(middle - 6 * along + off, middle + 6 * along + off, MotionKind::kRapid);
    p.path = joined(first.path(), last.path());
    return p;
  }
  Mover wideMover() {
    Mover m;
    m.tool = withWidePart(m.radius, m.above, m.kind);
    return m;
  }
  /// Over the top face.
  Planted aboveTheTop(double depth) {
    Mover m;
    m.tool = endMill(m.radius, m.above);
    const Vec3 low = shift();
    Planted p{"top", BoxShape{low, low + Vec3(30, 30, 12)}, {}, {m.tool}};
    const Vec3 over(0, 0, 12 - depth);
    p.path = line(m, low + Vec3(within(8, 22), within(8, 22), 0) + over,
                  low + Vec3(within(8, 22), within(8, 22), 0) + over);
    return p;
  }
  static Toolpath line(const Mover& m, const Vec3& from, const Vec3& to) {
    PathMaker p;
    p.line(from, to, m.motion());
    return p.path();
  }
  static Toolpath joined(Toolpath first, const Toolpath& last) {
    for (Motion m : last.motions) {
      m.source.line += 10;
      first.motions.push_back(m);
    }
    return first;
  }

  std::mt19937 random_;
};

/// The same about the middle of the grid's frame.
Toolpath turned(Toolpath path, const RigidTransform& turn) {
  for (Motion& m : path.motions) {
    m.from = turn(m.from);
    m.to = turn(m.to);
  }
  for (ArcGeometry& arc : path.arcs) {
    arc.center = turn(arc.center);
    arc.normal = turn.rotation * arc.normal;
  }
  return path;
}

RigidTransform quarterTurns(int count) {
  RigidTransform turn;
  for (int i = 0; i < count; ++i) {
    Eigen::Matrix3d quarter;
    quarter << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    turn.rotation = quarter * turn.rotation;
  }
  return turn;
}

std::vector<Contact> contactsOf(const Planted& p, double grid) {
  RemovalOptions options;
  options.resolution_mm = grid;
  options.threads = 1;
  options.watch_all = p.fixture;
  Progress progress;
  auto stock = Stock::create(p.blank, options, progress);
  EXPECT_TRUE(stock.ok());
  Toolpath last = p.path;
  if (p.quarters > 0) {
    Toolpath before = p.path;
    before.motions.pop_back();
    if (!before.motions.empty()) {
      EXPECT_TRUE(stock->remove(before, p.tools, options, progress).ok());
    }
    const RigidTransform turn = quarterTurns(p.quarters);
    stock = stock->moved(turn, options, progress);
    EXPECT_TRUE(stock.ok());
    last.motions = {last.motions.back()};
    last = turned(last, turn);
  }
  const auto summary = stock->remove(last, p.tools, options, progress);
  EXPECT_TRUE(summary.ok());
  std::vector<Contact> contacts;
  for (const Contact& contact : summary->contacts) {
    if (contact.motion + 1 == last.motions.size()) contacts.push_back(contact);
  }
  return contacts;
}

/// The deepest contact of the kind by the last motion, mm; 0: none.
double deepest(const Planted& p, double grid) {
  double depth = 0.0;
  for (const Contact& contact : contactsOf(p, grid)) {
    if (contact.kind == p.kind) depth = std::max(depth, contact.depth_mm);
  }
  return depth;
}

/// The depth of a contact with what an earlier setup left is one to the chords of the grid, where that bends.
double withinOf(const Planted& p, double grid) {
  const bool bends = p.quarters > 0 && p.what != "side" && p.what != "top" && p.what != "step";
  return kDepthMm + (bends ? grid * grid / 8.0 : 0.0);
}

int countFrom(const char* name, int usual) {
  const char* given = std::getenv(name);
  return given != nullptr ? std::atoi(given) : usual;
}

TEST(NearContacts, OverlapsOfAnyDepthAreTold) {
  const int first = countFrom("PROVEOUT_NEAR_FROM", 1), count = countFrom("PROVEOUT_NEAR_COUNT", 400);
  for (int seed = first; seed < first + count; ++seed) {
    Planter planter(static_cast<unsigned>(seed));
    const double grid = planter.within(0.4, 1.2), depth = grid * planter.within(0.02, 1.0);
    const Planted p = planter.make(std::max(depth, 1.5 * kDepthMm));
    EXPECT_NEAR(deepest(p, grid), std::max(depth, 1.5 * kDepthMm), withinOf(p, grid))
        << "seed " << seed << ", " << p.what << ", grid " << grid << ", quarters " << p.quarters
        << ", fixture " << p.fixture << ", kind " << static_cast<int>(p.kind);
  }
}

TEST(NearContacts, ClearancesAreQuiet) {
  const int first = countFrom("PROVEOUT_NEAR_FROM", 1), count = countFrom("PROVEOUT_NEAR_COUNT", 400);
  for (int seed = first; seed < first + count; ++seed) {
    Planter planter(static_cast<unsigned>(seed));
    const double grid = planter.within(0.4, 1.2);
    const Planted p = planter.make(-0.02);
    EXPECT_LT(deepest(p, grid), withinOf(p, grid))
        << "seed " << seed << ", " << p.what << ", grid " << grid << ", quarters " << p.quarters;
  }
}

}  // namespace
}  // namespace proveout::test
