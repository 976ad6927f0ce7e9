// The column kernels against the exact swept distance: just above the lower end of an interval a point is
// inside, just below it is outside, and where no interval is found nothing is inside. Every SIMD level gives
// the same bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/tool/tool_solid.h"
#include "removal/sweep/column_sweep.h"
#include "removal/sweep/column_way.h"
#include "removal/sweep/sweep.h"
#include "tests/property/random_moves.h"

namespace proveout {
namespace {

/// Stated bound of the kernels with room for the reference's own (kSweepToleranceMm), mm.
constexpr double kStep = 1e-5;

/// Flat, ball, bull, cone and drill, and convex profiles that only unions are made of: undercut, round on
/// top.
std::vector<ConvexProfile> profiles() {
  std::vector<ConvexProfile> out;
  for (const char* text : {"1=flat:6", "2=ball:6", "3=bull:8:1.5", "4=cone:6:0.4:60", "5=drill:5:118",
                           "6=cone:8:0:120", "7=bull:6:3", "8=lollipop:6:3"}) {
    Tool tool = parseToolOption(text).value();
    tool.flute_length = 15.0;
    for (const ConvexProfile& p : makeToolSolid(tool).cutter) out.push_back(p);
  }
  ConvexProfile dovetail;
  dovetail.start(0.0, 0.0);
  dovetail.lineTo(5.0, 0.0);
  dovetail.lineTo(3.0, 4.0);
  dovetail.lineTo(0.0, 4.0);
  out.push_back(dovetail);
  ConvexProfile tooth;
  tooth.start(0.0, 1.0);
  tooth.lineTo(2.0, 1.0);
  tooth.lineTo(3.0, 2.0);
  tooth.lineTo(2.0, 3.0);
  tooth.lineTo(0.0, 3.0);
  out.push_back(tooth);
  ConvexProfile lentil;  // round below and above
  lentil.start(0.0, 0.0);
  lentil.lineTo(3.0, 0.0);
  lentil.arcTo(3.0, 1.0, 4.0, 1.0);
  lentil.arcTo(3.0, 1.0, 3.0, 2.0);
  lentil.lineTo(0.0, 2.0);
  out.push_back(lentil);
  return out;
}

template <typename Way>
struct Case {
  Way columns;
  Sweep exact;
};

class Columns : public ::testing::Test {
 protected:
  double random(double low, double high) { return moves_.number(low, high); }

  Case<LineSweep> lineCase(const ConvexProfile& profile, const ColumnSolid& solid, int style) {
    const auto [from, to] = moves_.line(style);
    return {columnLine(solid, from, to), Sweep(profile, from, to, nullptr)};
  }

  Case<ArcSweep> arcCase(const ConvexProfile& profile, const ColumnSolid& solid) {
    ArcGeometry arc;
    arc.center = moves_.point();
    arc.normal = random(0, 1) < 0.5 ? Vec3::UnitZ() : Vec3(-Vec3::UnitZ());
    arc.sweep_rad = random(-6.5, 6.5);
    const double radius = random(0.5, 9.0), start = random(0, 6.28);
    const double end = start + arc.sweep_rad * arc.normal.z();
    const Vec3 from = arc.center + Vec3(std::cos(start), std::sin(start), 0) * radius;
    const Vec3 to = arc.center + Vec3(std::cos(end), std::sin(end), 0) * radius;
    return {columnArc(solid, from, to, arc), Sweep(profile, from, to, &arc)};
  }

  template <typename Way>
  void check(const Case<Way>& c) {
    for (int i = 0; i < 64; ++i) x_[i] = random(-14, 14), y_[i] = random(-14, 14);
    kernelsOf(c.columns).columns(c.columns, x_, y_, 64, lo_, hi_);
    for (int i = 0; i < 64; ++i) {
      const auto at = [&](double z) { return c.exact.distance({x_[i], y_[i], z}, 1e300); };
      if (lo_[i] >= hi_[i]) {
        for (double z = -8; z < 22; z += 1.3) ASSERT_GT(at(z), -kStep) << x_[i] << ' ' << y_[i] << ' ' << z;
        continue;
      }
      ++intervals_;
      ASSERT_GT(at(lo_[i] - kStep), -2 * kSweepToleranceMm) << i;
      ASSERT_GT(at(hi_[i] + kStep), -2 * kSweepToleranceMm) << i;
      const double inner = std::min(kStep, 0.5 * (hi_[i] - lo_[i]));
      ASSERT_LT(at(lo_[i] + inner), 2 * kSweepToleranceMm) << i;
      ASSERT_LT(at(hi_[i] - inner), 2 * kSweepToleranceMm) << i;
      ASSERT_LT(at(0.5 * (lo_[i] + hi_[i])), 2 * kSweepToleranceMm) << i;
    }
  }

