// A motion of a wire that is cut in two is the same motion: pieces fall where they come free, not at ends of
// blocks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "removal/wire/wire_stock.h"
#include "tests/unit/wire/wire_fixture.h"

namespace proveout {
namespace {

constexpr double kHeight = 10.0, kHalf = 15.0;

WireTrack partOf(const WireTrack& track, double from, double to) {
  WireTrack part = track;
  part.from = from > 0.0 ? pointOnTrack(track, from) : track.from;
  part.to = to < 1.0 ? pointOnTrack(track, to) : track.to;
  part.sweep_rad = (to - from) * track.sweep_rad;
  return part;
}

/// A random way through a plate: straight lines and arcs that cross each other.
class RandomWay {
 public:
  RandomWay(std::uint32_t seed, bool leans) : random_(seed), leans_(leans) {}

  std::vector<WireSweep> make() {
    at_ = Vec2(number(-20, 20), number(16, 20));
    const int motions = whole(3, leans_ ? 7 : 12);
    for (int k = 0; k < motions; ++k) add();
    return std::move(sweeps_);
  }

 private:
  double number(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
  int whole(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }

  void add() {
    WireSweep sweep;
    sweep.z_high = kHeight;
    sweep.lower.from = at_;
    sweep.upper.from = at_ + lean_;
    const Vec2 to(number(-19, 19), number(-19, 19));
    const Vec2 chord = to - at_;
    sweep.lower.to = to;
    if (number(0, 1) < 0.3) {
      sweep.lower.center = at_ + 0.5 * chord + number(0.3, 2) * Vec2(-chord.y(), chord.x());
      const double radius = (at_ - sweep.lower.center).norm();
      sweep.lower.sweep_rad = 2.0 * std::asin(0.5 * chord.norm() / radius);
      sweep.upper = sweep.lower;
      for (Vec2* p : {&sweep.upper.from, &sweep.upper.to, &sweep.upper.center}) *p += lean_;
    } else {
      if (leans_) lean_ = Vec2(number(-1, 1), number(-1, 1));
      sweep.upper.to = to + lean_;
    }
    at_ = to;
    sweeps_.push_back(sweep);
  }

  std::mt19937 random_;
  bool leans_;
  Vec2 at_ = Vec2::Zero(), lean_ = Vec2::Zero();
  std::vector<WireSweep> sweeps_;
};

std::vector<WireSweep> split(const std::vector<WireSweep>& sweeps, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<WireSweep> out;
  for (const WireSweep& sweep : sweeps) {
    const double t = unit(random);
    WireSweep first = sweep, second = sweep;
    first.lower = partOf(sweep.lower, 0.0, t);
    first.upper = partOf(sweep.upper, 0.0, t);
    second.lower = partOf(sweep.lower, t, 1.0);
    second.upper = partOf(sweep.upper, t, 1.0);
    out.push_back(first);
    out.push_back(second);
  }
  return out;
}

std::vector<double> volumesOf(const std::vector<WireSweep>& sweeps) {
  Tool wire;
  wire.number = 1;
  wire.type = ToolType::kWire;
  wire.diameter = 0.3;
  wire.spark_gap = 0.02;
  Toolpath path;
  ToolpathBuilder builder{path};
  builder.file(0, "wire.nc");
  for (const WireSweep& sweep : sweeps) {
    Motion motion;
    motion.kind = MotionKind::kFeed;
    motion.from = Vec3(sweep.lower.from.x(), sweep.lower.from.y(), 0.0);
    motion.to = Vec3(sweep.lower.to.x(), sweep.lower.to.y(), 0.0);
    builder.wireMotion(motion, sweep);
  }
  WireStock stock(*prismOf(BoxShape{{-kHalf, -kHalf, 0}, {kHalf, kHalf, kHeight}}));
  Progress progress;
  EXPECT_TRUE(stock.cut(path, {wire}, 0.01, progress).ok());
  std::vector<double> volumes;
  for (const WireBody& body : stock.bodies()) volumes.push_back(body.volume_mm3);
  return volumes;
}

/// `share`: of the plate, to which volumes agree; smaller pieces do not count.
void expectSame(std::uint32_t from, std::uint32_t to, bool leans, double share) {
  const double plate = 4.0 * kHalf * kHalf * kHeight;
  int pieces = 0;
  for (std::uint32_t seed = from; seed < to; ++seed) {
    const std::vector<WireSweep> way = RandomWay(seed, leans).make();
    std::vector<double> whole = volumesOf(way), halves = volumesOf(split(way, seed));
    for (std::vector<double>* volumes : {&whole, &halves})
      std::erase_if(*volumes, [&](double v) { return v < share * plate; });
    EXPECT_EQ(whole.size(), halves.size()) << "seed " << seed;
    for (std::size_t k = 0; k < std::min(whole.size(), halves.size()); ++k)
      EXPECT_NEAR(whole[k], halves[k], share * plate) << "seed " << seed;
    pieces += static_cast<int>(whole.size()) - 1;
  }
  EXPECT_GT(pieces, static_cast<int>(to - from) / 2) << "few ways cut pieces free";
}

TEST(SplitCuts, OfAnUprightWireChangeNothing) { expectSame(0, 40, false, 1e-6); }
TEST(SplitCuts, OfALeaningWireChangeNothing) { expectSame(0, 6, true, 1e-5); }

}  // namespace
}  // namespace proveout
