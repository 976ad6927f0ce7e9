// The swept distance fields against a slow reference: the least distance over many positions of the tool,
// with the tool's distance from a dense polygon of its profile.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/tool/tool_solid.h"
#include "removal/sweep.h"

namespace proveout {
namespace {

constexpr double kFlute = 15.0;

std::vector<Tool> sampleTools() {
  std::vector<Tool> tools;
  for (const char* text : {"1=flat:6", "2=ball:6", "3=bull:8:1.5", "4=cone:6:0.4:60", "5=drill:5:118",
                           "6=cone:8:0:120", "7=bull:6:3"}) {
    Tool tool = parseToolOption(text).value();
    tool.flute_length = kFlute;
    tools.push_back(tool);
  }
  return tools;
}

/// Boundary points of a tool's profile, from the drawing of each type, and an inside test of its own.
struct ReferenceTool {
  std::vector<Vec2> boundary;
  std::function<bool(double, double)> inside;

  double distance(double r, double z) const {
    double best = 1e300;
    for (const Vec2& b : boundary) best = std::min(best, (b - Vec2(r, z)).squaredNorm());
    return inside(r, z) ? -std::sqrt(best) : std::sqrt(best);
  }
};

/// Lower limit of the tool at radius r (height), infinity outside.
double lowerHeight(const Tool& t, double r) {
  const double R = t.diameter / 2;
  if (r > R) return 1e9;
  switch (t.type) {
    case ToolType::kFlat:
      return 0.0;
    case ToolType::kBall:
      return R - std::sqrt(R * R - r * r);
    case ToolType::kBull: {
      const double c = t.corner_radius, over = std::max(0.0, r - (R - c));
      return c - std::sqrt(std::max(0.0, c * c - over * over));
    }
    case ToolType::kCone:
      return std::max(0.0, r - t.tip_diameter / 2) / std::tan(degToRad(t.cone_angle_deg / 2));
    case ToolType::kDrill:
      return r / std::tan(degToRad(t.point_angle_deg / 2));
  }
  return 0.0;
}

ReferenceTool reference(const Tool& t, int n) {
  ReferenceTool ref;
  const double R = t.diameter / 2;
  for (int i = 0; i <= n; ++i) {
    // Cosine spacing puts points where round ends are steep.
    const double r = R * std::sin(0.5 * kPi * i / n);
    ref.boundary.emplace_back(r, lowerHeight(t, r));
    ref.boundary.emplace_back(R * i / n, kFlute);
  }
  const double side = lowerHeight(t, R);
  for (int i = 0; i <= n; ++i) ref.boundary.emplace_back(R, side + (kFlute - side) * i / n);
  ref.inside = [t](double r, double z) { return z <= kFlute && z >= lowerHeight(t, r); };
  return ref;
}

TEST(Profile, DistanceMatchesDensePolygon) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> radius(0, 9), height(-5, 20);
  for (const Tool& tool : sampleTools()) {
    const ConvexProfile profile = makeToolSolid(tool).cutter.front();
    const ReferenceTool ref = reference(tool, 3000);
    for (int i = 0; i < 300; ++i) {
      const double r = radius(random), z = height(random);
      const ProfileSample s = profile.sample(r, z);
      ASSERT_NEAR(s.value, ref.distance(r, z), 8e-3) << "tool " << tool.number << " r " << r << " z " << z;
      ASSERT_NEAR(std::hypot(s.gr, s.gz), 1.0, 1e-12);
      const double step = 1e-6;  // the gradient is the slope of the value
      const double along = profile.sample(std::max(0.0, r + step * s.gr), z + step * s.gz).value;
      if (r > 0.01) {
        ASSERT_NEAR(along - s.value, step, 1e-9);
      }
    }
  }
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

/// The exact value lies between the least sample less half a step's travel and the least sample.
void expectField(const Case& c, const Tool& tool, Cases& points, unsigned seed) {
  const ConvexProfile profile = makeToolSolid(tool).cutter.front();
  const Sweep sweep(profile, c.from, c.to, c.arc ? &c.geometry : nullptr);
  const int n = 4000;
  std::vector<Vec3> positions;
  double travel = 0.0;
  for (int i = 0; i <= n; ++i) {
    positions.push_back(positionAt(c, static_cast<double>(i) / n));
    if (i > 0) travel = std::max(travel, (positions[i] - positions[i - 1]).norm());
  }
  for (int k = 0; k < 12; ++k) {
    const Vec3 p = points.point() + Vec3(0, 0, 4);
    double least = 1e300;
    for (const Vec3& at : positions) {
      const Vec3 q = p - at;
      least = std::min(least, profile.sample(q.head<2>().norm(), q.z()).value);
    }
    const SweepSample s = sweep.sample(p);
    const double tolerance = kSweepToleranceMm + (c.arc ? 1e-4 * std::abs(s.value) : 0.0);
    ASSERT_LE(s.value, least + tolerance) << "seed " << seed << " tool " << tool.number;
    ASSERT_GE(s.value, least - 0.51 * travel - tolerance) << "seed " << seed << " tool " << tool.number;
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
    const double cut = sweep.distance(p, 1.0);
    if (s.value <= 1.0) {
      ASSERT_NEAR(cut, s.value, tolerance);
    } else {
      ASSERT_GT(cut, 1.0);
      ASSERT_LE(cut, s.value + tolerance);
    }
  }
}

TEST(SweepField, LinesMatchSampledMinimum) {
  for (unsigned seed = 0; seed < 24; ++seed) {
    Cases cases(seed);
    for (const Tool& tool : sampleTools())
      expectField(cases.line(static_cast<int>(seed % 4)), tool, cases, seed);
  }
}

TEST(SweepField, ArcsHelicesAndSpiralsMatchSampledMinimum) {
  for (unsigned seed = 0; seed < 64; ++seed) {
    Cases cases(seed + 1000);
    for (const Tool& tool : sampleTools())
      expectField(cases.arc(static_cast<int>(seed % 16)), tool, cases, seed);
  }
}

TEST(SweepField, SplittingAMoveChangesNothing) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    Cases cases(seed + 5000);
    const Case c = cases.line(0);
    for (const Tool& tool : sampleTools()) {
      const ConvexProfile profile = makeToolSolid(tool).cutter.front();
      const Vec3 middle = c.from + 0.37 * (c.to - c.from);
      const Sweep whole(profile, c.from, c.to, nullptr), first(profile, c.from, middle, nullptr),
          second(profile, middle, c.to, nullptr);
      const Vec3 p = cases.point();
      ASSERT_NEAR(whole.sample(p).value, std::min(first.sample(p).value, second.sample(p).value),
                  3 * kSweepToleranceMm)
          << seed;
    }
  }
}

}  // namespace
}  // namespace proveout