  test::RandomMoves moves_{7};
  double x_[64], y_[64], lo_[64], hi_[64];
  int intervals_ = 0;
};

TEST_F(Columns, LinesMatchTheExactDistance) {
  for (const ConvexProfile& profile : profiles()) {
    const ColumnSolid solid = columnSolid(profile);
    for (int i = 0; i < 60; ++i) {
      ASSERT_NO_FATAL_FAILURE(check(lineCase(profile, solid, i % 8)));
    }
  }
  EXPECT_GT(intervals_, 3000);
}

TEST_F(Columns, LevelArcsMatchTheExactDistance) {
  for (const ConvexProfile& profile : profiles()) {
    const ColumnSolid solid = columnSolid(profile);
    for (int i = 0; i < 60; ++i) ASSERT_NO_FATAL_FAILURE(check(arcCase(profile, solid)));
  }
  EXPECT_GT(intervals_, 3000);
}

/// A helix about z of up to three turns, or an arc in an upright plane.
struct Curve {
  Vec3 from, to;
  ArcGeometry arc;
};

class CurveColumns : public Columns {
 protected:
  Curve helix(int style) {
    Curve c;
    c.arc.center = moves_.point();
    c.arc.normal = random(0, 1) < 0.5 ? Vec3::UnitZ() : Vec3(-Vec3::UnitZ());
    c.arc.sweep_rad = random(-19.0, 19.0) * (style % 2 == 0 ? 1.0 : 0.2);
    const double start = random(0, 6.28), end = start + c.arc.sweep_rad * c.arc.normal.z();
    const double radius = style % 3 == 0 ? random(0.1, 2.0) : random(1.0, 9.0);
    c.from = c.arc.center + Vec3(std::cos(start), std::sin(start), 0) * radius;
    c.to = c.arc.center + Vec3(std::cos(end), std::sin(end), 0) * radius;
    c.to.z() += style % 5 == 0 ? 0.0 : random(-9.0, 9.0);
    return c;
  }
  Curve upright() {
    Curve c;
    const double plane = random(0, 6.28), radius = random(0.5, 20.0), start = random(0, 6.28);
    c.arc.normal = Vec3(std::cos(plane), std::sin(plane), 0.0);
    c.arc.sweep_rad = random(-6.5, 6.5);
    const Vec3 u(-c.arc.normal.y(), c.arc.normal.x(), 0.0);
    const auto out = [&](double a) -> Vec3 {
      return radius * (std::cos(a) * u + std::sin(a) * Vec3::UnitZ());
    };
    c.from = moves_.point();
    c.arc.center = c.from - out(start);
    c.to = c.arc.center + out(start + c.arc.sweep_rad);
    return c;
  }

  /// Any curve that an arc's words describe: spirals, cones of helices, arcs and helices about axes that
  /// lean.
  Curve any(int style) {
    Curve c;
    c.arc.center = moves_.point();
    c.arc.normal =
        style % 2 == 0
            ? Vec3(0, 0, style % 4 == 0 ? 1 : -1)
            : Vec3(random(-1, 1), random(-1, 1), style % 3 == 0 ? 0.0 : random(-1, 1)).normalized();
    c.arc.sweep_rad = random(-9.0, 9.0);
    const double start = random(0.1, 9.0), growth = style % 5 == 1 ? 0.0 : random(-0.09, 0.3);
    const Vec3 u = c.arc.normal.unitOrthogonal(), v = c.arc.normal.cross(u);
    const auto out = [&](double a, double r) -> Vec3 { return r * (std::cos(a) * u + std::sin(a) * v); };
    const double end = std::max(0.05, start + growth * std::abs(c.arc.sweep_rad)), a = random(0, 6.28);
    c.from = c.arc.center + out(a, start);
    c.to = c.arc.center + out(a + c.arc.sweep_rad, end);
    if (style % 3 != 1) c.to += random(-6.0, 6.0) * c.arc.normal;
    return c;
  }

