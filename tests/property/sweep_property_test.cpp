// The swept distance fields of every tool type against a slow reference: the least distance over many
// positions of the tool. The distance to the tool itself is tested against drawings in tests/unit/tool.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "core/tool/tool_solid.h"
#include "removal/sweep/sweep.h"
#include "tests/unit/tool/drawings.h"

namespace proveout {
namespace {

/// One convex part of each tool, and of some of several parts all.
struct Part {
  std::string name;
  ConvexProfile profile;
};

std::vector<Part> sampleParts() {
  std::vector<Part> parts;
  for (const test::Drawing& d : test::drawings(1)) {
    // The many chords of a hollow arc are all alike: the first stands for them.
    const auto cutter = makeToolSolid(d.tool).cutter;
    const std::size_t count = d.hollow > 0.0 ? 1 : cutter.size();
    for (std::size_t i = 0; i < count; ++i) parts.push_back({d.name, cutter[i]});
  }
  return parts;
}

struct Case {
  Vec3 from, to;
  bool arc = false;
  ArcGeometry geometry;
};

class Cases {
 public:
  explicit Cases(unsigned seed) : random_(seed) {}

  Case line(int kind) {
    Case c;
    c.from = point();
    c.to = point();
    if (kind == 1) c.to.z() = c.from.z();
    if (kind == 2) c.to.head<2>() = c.from.head<2>();
    if (kind == 3) c.to = c.from;
    return c;
  }

  Case arc(int kind) {
    Case c;
    c.arc = true;
    c.from = point();
    Vec3 axis = kind % 4 == 3 ? point().normalized() : Vec3(Vec3::Unit(kind % 4));
    if (kind >= 12) axis = Vec3(0, 0, kind % 2 ? 1 : -1);
    c.geometry.normal = axis;
    Vec3 radial = point();
    radial -= axis * axis.dot(radial);
    c.geometry.center = c.from + radial;
    c.geometry.sweep_rad = (unit_(random_) * 2 - 1) * 3 * kPi;
    const double rise = kind >= 4 && kind < 12 ? 10 * unit_(random_) - 5 : 0.0;
    // From 8 on spirals (from 12 on level), every other only as far off a circle as rounded ends leave it.
    const double grow =
        kind >= 8 ? (kind % 4 < 2 ? 0.7 + 0.6 * unit_(random_) : 1.0 + 1e-4 * unit_(random_)) : 1.0;
    c.to = c.geometry.center + Eigen::AngleAxisd(c.geometry.sweep_rad, axis) * (-radial * grow) + axis * rise;
    return c;
  }

  Vec3 point() { return Vec3(unit_(random_), unit_(random_), unit_(random_)) * 24 - Vec3(12, 12, 12); }

 private:
  std::mt19937 random_;
  std::uniform_real_distribution<double> unit_{0, 1};
};

Vec3 positionAt(const Case& c, double t) {
  return c.arc ? arcPoint(arcFrame(c.from, c.to, c.geometry), c.geometry, t)
               : Vec3(c.from + t * (c.to - c.from));
}

/// Least distance over the motion, in double precision: dense positions of the tool, then a golden section
/// around each of them that could be the least.
class SlowSweep {
 public:
  SlowSweep(const ConvexProfile& profile, const Case& c) : profile_(profile), case_(c), values_(kCount + 1) {
    for (int i = 0; i <= kCount; ++i) positions_.push_back(positionAt(c, static_cast<double>(i) / kCount));
    for (int i = 1; i <= kCount; ++i) travel_ = std::max(travel_, (positions_[i] - positions_[i - 1]).norm());
  }

  double distance(const Vec3& p) {
    for (int i = 0; i <= kCount; ++i) values_[i] = at(p, positions_[i]);
    double least = *std::min_element(values_.begin(), values_.end());
    const double limit = least + travel_;  // the distance changes by the travel at most
    for (int i = 0; i <= kCount; ++i) {
      if (values_[i] > limit) continue;
      if ((i > 0 && values_[i - 1] < values_[i]) || (i < kCount && values_[i + 1] < values_[i])) continue;
      least = std::min(least, refine(p, std::max(0, i - 1), std::min(kCount, i + 1)));
    }
    return least;
  }

 private:
  static constexpr int kCount = 800;

  double at(const Vec3& p, const Vec3& position) const {
    const Vec3 q = p - position;
    return profile_.sample(q.head<2>().norm(), q.z()).value;
  }

