// A motion that is cut in two is the same motion: pieces fall where they come free, not at ends of blocks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/unit/turning/turning_fixture.h"

namespace proveout {
namespace {

/// Of the blank; below that pieces are dust of rounding.
constexpr double kVolumeShare = 1e-6;

struct Job {
  CylinderShape blank;
  std::vector<Tool> tools;
  Toolpath path;
};

class RandomJob {
 public:
  explicit RandomJob(std::uint32_t seed) : random_(seed) {}

  Job make() {
    Job job;
    radius_ = number(2, 20);
    length_ = number(3, 40);
    job.blank = bar(radius_, length_, chance(0.3) ? radius_ * number(0.1, 0.9) : 0.0);
    job.blank.length += 1.0;
    Insert round;
    round.shape = InsertShape::kRound;
    round.nose_radius = number(0.3, 3);
    round.orientation = 8;
    job.tools = {insertTool(1, turningInsert(number(0.1, 0.8))),
                 insertTool(2, grooveInsert(number(0.5, 3), chance(0.3) ? 0.0 : 0.2)), insertTool(3, round)};
    TurningPath path({radius_ + 5, 4});
    const int pieces = whole(1, 4);
    for (int k = 0; k < pieces; ++k) addPiece(path);
    job.path = path.path;
    return job;
  }

 private:
  double number(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
  int whole(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }
  bool chance(double part) { return number(0, 1) < part; }

  void addPiece(TurningPath& path) {
    path.tool(whole(1, 3));
    Vec2 at(radius_ * number(0.3, 1.1), number(-length_, 2));
    path.rapid(radius_ + 5, chance(0.5) ? at.y() : 4);
    for (int k = whole(1, 5); k > 0; --k) {
      const Vec2 to(radius_ * number(-0.1, 1.15), number(-length_, 1.5));
      const int style = whole(0, 4);
      if (style == 0) path.feed(to.x(), at.y());
      if (style == 1) path.feed(at.x(), to.y());
      if (style == 2) addArc(path, to);
      if (style > 2) path.feed(to.x(), to.y());
      at = {path.path.motions.back().to.x(), path.path.motions.back().to.z()};
    }
    path.feed(radius_ + 6, at.y()).rapid(radius_ + 6, 4);
  }
  void addArc(TurningPath& path, const Vec2& to) {
    const Vec2 at(path.path.motions.back().to.x(), path.path.motions.back().to.z());
    const Vec2 chord = to - at, center = at + 0.5 * chord + number(0.3, 2) * Vec2(-chord.y(), chord.x());
    const double sweep = 2.0 * std::asin(0.5 * chord.norm() / (at - center).norm());
    path.arc(to.x(), to.y(), center, sweep);
  }

  std::mt19937 random_;
  double radius_ = 0.0, length_ = 0.0;
};

Toolpath split(const Toolpath& path, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Toolpath out = path;
  out.motions.clear();
  for (const Motion& motion : path.motions) {
    const double t = unit(random);
    const bool in_two = unit(random) < 0.6;
    if (!in_two || (motion.to - motion.from).norm() < 1e-3) {
      out.motions.push_back(motion);
      continue;
    }
    Motion first = motion, second = motion;
    first.to = second.from = motion.from + t * (motion.to - motion.from);
    if (motion.arc >= 0) {
      const ArcGeometry whole = path.arcs[static_cast<std::size_t>(motion.arc)];
      const Vec3 arm = motion.from - whole.center;
      const double turned = std::atan2(arm.z(), arm.x()) + t * whole.sweep_rad;
      first.to = second.from = whole.center + arm.norm() * Vec3(std::cos(turned), 0.0, std::sin(turned));
      for (Motion* half : {&first, &second}) {
        ArcGeometry arc = whole;
        arc.sweep_rad = (half == &first ? t : 1.0 - t) * whole.sweep_rad;
        half->arc = static_cast<std::int32_t>(out.arcs.size());
        out.arcs.push_back(arc);
      }
    }
    out.motions.push_back(first);
    out.motions.push_back(second);
  }
  return out;
}

struct Left {
  std::vector<double> volumes;  ///< the largest first
  double initial = 0.0;
};

Left leftOf(const Job& job, const Toolpath& path) {
  Progress progress;
  Result<TurnedStock> stock = TurnedStock::create(job.blank);
  EXPECT_TRUE(stock);
  EXPECT_TRUE(stock->remove(path, job.tools, progress));
  Left left;
  left.initial = stock->initialVolume();
  for (const SectionBody& body : stock->shape().bodies) {
    if (body.volume_mm3 > kVolumeShare * left.initial) left.volumes.push_back(body.volume_mm3);
  }
  std::sort(left.volumes.rbegin(), left.volumes.rend());
  return left;
}

TEST(SplitMotions, OfTurnedPartsChangeNothing) {
  int apart = 0;
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    const Job job = RandomJob(seed).make();
    const Left whole = leftOf(job, job.path), halves = leftOf(job, split(job.path, seed));
    apart += whole.volumes.size() > 1 ? 1 : 0;
    EXPECT_EQ(whole.volumes.size(), halves.volumes.size()) << "seed " << seed;
    for (std::size_t k = 0; k < std::min(whole.volumes.size(), halves.volumes.size()); ++k)
      EXPECT_NEAR(whole.volumes[k], halves.volumes[k], 2 * kVolumeShare * whole.initial) << "seed " << seed;
  }
  EXPECT_GT(apart, 3) << "few jobs leave pieces";
}

}  // namespace
}  // namespace proveout
