// Rapids that overlap against closed forms and against a slow integration of every axis.
#include "core/nc/services/rapid_overlap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace proveout::nc {
namespace {

RapidAxes machine(double speed, double acceleration, double rise = 0.0) {
  RapidAxes axes;
  axes.speed.fill(speed);
  axes.acceleration.fill(acceleration);
  axes.rise_s = rise;
  return axes;
}

/// Rapids one behind the other.
struct Chain {
  RapidAxes axes;
  double share;
  std::vector<RapidLeg> legs;

  Chain(const RapidAxes& limits, double part, const std::vector<AxisPoint>& points)
      : axes(limits), share(part) {
    for (std::size_t k = 1; k < points.size(); ++k) {
      RapidLeg leg = rapidLeg(points[k - 1], points[k], 0.0, axes);
      if (!legs.empty()) {
        double start = overlapStart(legs.back(), leg, share, axes);
        if (legs.size() > 1) start = std::max(start, legs[legs.size() - 2].end);
        leg.start += start;
        leg.end += start;
      }
      legs.push_back(leg);
    }
  }
  double end() const { return std::max(legs.back().end, legs.size() > 1 ? legs[legs.size() - 2].end : 0.0); }
};

TEST(RapidOverlap, TheManualsExample) {
  // G0 Z10, X30, Z1 at 1 m/s^2, from 50 %: sqrt(4 d / a) each, less half a ramp sqrt(d / a) at each corner.
  const Chain run(machine(250, 1000), 0.5, {{0, 0, 0}, {0, 0, 10}, {30, 0, 10}, {30, 0, 1}});
  const double z10 = std::sqrt(0.01), x30 = std::sqrt(0.03), z9 = std::sqrt(0.009);
  EXPECT_NEAR(run.end(), 2 * (z10 + x30 + z9) - 0.5 * (z10 + x30), 1e-12);
  EXPECT_NEAR(run.end(), 0.600, 0.0006);
  // At the first corner X starts when Z is a quarter of its braking way from the end: two parabolas.
  const double start = run.legs[1].start;
  const AxisPoint corner = overlapPoint(&run.legs[0], run.legs[1], start + 0.02, run.axes);
  EXPECT_NEAR(corner[0], 0.5 * 1000 * 0.02 * 0.02, 1e-9);
  EXPECT_NEAR(corner[2], 10 - 0.5 * 1000 * 0.03 * 0.03, 1e-9);
}

TEST(RapidOverlap, AxesOfOneRapidArriveAtTheirOwnTimes) {
  const Chain run(machine(250, 1000), 0.0, {{0, 0, 0}, {250, 0, 50}});
  EXPECT_NEAR(run.legs[0].axes[0].duration(), 1.0 + 0.25, 1e-12);
  EXPECT_NEAR(run.legs[0].axes[2].duration(), 1.0 + 0.05, 1e-12);
  EXPECT_NEAR(run.end(), 1.25, 1e-12);
}

TEST(RapidOverlap, AnAxisThatTurnsRoundStandsBefore) {
  const Chain run(machine(250, 1000), 1.0, {{0, 0, 0}, {0, 0, 10}, {0, 0, 1}});
  EXPECT_NEAR(run.end(), 0.2 + 2 * std::sqrt(0.009), 1e-12);
}

TEST(RapidOverlap, AnAxisGoesOnWithTheSpeedThatItHas) {
  // Twice 0.45 s; they overlap for the half of a ramp of 50 ms.
  const Chain run(machine(250, 5000), 0.5, {{0, 0, 0}, {100, 0, 0}, {200, 0, 0}});
  EXPECT_NEAR(run.end(), 0.9 - 0.025, 1e-12);
  // A short way behind takes up no more than its own speed: sqrt(5000 * 0.05) = 15.8 mm/s.
  const Chain creeps(machine(250, 5000), 0.5, {{0, 0, 0}, {100, 0, 0}, {100.05, 0, 0}});
  EXPECT_NEAR(creeps.legs[1].start, 0.45 - std::sqrt(0.05 / 5000), 1e-12);
}

/// Every axis integrated in small steps.
class Slow {
 public:
  explicit Slow(const Chain& run) : run_(run) {
    const auto steps = static_cast<std::size_t>(run.end() / kStep) + 2;
    ways_.resize(run.legs.size());
    for (std::size_t leg = 0; leg < run.legs.size(); ++leg) {
      for (int axis = 0; axis < 3; ++axis) ways_[leg].push_back(integrate(run.legs[leg], axis, steps));
    }
  }
  static constexpr double kStep = 2e-5;

  AxisPoint at(std::size_t step) const {
    AxisPoint p = run_.legs.front().from;
    for (std::size_t leg = 0; leg < ways_.size(); ++leg) {
      for (int axis = 0; axis < 3; ++axis) p[axis] += ways_[leg][static_cast<std::size_t>(axis)][step];
    }
    return p;
  }
  std::size_t steps() const { return ways_[0][0].size(); }

