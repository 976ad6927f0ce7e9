// Worms of several starts: which passes count, what is left of the bar, and what the tool touches.
#include "tests/support/worm.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/mesh/intersections.h"
#include "removal/turning/threads/thread_mesh.h"

namespace proveout {
namespace {

using test::Worm;

constexpr double kLength = 80.0;

struct Cut {
  TurnedShape shape;
  RemovalSummary summary;
};

Cut cut(const Worm& worm) {
  Progress progress;
  Cut out;
  Result<TurnedStock> stock = TurnedStock::create(bar(worm.bar, kLength));
  EXPECT_TRUE(stock);
  Result<RemovalSummary> removed = stock->remove(worm.path().path, {worm.tool()}, progress);
  EXPECT_TRUE(removed);
  out.summary = std::move(*removed);
  out.shape = stock->shape();
  return out;
}

/// The integral of r over the section of the groove, mm3 / rad: the union of all circles inside of the bar,
/// by heights at many radii.
double moment(const Worm& worm) {
  constexpr int kSteps = 40000;
  const double low = worm.bar - worm.depth, step = worm.depth / kSteps;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double r = low + (i + 0.5) * step;
    std::vector<std::pair<double, double>> spans;
    for (const Vec2& c : worm.centers()) {
      const double off = r - worm.bar - c.x(), half2 = worm.insert * worm.insert - off * off;
      if (half2 > 0.0) spans.emplace_back(c.y() - std::sqrt(half2), c.y() + std::sqrt(half2));
    }
    std::sort(spans.begin(), spans.end());
    double end = -1e9;
    for (const auto& [from, to] : spans) {
      if (to > end) sum += r * step * (to - std::max(from, end));
      end = std::max(end, to);
    }
  }
  return sum;
}

/// What all passes take, mm3: each point of a groove's section is in the bar from where its way passes the
/// face to where it ends, and the section is as long on either side of its middle.
double taken(const Worm& worm, double moment_mm3) {
  return worm.starts * 2.0 * kPi / worm.lead * -worm.end * moment_mm3;
}

/// The largest of the bar's and of all passes' distances, slowly: below 0 in the part. `slack`: turns by
/// which ways are longer.
double valueOf(const Worm& worm, const std::vector<Vec2>& centers, const Vec3& p, double slack) {
  const double r = std::hypot(p.x(), p.y()), phi = std::atan2(p.y(), p.x());
  double value = std::max({r - worm.bar, p.z(), -kLength - p.z()});
  const double turns = (worm.front - worm.end) / worm.lead;
  for (int j = 0; j < worm.starts; ++j) {
    // The tool goes round against +X to +Y from the angle of the start.
    const double first = -phi / (2.0 * kPi) - static_cast<double>(j) / worm.starts;
    for (double t = first - std::floor(first + slack); t <= turns + slack; t += 1.0) {
      for (const Vec2& c : centers) {
        const Vec2 center(worm.bar + c.x(), worm.front + c.y() - worm.lead * t);
        value = std::max(value, worm.insert - (Vec2(r, p.z()) - center).norm());
      }
    }
  }
  return value;
}

TEST(Worm, AHalfRoundGrooveHasItsClosedFormVolume) {
  const Worm worm{.starts = 3, .depth = 2.0, .insert = 2.0, .lead = 24.0};
  const Cut made = cut(worm);
  // The one pass a start that counts, since the second one finds nothing.
  EXPECT_EQ(made.shape.threads.size(), 3u);
  const double half = 0.5 * kPi * 4.0 * worm.bar - 2.0 / 3.0 * 8.0;
  EXPECT_NEAR(moment(worm) / half, 1.0, 1e-6);
  const double bar_mm3 = kPi * worm.bar * worm.bar * kLength;
  const double left = threadedVolume(made.shape.bodies.front(), made.shape.threads);
  EXPECT_NEAR((bar_mm3 - left) / taken(worm, half), 1.0, 1e-4);
}

TEST(Worm, OfManyPassesTheOuterOnesCountAndTheVolumeStays) {
  const Worm worm{.starts = 2, .layer = 0.3, .step = 0.45};
  const Cut made = cut(worm);
  ASSERT_EQ(worm.passes(), 128);
  EXPECT_LT(made.shape.threads.size(), 90u);
  EXPECT_EQ(made.shape.threads.size() % 2, 0u);
  const auto surface = threadedSurface(made.shape.bodies.front(), made.shape.threads, 2e-3, Progress());
  ASSERT_TRUE(surface);
  const double bar_mm3 = kPi * worm.bar * worm.bar * kLength, all = taken(worm, moment(worm));
  EXPECT_NEAR((bar_mm3 - surface->volume_mm3) / all, 1.0, 1e-4);
  EXPECT_TRUE(analyseTopology(surface->mesh).closedManifold());
  EXPECT_NEAR(meshVolume(surface->mesh), surface->volume_mm3, 2e-4 * surface->volume_mm3);
}

/// The front face cuts ridge after ridge, and each time takes sections of its own. What the face does not
/// reach has the triangles that it has behind it, where the sections are as far apart as the tolerance
/// allows.
TEST(Worm, SectionsForTheFaceDoNotDivideTheGrooves) {
  const Worm worm{.starts = 2, .layer = 0.3, .step = 0.45};
  const Cut made = cut(worm);
  const auto surface = threadedSurface(made.shape.bodies.front(), made.shape.threads, 2e-3, Progress());
  ASSERT_TRUE(surface);
  const double in_a_step = 2.0 * kPi / circleSteps(worm.bar, 2e-3);
  std::set<long> behind, all;  // angles of points, in parts of a step
  for (const Eigen::Vector3f& p : surface->mesh.positions) {
    if (std::hypot(p.x(), p.y()) < worm.bar - 2.9f || p.z() > 0.0f) continue;
    const long angle = std::lround(std::atan2(p.y(), p.x()) / (1e-3 * in_a_step));
    all.insert(angle);
    if (p.z() < -0.4 * kLength && p.z() > worm.end + 1.1 * worm.depth) behind.insert(angle);
  }
  EXPECT_LE(behind.size(), static_cast<std::size_t>(circleSteps(worm.bar, 2e-3)) + 8);
  EXPECT_GT(all.size(), behind.size() + behind.size() / 2);
}

TEST(Worm, VerticesLieOnTheCircularSweepsOfAllPasses) {
  const Worm worm{.starts = 2, .layer = 0.3, .step = 0.45};
  const Cut made = cut(worm);
  const auto surface = threadedSurface(made.shape.bodies.front(), made.shape.threads, 2e-3, Progress());
  ASSERT_TRUE(surface);
  const std::vector<Vec2> centers = worm.centers();
  double most = 0.0;
  const auto& positions = surface->mesh.positions;
  for (std::size_t i = 0; i < positions.size(); i += 7) {
    const Vec3 p = positions[i].cast<double>();
    // Where a way ends the wall belongs to both.
    const double with = valueOf(worm, centers, p, 1e-6), without = valueOf(worm, centers, p, -1e-6);
    most = std::max(most, std::min(std::abs(with), std::abs(without)));
  }
  EXPECT_LT(most, 2e-4);  // chords of the insert leave its circle by 0.0001 mm
}

TEST(Worm, EachPassHasTheMotionOfWhatItLeaves) {
  const Worm worm{.starts = 2, .layer = 0.3, .step = 0.45};
  const Cut made = cut(worm);
  const auto surface = threadedSurface(made.shape.bodies.front(), made.shape.threads, 2e-3, Progress());
  ASSERT_TRUE(surface);
  const Toolpath path = worm.path().path;
  const TriMesh& mesh = surface->mesh;
  int looked = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 101) {
    if (mesh.motion[t] >= path.motions.size()) continue;
    const Motion& motion = path.motions[mesh.motion[t]];
    ASSERT_EQ(motion.kind, MotionKind::kThread);
    const auto& v = mesh.triangles[t];
    const Vec3 p = ((mesh.positions[v[0]] + mesh.positions[v[1]] + mesh.positions[v[2]]) / 3).cast<double>();
    const double r = std::hypot(p.x(), p.y());
    // Not the bar's own surface, nor the walls where the passes end.
    if (r > worm.bar - 0.3 || p.z() < worm.end + 1.1 * worm.depth) continue;
    // At the triangle's angle the insert of its motion is a radius away, on one of its turns.
    const double start = static_cast<double>(motion.thread_start_deg) / 360.0,
                 first = -std::atan2(p.y(), p.x()) / (2.0 * kPi) - start;
    double nearest = 1e9;
    for (int k = -3; k <= 3; ++k) {
      const Vec2 center(motion.from.x(), motion.from.z() - worm.lead * (first + k));
      nearest = std::min(nearest, std::abs((Vec2(r, p.z()) - center).norm() - worm.insert));
    }
    EXPECT_LT(nearest, 0.02) << p.transpose();
    ++looked;
  }
  EXPECT_GT(looked, 100);
}

TEST(Worm, TheInsertLeavesThroughWhatThePassesBeforeHaveCut) {
  const Worm fine{.starts = 2, .layer = 0.3, .step = 0.3};
  EXPECT_TRUE(cut(fine).summary.contacts.empty());
}

TEST(Worm, AnInsertThatLeavesAGrooveNarrowerThanItselfIsAContactOfItsMotion) {
  // One pass, its centre below the surface by more than the radius: the way out is not there.
  Worm worm{.starts = 1};
  TurningPath path({30, 10});
  path.rapid(18, 10).thread(18, -60, 1.75).rapid(30, -60);
  Progress progress;
  Result<TurnedStock> stock = TurnedStock::create(bar(worm.bar, kLength));
  ASSERT_TRUE(stock);
  const Result<RemovalSummary> removed = stock->remove(path.path, {worm.tool()}, progress);
  ASSERT_TRUE(removed);
  ASSERT_EQ(removed->contacts.size(), 1u);
  EXPECT_EQ(removed->contacts[0].kind, ContactKind::kRapid);
  EXPECT_EQ(removed->contacts[0].motion, 2u);
}

}  // namespace
}  // namespace proveout