  double refine(const Vec3& p, int first, int last) const {
    double a = static_cast<double>(first) / kCount, b = static_cast<double>(last) / kCount, least = 1e300;
    for (int i = 0; i < 60; ++i) {
      const double s = a + 0.381966 * (b - a), t = a + 0.618034 * (b - a);
      const double fs = at(p, positionAt(case_, s)), ft = at(p, positionAt(case_, t));
      least = std::min({least, fs, ft});
      (fs < ft ? b : a) = fs < ft ? t : s;
    }
    return least;
  }

  const ConvexProfile& profile_;
  const Case& case_;
  std::vector<Vec3> positions_;
  std::vector<double> values_;
  double travel_ = 0.0;
};

/// Bound: kSweepToleranceMm; along curves away from the surface also 1e-4 of the distance (see sweep.h).
void expectField(const Case& c, const Part& part, Cases& points, unsigned seed) {
  const ConvexProfile& profile = part.profile;
  const Sweep sweep(profile, c.from, c.to, c.arc ? &c.geometry : nullptr);
  SlowSweep slow(profile, c);
  for (int k = 0; k < 6; ++k) {
    const Vec3 p = points.point() + Vec3(0, 0, 4);
    const double least = slow.distance(p);
    const SweepSample s = sweep.sample(p);
    const double tolerance = kSweepToleranceMm + (c.arc ? 1e-4 * std::abs(s.value) : 0.0);
    ASSERT_NEAR(s.value, least, tolerance) << "seed " << seed << " tool " << part.name;
    ASSERT_NEAR(sweep.distance(p, 1e9), s.value, tolerance);
    double column[3];
    const double far[3] = {1e9, 1e9, 1e9};
    sweep.column(p.x(), p.y(), p.z(), 0.5, 3, far, column);
    ASSERT_NEAR(column[0], s.value, tolerance);
    ASSERT_NEAR(column[2], sweep.distance(p + Vec3(0, 0, 1), 1e9), tolerance);
    if (s.value <= 0.0) {
      ASSERT_TRUE((p.array() >= sweep.bounds().min.array() - 1e-9).all() &&
                  (p.array() <= sweep.bounds().max.array() + 1e-9).all())
          << "seed " << seed;
    }
    const double near[3] = {0.0, 1e9, 0.5};
    sweep.column(p.x(), p.y(), p.z(), 0.5, 3, near, column);
    if (s.value <= 0.0) {
      ASSERT_NEAR(column[0], s.value, tolerance);
    } else {
      ASSERT_GT(column[0], 0.0);
      ASSERT_LE(column[0], s.value + tolerance);
    }
    // A cutoff may only replace values above it, by something above it.
    for (const double cutoff : {1.0, s.value - 0.3, s.value + 0.3}) {
      const double cut = sweep.distance(p, cutoff);
      if (s.value <= cutoff) {
        ASSERT_NEAR(cut, s.value, tolerance);
      } else {
        ASSERT_GT(cut, cutoff);
        ASSERT_LE(cut, s.value + tolerance);
      }
    }
  }
}

TEST(SweepField, LinesMatchSampledMinimum) {
  for (unsigned seed = 0; seed < 24; ++seed) {
    Cases cases(seed);
    for (const Part& part : sampleParts())
      expectField(cases.line(static_cast<int>(seed % 4)), part, cases, seed);
  }
}

TEST(SweepField, ArcsHelicesAndSpiralsMatchSampledMinimum) {
  for (unsigned seed = 0; seed < 64; ++seed) {
    Cases cases(seed + 1000);
    for (const Part& part : sampleParts())
      expectField(cases.arc(static_cast<int>(seed % 16)), part, cases, seed);
  }
}

/// Helices about z, narrower and wider than the tool, of parts of a turn and of many, flat and steep; the
/// radius is one, or off by the rounding of a program. Points lie near the surface, above the way and on its
/// axis.
TEST(SweepField, HelicesAboutZMatchSampledMinimumNearTheSurface) {
  int near = 0, held = 0;
  for (unsigned seed = 0; seed < 48; ++seed) {
    Cases cases(seed + 7000);
    std::mt19937 random(seed);
    const auto number = [&](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(random);
    };
    Case c;
    c.arc = true;
    c.from = cases.point();
    c.geometry.normal = Vec3(0, 0, seed % 2 == 0 ? 1 : -1);
    const double radius = seed % 3 == 0 ? number(0.05, 1.0) : number(1.0, 12.0);
    c.geometry.center = c.from - Vec3(radius, 0, 0);
    c.geometry.sweep_rad = (seed % 4 < 2 ? 1 : -1) * number(0.2, seed % 5 == 0 ? 40.0 : 7.0);
    const double off = seed % 2 == 0 ? 0.0 : number(-1e-4, 1e-4), rise = number(-12, 12);
    c.to = c.geometry.center +
           Eigen::AngleAxisd(c.geometry.sweep_rad, c.geometry.normal) * Vec3(radius + off, 0, 0) +
           Vec3(0, 0, rise);
    for (const auto& [name, profile] : sampleParts()) {
      const Sweep sweep(profile, c.from, c.to, &c.geometry);
      SlowSweep slow(profile, c);
      const Vec3 any = cases.point(), on_way = positionAt(c, number(0, 1)) + Vec3(0, 0, number(-9, 1));
      const Vec3 on_axis = c.geometry.center + Vec3(1e-7, 0, number(-9, 9));
      for (Vec3 p : {any, on_way, on_axis}) {
        for (int step = 0; step < 3; ++step) {  // to the surface, the last time to 0.001 mm outside of it
          const SweepSample s = sweep.sample(p);
          const double least = slow.distance(p), within = kSweepToleranceMm + 1e-4 * std::abs(least);
          ASSERT_NEAR(s.value, least, within) << "seed " << seed << " tool " << name << " step " << step;
          ASSERT_EQ(sweep.distance(p, 0.0) < 0.0, s.value < 0.0)
              << "seed " << seed << " tool " << name << " step " << step << " distance " << s.value;
          double start = number(0, 1);
          if (least > 1e-4) {
            ASSERT_NEAR(sweep.sampleOutside(p, 1e-5, start).value, least, 1e-5 + within)
                << "seed " << seed << " tool " << name;
          }
          const Vec3 other = p + 0.3 * cases.point().normalized();
          if (sweep.holds(p, other)) {
            ++held;
            for (const double at : {0.0, 0.25, 0.5, 0.75, 1.0})
              ASSERT_LT(slow.distance(p + at * (other - p)), kSweepToleranceMm)
                  << "seed " << seed << " tool " << name;
          }
          near += std::abs(least) < 0.01;
          p -= (s.value - 0.001) * s.gradient;
        }
      }
    }
  }
  EXPECT_GT(near, 1000);
  EXPECT_GT(held, 300);
}

/// From a point in the material, near the surface or far, and from wherever the search sets out: the nearest
/// point is on the surface.
TEST(SweepField, NearestPointsAreOnTheSurfaceWhateverTheStart) {
  constexpr double kTolerance = 1e-5;
  int near = 0, far = 0;
  for (unsigned seed = 0; seed < 120; ++seed) {
    Cases cases(seed + 9000);
    const Case c = cases.line(seed % 3 == 0 ? 1 : 0);
    for (const auto& [name, profile] : sampleParts()) {
      const Sweep sweep(profile, c.from, c.to, nullptr);
      const Vec3 away = cases.point();
      const SweepSample there = sweep.sample(away);
      if (there.value <= 0.1) continue;
      const Vec3 close = away - (there.value - 0.05) * there.gradient;
      for (const Vec3& p : {away, close}) {
        const double least = sweep.sample(p).value;
        if (least <= kTolerance) continue;
        (p == close ? near : far) += 1;
        for (const double from : {-1.0, 0.0, 0.31, 0.5, 1.0}) {
          double start = from;
          const SweepSample s = sweep.sampleOutside(p, kTolerance, start);
          ASSERT_NEAR(s.value, least, kTolerance + kSweepToleranceMm)
              << seed << " tool " << name << " from " << from;
          ASSERT_NEAR(s.gradient.norm(), 1.0, 1e-9);
          const double off = sweep.sample(p - s.value * s.gradient).value;
          ASSERT_GE(off, -kTolerance - kSweepToleranceMm) << seed << " tool " << name << " from " << from;
          ASSERT_LE(off, kSweepToleranceMm) << seed << " tool " << name << " from " << from;
          ASSERT_TRUE(start == -1.0 || (start >= 0.0 && start <= 1.0));
        }
      }
    }
  }
  EXPECT_GT(near, 500);
  EXPECT_GT(far, 500);
}

TEST(SweepField, SplittingAMoveChangesNothing) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    Cases cases(seed + 5000);
    const Case c = cases.line(0);
    for (const auto& [name, profile] : sampleParts()) {
      const Vec3 middle = c.from + 0.37 * (c.to - c.from);
      const Sweep whole(profile, c.from, c.to, nullptr), first(profile, c.from, middle, nullptr),
          second(profile, middle, c.to, nullptr);
      const Vec3 p = cases.point();
      ASSERT_NEAR(whole.sample(p).value, std::min(first.sample(p).value, second.sample(p).value),
                  3 * kSweepToleranceMm)
          << seed << " tool " << name;
    }
  }
}

}  // namespace
}  // namespace proveout
