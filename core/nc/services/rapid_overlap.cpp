#include "core/nc/services/rapid_overlap.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"

namespace proveout::nc {
namespace {

/// Points nearer to a chord lie on it: rounding noise of coordinates.
constexpr double kStraightMm = 1e-9;
constexpr int kMostHalvings = 30;

/// The way with accelerations that come up in their time: its average over that time.
double smoothWay(const AxisRamp& ramp, double time, double rise) {
  if (!(rise > 0.0)) return ramp.wayAt(time);
  if (time >= ramp.duration() + rise) return ramp.way();
  return time <= 0.0 ? 0.0 : (ramp.integralAt(time) - ramp.integralAt(time - rise)) / rise;
}

/// When the axis is down to a share of its highest speed, from its start.
double slowedAt(const AxisRamp& ramp, double share, double rise) {
  if (!(rise > 0.0)) return ramp.duration() - share * ramp.ramp();
  const auto speed = [&](double t) { return std::abs(ramp.wayAt(t) - ramp.wayAt(t - rise)) / rise; };
  // The speed rises and falls evenly about the middle; 60 halvings leave nothing.
  double low = 0.5 * (ramp.duration() + rise), high = ramp.duration() + rise;
  const double wanted = share * speed(low);
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (speed(middle) >= wanted ? low : high) = middle;
  }
  return high;
}

AxisPoint minus(const AxisPoint& a, const AxisPoint& b) {
  AxisPoint d;
  for (int k = 0; k < kMaxAxes; ++k) d[k] = a[k] - b[k];
  return d;
}

double dot(const AxisPoint& a, const AxisPoint& b) {
  double sum = 0.0;
  for (int k = 0; k < kMaxAxes; ++k) sum += a[k] * b[k];
  return sum;
}

/// What of `d` stands across the unit vector `along`.
AxisPoint across(const AxisPoint& d, const AxisPoint& along) {
  const double part = dot(d, along);
  AxisPoint rest = d;
  for (int k = 0; k < kMaxAxes; ++k) rest[k] -= part * along[k];
  return rest;
}

/// A time and where the axes are then.
struct Sample {
  double time;
  AxisPoint at;
};

/// Direction from a to b; all 0 where they agree.
AxisPoint direction(const AxisPoint& a, const AxisPoint& b) {
  AxisPoint d = minus(b, a);
  const double length = std::sqrt(dot(d, d));
  for (int k = 0; k < kMaxAxes; ++k) d[k] = length > 0.0 ? d[k] / length : 0.0;
  return d;
}

/// Writes the way as a row of chords, the straight ones in one.
class Chords {
 public:
  using At = std::function<AxisPoint(double)>;
  using Tell = std::function<void(const AxisPoint&, double)>;
  Chords(const At& at, const Sample& start, const Tell& tell) : at_(at), tell_(tell), start_(start) {}

  /// The way from the last sample on, a polynomial of the third degree at most.
  void divide(const Sample& from, const Sample& to, int depth = 0) {
    if (depth >= kMostHalvings || farthest(from, to) <= kOverlapChordMm) return add(to);
    const double middle = 0.5 * (from.time + to.time);
    const Sample half{middle, at_(middle)};
    divide(from, half, depth + 1);
    divide(half, to, depth + 1);
  }

  void end() {
    if (!run_.empty()) send();
  }

 private:
  /// How far the way leaves its chord at most. Across the chord it is s (1 - s) (a + b s), s from 0 to 1.
  double farthest(const Sample& from, const Sample& to) const {
    const double step = (to.time - from.time) / 3.0;
    const AxisPoint along = direction(from.at, to.at);
    const AxisPoint g1 = across(minus(at_(from.time + step), from.at), along);
    const AxisPoint g2 = across(minus(at_(to.time - step), from.at), along);
    double first = 0.0, last = 0.0;
    for (int k = 0; k < kMaxAxes; ++k) {
      const double a = 9.0 * g1[k] - 4.5 * g2[k], b = 9.0 * g2[k] - 4.5 * g1[k];
      first += a * a;
      last += b * b;
    }
    return 0.25 * std::sqrt(std::max(first, last));
  }

  void add(const Sample& to) {
    if (!run_.empty() && !straight(to)) send();
    run_.push_back(to);
  }

  /// Do all ends of the run lie on the way to that point?
  bool straight(const Sample& to) const {
    const AxisPoint along = direction(start_.at, to.at);
    double reached = 0.0;
    for (const Sample& s : run_) {
      const AxisPoint d = minus(s.at, start_.at);
      const AxisPoint off = across(d, along);
      const double way = dot(d, along);
      if (dot(off, off) > kStraightMm * kStraightMm || way < reached - kStraightMm) return false;
      reached = way;
    }
    return dot(minus(to.at, start_.at), along) >= reached - kStraightMm;
  }

  void send() {
    PROVEOUT_ASSERT(!run_.empty());
    tell_(run_.back().at, run_.back().time - start_.time);
    start_ = run_.back();
    run_.clear();
  }