 private:
  /// The speed as it is driven: up to the axis' share of the rapid, and down in time; then its mean over the
  /// rise of the acceleration.
  std::vector<double> integrate(const RapidLeg& leg, int axis, std::size_t steps) const {
    double slowest = 0.0;
    for (int k = 0; k < 3; ++k) {
      slowest = std::max(slowest, std::abs(leg.to[k] - leg.from[k]) / run_.axes.speed[0]);
    }
    const double way = leg.to[axis] - leg.from[axis], top = std::abs(way) / slowest;
    const double a = run_.axes.acceleration[0];
    std::vector<double> plain(steps, 0.0);
    double speed = 0.0, done = 0.0;
    for (std::size_t k = 0; k < steps; ++k) {
      plain[k] = std::copysign(std::min(done, std::abs(way)), way);
      if (static_cast<double>(k) * kStep < leg.start || done >= std::abs(way)) continue;
      const bool brake = speed * speed / (2 * a) >= std::abs(way) - done;
      speed = brake ? std::max(speed - a * kStep, 1e-3) : std::min(speed + a * kStep, top);
      done += speed * kStep;
    }
    const auto window = static_cast<std::size_t>(run_.axes.rise_s / kStep + 0.5);
    if (window < 2) return plain;
    std::vector<double> mean(steps, 0.0);
    double sum = 0.0;
    for (std::size_t k = 0; k < steps; ++k) {
      sum += plain[k] - (k >= window ? plain[k - window] : 0.0);
      mean[k] = sum / static_cast<double>(window);
    }
    return mean;
  }
  const Chain& run_;
  std::vector<std::vector<std::vector<double>>> ways_;  ///< by leg and axis
};

struct Chord {
  AxisPoint from, to;
  double start, end;
};

std::vector<Chord> chordsOf(const Chain& run) {
  std::vector<Chord> chords;
  AxisPoint last = run.legs.front().from;
  double clock = 0.0;
  for (std::size_t k = 0; k < run.legs.size(); ++k) {
    const double to = k + 1 < run.legs.size() ? run.legs[k + 1].start : run.end();
    overlapChords(k > 0 ? &run.legs[k - 1] : nullptr, run.legs[k], run.legs[k].start, to, run.axes,
                  [&](const AxisPoint& end, double duration) {
                    chords.push_back({last, end, clock, clock + duration});
                    last = end;
                    clock += duration;
                  });
  }
  return chords;
}

double distanceTo(const Chord& chord, const AxisPoint& p) {
  const Vec3 d = chord.to.xyz - chord.from.xyz;
  const double t = std::clamp(d.dot(p.xyz - chord.from.xyz) / d.squaredNorm(), 0.0, 1.0);
  return (chord.from.xyz + t * d - p.xyz).norm();
}

TEST(RapidOverlap, TheChordsKeepToTheWayInPlaceAndTime) {
  std::mt19937 random(41);
  std::uniform_real_distribution<double> place(-60, 60), part(0, 1);
  for (int round = 0; round < 12; ++round) {
    std::vector<AxisPoint> points{{0, 0, 0}};
    for (int k = 0; k < 4; ++k) {
      AxisPoint p = points.back();
      for (int axis = 0; axis < 3; ++axis) {
        if (part(random) < 0.6) p[axis] = place(random);
      }
      if (!(p == points.back())) points.push_back(p);
    }
    const Chain run(machine(250, 1500 + 3000 * part(random), round % 2 == 0 ? 0.0 : 0.02), part(random),
                    points);
    const std::vector<Chord> chords = chordsOf(run);
    const Slow slow(run);
    EXPECT_NEAR(chords.back().end, run.end(), 1e-9);
    EXPECT_LT((chords.back().to.xyz - points.back().xyz).norm(), 1e-9);
    double worst = 0.0;
    std::size_t k = 0;
    for (std::size_t step = 0; step < slow.steps(); step += 10) {
      const double time = static_cast<double>(step) * Slow::kStep;
      while (k + 1 < chords.size() && chords[k].end < time) ++k;
      // The chord of this moment; the integration is late by steps, so that a neighbour may be nearer.
      double nearest = distanceTo(chords[k], slow.at(step));
      if (k > 0) nearest = std::min(nearest, distanceTo(chords[k - 1], slow.at(step)));
      if (k + 1 < chords.size()) nearest = std::min(nearest, distanceTo(chords[k + 1], slow.at(step)));
      worst = std::max(worst, nearest);
    }
    // 250 mm/s and steps of 20 microseconds: what the slow one leaves open is 0.01 mm.
    EXPECT_LT(worst, kOverlapChordMm + 0.012) << round;
  }
}

TEST(RapidOverlap, NoAxisExceedsItsLimits) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-40, 40), part(0, 1);
  for (int round = 0; round < 200; ++round) {
    std::vector<AxisPoint> points{{0, 0, 0}};
    for (int k = 0; k < 6; ++k) {
      AxisPoint p = points.back();
      for (int axis = 0; axis < 3; ++axis) {
        if (part(random) < 0.6) p[axis] += (part(random) < 0.3 ? 0.01 : 1.0) * place(random);
      }
      if (!(p == points.back())) points.push_back(p);
    }
    const Chain run(machine(250, 2000), part(random), points);
    const double h = 1e-5;
    for (std::size_t k = 0; k < run.legs.size(); ++k) {
      const RapidLeg* tail = k > 0 ? &run.legs[k - 1] : nullptr;
      const double to = k + 1 < run.legs.size() ? run.legs[k + 1].start : run.end();
      for (double t = run.legs[k].start + h; t < to - h; t += 13e-5) {
        const auto at = [&](double time) { return overlapPoint(tail, run.legs[k], time, run.axes).xyz; };
        const Vec3 speed = (at(t + h) - at(t - h)) / (2 * h);
        const Vec3 acceleration = (at(t + h) - 2 * at(t) + at(t - h)) / (h * h);
        ASSERT_LT(speed.cwiseAbs().maxCoeff(), 250 * (1 + 1e-6)) << round;
        ASSERT_LT(acceleration.cwiseAbs().maxCoeff(), 2000 * (1 + 1e-3)) << round;
      }
    }
  }
}

}  // namespace
}  // namespace proveout::nc