  /// The intervals of all parts of the curve are what it covers, and the reach of each holds its own.
  template <typename Way>
  void check(const ConvexProfile& profile, const Curve& c, const std::vector<Way>& parts) {
    const Sweep exact(profile, c.from, c.to, &c.arc);
    for (int i = 0; i < 64; ++i) {
      x_[i] = c.from.x() + random(-14, 14), y_[i] = c.from.y() + random(-14, 14);
      low_[i].clear(), high_[i].clear();
    }
    for (const Way& part : parts) {
      kernelsOf(part).columns(part, x_, y_, 64, lo_, hi_);
      for (int i = 0; i < 64; ++i) {
        if (lo_[i] >= hi_[i]) continue;
        ++intervals_;
        low_[i].push_back(lo_[i]), high_[i].push_back(hi_[i]);
        checkReach(part, i);
      }
    }
    for (int i = 0; i < 64; ++i) ASSERT_NO_FATAL_FAILURE(checkColumn(exact, i));
  }

 private:
  template <typename Way>
  void checkReach(const Way& part, int i) {
    FourBlocks blocks{};
    blocks.half_width = random(0.1, 3.0);
    double low[4], high[4];
    for (int k = 0; k < 4; ++k) {
      blocks.x[k] = x_[i] + random(-1, 1) * blocks.half_width;
      blocks.y[k] = y_[i] + random(-1, 1) * blocks.half_width;
      blocks.z_low[k] = random(-30, 30), blocks.z_high[k] = blocks.z_low[k] + 5.0;
    }
    kernelsOf(part).reach(part, blocks, low, high);
    for (int k = 0; k < 4; ++k) {
      if (lo_[i] < blocks.z_high[k] && hi_[i] > blocks.z_low[k]) {
        EXPECT_LE(low[k], lo_[i]);
        EXPECT_GE(high[k], hi_[i]);
      }
    }
  }
  void checkColumn(const Sweep& exact, int i) {
    const auto at = [&](double z) { return exact.distance({x_[i], y_[i], z}, 1e300); };
    const auto covered = [&](double z) {
      for (std::size_t k = 0; k < low_[i].size(); ++k) {
        if (low_[i][k] < z && z < high_[i][k]) return true;
      }
      return false;
    };
    const auto check = [&](double z) {
      if (covered(z)) {
        ASSERT_LT(at(z), 2 * kSweepToleranceMm) << x_[i] << ' ' << y_[i] << ' ' << z;
      } else {
        ASSERT_GT(at(z), -2 * kSweepToleranceMm) << x_[i] << ' ' << y_[i] << ' ' << z;
      }
    };
    for (int k = 0; k < 12; ++k) check(random(-20, 30));
    for (std::size_t k = 0; k < low_[i].size(); ++k) {
      for (const double end : {low_[i][k], high_[i][k]}) check(end - kStep), check(end + kStep);
      check(0.5 * (low_[i][k] + high_[i][k]));
    }
  }