  const At& at_;
  const Tell& tell_;
  Sample start_;
  std::vector<Sample> run_;
};

/// Times at which an axis of the leg goes over from one polynomial to the next.
void addBreaks(const RapidLeg& leg, const RapidAxes& axes, std::vector<double>& breaks) {
  for (int k = 0; k < axes.count; ++k) {
    const AxisRamp& ramp = leg.axes[static_cast<std::size_t>(k)];
    if (!ramp.moves()) continue;
    for (const double t : {0.0, ramp.ramp(), ramp.duration() - ramp.ramp(), ramp.duration()}) {
      breaks.push_back(leg.start + t);
      if (axes.rise_s > 0.0) breaks.push_back(leg.start + t + axes.rise_s);
    }
  }
}

}  // namespace

AxisRamp::AxisRamp(double way, double speed, double acceleration) : way_(way) {
  const double length = std::abs(way);
  if (!(length > 0.0)) return;
  peak_ = acceleration > 0.0 ? std::min(speed, std::sqrt(acceleration * length)) : speed;
  ramp_ = acceleration > 0.0 ? peak_ / acceleration : 0.0;
  total_ = length / peak_ + ramp_;
}

double AxisRamp::wayAt(double time) const {
  if (time <= 0.0) return 0.0;
  if (time >= total_) return way_;
  const double signed_peak = std::copysign(peak_, way_);
  if (time < ramp_) return 0.5 * signed_peak * time * time / ramp_;
  const double left = total_ - time;
  if (left < ramp_) return way_ - 0.5 * signed_peak * left * left / ramp_;
  return signed_peak * (time - 0.5 * ramp_);
}

double AxisRamp::integralAt(double time) const {
  if (time <= 0.0) return 0.0;
  if (time >= total_) return way_ * (0.5 * total_ + time - total_);  // the way is even about its middle
  const double signed_peak = std::copysign(peak_, way_);
  if (time < ramp_) return signed_peak * time * time * time / (6.0 * ramp_);
  const double left = total_ - time;
  const double whole = 0.5 * way_ * total_ - way_ * left;
  if (left < ramp_) return whole + signed_peak * left * left * left / (6.0 * ramp_);
  const double inner = time - ramp_;
  return signed_peak * (ramp_ * ramp_ / 6.0 + 0.5 * inner * (ramp_ + inner));
}

RapidLeg rapidLeg(const AxisPoint& from, const AxisPoint& to, double start, const RapidAxes& axes) {
  RapidLeg leg;
  leg.from = from;
  leg.to = to;
  leg.start = leg.end = start;
  double slowest = 0.0;
  for (int k = 0; k < axes.count; ++k) {
    slowest = std::max(slowest, std::abs(to[k] - from[k]) / axes.speed[static_cast<std::size_t>(k)]);
  }
  for (int k = 0; k < axes.count; ++k) {
    const double way = to[k] - from[k];
    if (way == 0.0) continue;
    AxisRamp& ramp = leg.axes[static_cast<std::size_t>(k)];
    ramp = AxisRamp(way, std::abs(way) / slowest, axes.acceleration[static_cast<std::size_t>(k)]);
    leg.end = std::max(leg.end, start + ramp.duration() + axes.rise_s);
  }
  return leg;
}

double overlapStart(const RapidLeg& leg, const RapidLeg& next, double share, const RapidAxes& axes) {
  double start = 0.0;
  for (int k = 0; k < axes.count; ++k) {
    const AxisRamp& ramp = leg.axes[static_cast<std::size_t>(k)];
    const AxisRamp& behind = next.axes[static_cast<std::size_t>(k)];
    if (!ramp.moves()) continue;
    start = std::max(start, slowedAt(ramp, share, axes.rise_s));
    if (!behind.moves()) continue;
    if (ramp.way() * behind.way() < 0.0) {
      start = std::max(start, ramp.duration() + axes.rise_s);
    } else {
      start = std::max(start, ramp.duration() - std::min(1.0, behind.peak() / ramp.peak()) * ramp.ramp());
    }
  }
  return leg.start + start;
}

AxisPoint overlapPoint(const RapidLeg* tail, const RapidLeg& leg, double time, const RapidAxes& axes) {
  AxisPoint p = leg.to;
  for (int k = 0; k < axes.count; ++k) {
    const auto i = static_cast<std::size_t>(k);
    if (leg.axes[i].moves() && time < leg.end) {
      p[k] = leg.from[k] + smoothWay(leg.axes[i], time - leg.start, axes.rise_s);
    }
    if (tail != nullptr && tail->axes[i].moves() && time < tail->end) {
      p[k] += smoothWay(tail->axes[i], time - tail->start, axes.rise_s) - tail->axes[i].way();
    }
  }
  return p;
}

void overlapChords(const RapidLeg* tail, const RapidLeg& leg, double from, double to, const RapidAxes& axes,
                   const std::function<void(const AxisPoint&, double)>& tell) {
  if (!(to > from)) return;
  std::vector<double> breaks{from, to};
  addBreaks(leg, axes, breaks);
  if (tail != nullptr) addBreaks(*tail, axes, breaks);
  std::sort(breaks.begin(), breaks.end());
  const Chords::At at = [&](double time) { return overlapPoint(tail, leg, time, axes); };
  Sample last{from, at(from)};
  Chords chords(at, last, tell);
  for (const double time : breaks) {
    if (!(time > last.time) || time > to) continue;
    const Sample next{time, at(time)};
    chords.divide(last, next);
    last = next;
  }
  chords.end();
}

}  // namespace proveout::nc