  std::vector<double> low_[64], high_[64];
};

TEST_F(CurveColumns, TurnsOfHelicesMatchTheExactDistance) {
  for (const ConvexProfile& profile : profiles()) {
    const ColumnSolid solid = columnSolid(profile);
    for (int i = 0; i < 60; ++i) {
      const Curve c = helix(i);
      ASSERT_NO_FATAL_FAILURE(check(profile, c, columnTurns(solid, c.from, c.to, c.arc))) << i;
    }
  }
  EXPECT_GT(intervals_, 10000);
}

TEST_F(CurveColumns, UprightArcsMatchTheExactDistance) {
  for (const ConvexProfile& profile : profiles()) {
    const ColumnSolid solid = columnSolid(profile);
    for (int i = 0; i < 40; ++i) {
      const Curve c = upright();
      ASSERT_NO_FATAL_FAILURE(check(profile, c, columnUprights(solid, c.from, c.to, c.arc))) << i;
    }
  }
  EXPECT_GT(intervals_, 3000);
}

TEST_F(CurveColumns, PartsOfAnyCurveMatchTheExactDistance) {
  for (const ConvexProfile& profile : profiles()) {
    const ColumnSolid solid = columnSolid(profile);
    for (int i = 0; i < 60; ++i) {
      const Curve c = any(i);
      const CurveWay way = curveWay(c.from, c.to, c.arc);
      ASSERT_NO_FATAL_FAILURE(check(profile, c, columnParts(solid, way))) << i;
    }
  }
  EXPECT_GT(intervals_, 10000);
}

/// The same by the search of one place after the other, for what the two share.
TEST_F(CurveColumns, PartsOfAnyCurveMatchADenseSearch) {
  int known = 0;
  for (const ConvexProfile& profile : profiles()) {
    const ColumnSolid solid = columnSolid(profile);
    for (int i = 0; i < 30; ++i) {
      const Curve c = any(i);
      const CurveWay way = curveWay(c.from, c.to, c.arc);
      const ArcFrame frame = arcFrame(c.from, c.to, c.arc);
      for (int k = 0; k < 8; ++k) x_[k] = c.from.x() + random(-8, 8), y_[k] = c.from.y() + random(-8, 8);
      double least[8], most[8];
      std::fill_n(least, 8, 1e300), std::fill_n(most, 8, -1e300);
      for (const WaySweep& part : columnParts(solid, way)) {
        kernelsOf(part).columns(part, x_, y_, 8, lo_, hi_);
        for (int n = 0; n < 8; ++n)
          least[n] = std::min(least[n], lo_[n]), most[n] = std::max(most[n], hi_[n]);
      }
      for (int n = 0; n < 8; ++n) {
        double low = 1e300, high = -1e300;
        for (int step = 0; step <= 20000; ++step) {
          const Vec3 p = arcPoint(frame, c.arc, step / 20000.0);
          const double r = std::hypot(p.x() - x_[n], p.y() - y_[n]);
          if (r > solid.radius) continue;
          low = std::min(low, p.z() + solid.lower.height(r));
          high = std::max(high, p.z() - solid.upper.height(r));
        }
        if (low > high) continue;
        ++known;
        // A step is up to 0.01 mm; what is found is no worse, and at smooth places no better by its square.
        ASSERT_LE(least[n], low + 1e-9) << i;
        ASSERT_GE(most[n], high - 1e-9) << i;
      }
    }
  }
  EXPECT_GT(known, 500);
}

std::vector<ColumnKernels> levels() {
  std::vector<ColumnKernels> out = {baselineKernels()};
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) out.push_back(avx2Kernels());
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl"))
    out.push_back(avx512Kernels());
#endif
  return out;
}

/// As kernelsOf, of one level.
const WayKernels<LineSweep>& kernelsAt(const ColumnKernels& level, const LineSweep&) { return level.line; }
const WayKernels<ArcSweep>& kernelsAt(const ColumnKernels& level, const ArcSweep&) { return level.arc; }
const WayKernels<TurnSweep>& kernelsAt(const ColumnKernels& level, const TurnSweep&) { return level.turn; }
const WayKernels<UprightSweep>& kernelsAt(const ColumnKernels& level, const UprightSweep&) {
  return level.upright;
}
const WayKernels<WaySweep>& kernelsAt(const ColumnKernels& level, const WaySweep&) { return level.way; }

std::uint64_t bitsOf(double value) { return std::bit_cast<std::uint64_t>(value); }

class LevelsOfCurves : public CurveColumns {
 protected:
  template <typename Way>
  void compare(const std::vector<Way>& parts) {
    for (const Way& part : parts) {
      kernelsAt(levels()[0], part).columns(part, x_, y_, 64, lo_, hi_);
      for (int i = 0; i < 64; ++i) over_ += lo_[i] < hi_[i] ? 1 : 0;
      for (const ColumnKernels& level : levels()) {
        double lo[64], hi[64];
        kernelsAt(level, part).columns(part, x_, y_, 64, lo, hi);
        for (int i = 0; i < 64; ++i) {
          ASSERT_EQ(bitsOf(lo[i]), bitsOf(lo_[i])) << level.name;
          ASSERT_EQ(bitsOf(hi[i]), bitsOf(hi_[i])) << level.name;
        }
      }
    }
  }
  int over_ = 0;
};

TEST_F(LevelsOfCurves, EveryLevelGivesTheSameBits) {
  if (levels().size() == 1) GTEST_SKIP() << "this machine has the baseline level only";
  for (const ConvexProfile& profile : profiles()) {
    const ColumnSolid solid = columnSolid(profile);
    for (int round = 0; round < 40; ++round) {
      const int kind = round % 4;
      const Curve c = kind == 3 ? any(round) : kind == 2 ? upright() : helix(round);
      for (int i = 0; i < 64; ++i) x_[i] = c.from.x() + random(-14, 14), y_[i] = c.from.y() + random(-14, 14);
      const CurveWay way = curveWay(c.from, c.to, c.arc);
      if (kind == 3) {
        ASSERT_NO_FATAL_FAILURE(compare(columnParts(solid, way)));
      } else if (kind == 2) {
        ASSERT_NO_FATAL_FAILURE(compare(columnUprights(solid, c.from, c.to, c.arc)));
      } else {
        ASSERT_NO_FATAL_FAILURE(compare(columnTurns(solid, c.from, c.to, c.arc)));
      }
    }
  }
  EXPECT_GT(over_, 5000);
}

class LevelsOfLeaves : public Columns {
 protected:
  template <typename Way>
  void compare(const Way& way, unsigned together) {
    LeafColumns start{};
    for (int i = 0; i < 64; ++i) {
      start.x[i] = random(-6, 6), start.y[i] = random(-6, 6);
      start.material[i] = 255, start.top[i] = 8.0;
    }
    for (int z = 0; z < 8; ++z) start.z[z] = z;
    start.h = 1.0;
    start.layers = 8;
    LeafColumns first = start;
    const double sunk = sink(levels()[0], way, first, 0);
    for (const ColumnKernels& level : levels()) {
      LeafColumns other = start;
      EXPECT_EQ(bitsOf(sink(level, way, other, together)), bitsOf(sunk));
      for (int i = 0; i < 64; ++i) {
        ASSERT_EQ(bitsOf(other.lo[i]), bitsOf(first.lo[i])) << level.name;
        ASSERT_EQ(bitsOf(other.hi[i]), bitsOf(first.hi[i])) << level.name;
        ASSERT_EQ(other.covered[i], first.covered[i]) << level.name;
      }
    }
  }

 private:
  /// Quarters that go together have the same bits as each alone.
  template <typename Way>
  double sink(const ColumnKernels& level, const Way& way, LeafColumns& leaf, unsigned together) {
    double sum = 0.0;
    kernelsAt(level, way).leaf(way, leaf, together);
    for (int q = 0; q < 4; ++q) {
      if ((together >> q & 1) == 0) kernelsAt(level, way).leaf(way, leaf, 1u << q);
      sum += level.lower(leaf, q);
      level.cover(leaf, q);
    }
    return sum;
  }
};

TEST_F(LevelsOfLeaves, EveryLevelGivesTheSameBits) {
  if (levels().size() == 1) GTEST_SKIP() << "this machine has the baseline level only";
  for (const ConvexProfile& profile : profiles()) {
    const ColumnSolid solid = columnSolid(profile);
    for (int round = 0; round < 40; ++round) {
      const unsigned together = static_cast<unsigned>(round) % 16;
      if (round % 4 == 3) {
        ASSERT_NO_FATAL_FAILURE(compare(arcCase(profile, solid).columns, together));
      } else {
        ASSERT_NO_FATAL_FAILURE(compare(lineCase(profile, solid, round % 8).columns, together));
      }
    }
  }
}

/// The test without roots: where it says no, no top sinks; for balls it seldom says more than that.
TEST_F(Columns, HitsLeaveOutOnlyWhatTakesNothing) {
  int sinking = 0, said = 0;
  for (const char* text : {"1=ball:6", "2=ball:2.5", "3=flat:6", "4=bull:8:1.5", "whole ball"}) {
    ConvexProfile profile;
    if (std::string(text) == "whole ball") {
      profile.start(0.0, 0.0), profile.arcTo(0.0, 3.0, 0.0, 6.0);
    } else {
      Tool tool = parseToolOption(text).value();
      tool.flute_length = 40.0;
      profile = makeToolSolid(tool).cutter.front();
    }
    const ColumnSolid solid = columnSolid(profile);
    for (int round = 0; round < 4000; ++round) {
      const LineSweep line = lineCase(profile, solid, round % 8).columns;
      LeafColumns leaf{};
      const double left = random(-8, 8), front = random(-8, 8), top = random(-4, 6);
      for (int i = 0; i < 64; ++i) {
        leaf.x[leafColumn(i / 8, i % 8)] = left + 0.1 * (i / 8);
        leaf.y[leafColumn(i / 8, i % 8)] = front + 0.1 * (i % 8);
        leaf.top[i] = top - random(0, 0.5);
      }
      leaf.z[0] = top - 0.4;  // some columns are empty
      for (int i = 0; i < 64; ++i) leaf.top[i] = std::max(leaf.top[i], leaf.z[0]);
      leaf.h = 0.1;
      const bool counts = solid.ball && !solid.sphere && line.length > 0.0;
      const unsigned hits = levels()[0].hits(line, leaf, 15);
      for (const ColumnKernels& level : levels()) ASSERT_EQ(level.hits(line, leaf, 15), hits) << level.name;
      columnKernels().line.leaf(line, leaf, 15);
      for (int q = 0; q < 4; ++q) {
        const bool sinks = columnKernels().lower(leaf, q) > 0.0;
        ASSERT_TRUE(!sinks || (hits >> q & 1) != 0) << text << ' ' << round;
        sinking += sinks && counts;
        said += (hits >> q & 1) != 0 && counts;
      }
    }
  }
  EXPECT_GT(sinking, 1000);
  EXPECT_LT(said, 1.01 * sinking);
}

}  // namespace
}  // namespace proveout
