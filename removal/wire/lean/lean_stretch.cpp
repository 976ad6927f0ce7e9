#include "removal/wire/lean/lean_stretch.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/assert.h"
#include "core/geometry/plane.h"
#include "removal/wire/section/wire_stretch.h"

namespace proveout {
namespace {

/// Chords of arcs, from the highest point to the chord, mm.
constexpr double kSagitta = 2e-4;
/// The kerf of a piece is that between two ellipses; they differ by no more than a change of lean by this.
constexpr double kLeanStep = 0.01;
/// Rows of triangles for which addLeanStretches() keeps its promise: their points cost less than sections.
constexpr double kTwistRows = 64.0;
/// Most pieces of one motion.
constexpr int kMostPieces = 20000;
/// Shares of a motion at which its bends are looked at.
constexpr int kSamples = 32;

/// The way at the two heights of the span.
class LeanWay {
 public:
  LeanWay(const WireSweep& wire, const HeightSpan& span) : wire_(wire), span_(span) {}

  struct Ends {
    Vec2 low, high;
  };
  Ends at(double t) const {
    const Vec2 lower = pointOf(wire_.lower, t), upper = pointOf(wire_.upper, t);
    const Vec2 lean = (upper - lower) / (wire_.z_high - wire_.z_low);
    return {lower + lean * (span_.low - wire_.z_low), lower + lean * (span_.high - wire_.z_low)};
  }
  bool isStraight() const { return wire_.lower.sweep_rad == 0.0 && wire_.upper.sweep_rad == 0.0; }

  /// How many pieces keep the promises.
  int count(double twist_mm) const {
    std::array<Ends, kSamples + 1> ends;
    for (int k = 0; k <= kSamples; ++k) ends[k] = at(static_cast<double>(k) / kSamples);
    double bend = 0.0, leaning = 0.0, twist = 0.0;
    for (int k = 0; k < kSamples; ++k) {
      const Vec2 low = ends[k + 1].low - ends[k].low, high = ends[k + 1].high - ends[k].high;
      const Vec2 middle = low + high, opening = high - low;
      // Across the way: along it the wire's ellipse may change as it likes.
      const double across = middle.norm() > 0.0 ? std::abs(cross2(middle, opening)) / middle.norm() : 0.0;
      twist += across;
      leaning += (middle.norm() > 0.0 ? across : opening.norm()) / span_.length();
      if (k == 0) continue;
      bend = std::max(bend, (low - (ends[k].low - ends[k - 1].low)).norm());
      bend = std::max(bend, (high - (ends[k].high - ends[k - 1].high)).norm());
    }
    const double second = isStraight() ? 0.0 : bend * kSamples * kSamples;
    const double wanted = std::max({std::sqrt(second / (8.0 * kSagitta)), leaning / kLeanStep,
                                    twist / (4.0 * twist_mm * kTwistRows), 1.0});
    return static_cast<int>(std::ceil(std::min<double>(wanted, kMostPieces)));
  }

  /// As at(), moved outwards so that the chords beside leave the arc by as much on either side.
  Ends between(double t, double step) const {
    const Ends here = at(t);
    if (isStraight()) return here;
    const Ends before = at(t - step), after = at(t + step);
    // The second difference is eight times the height of the arc above its chord.
    constexpr double kShare = 2.0 / 3.0 / 8.0;
    return {here.low - kShare * (before.low + after.low - 2.0 * here.low),
            here.high - kShare * (before.high + after.high - 2.0 * here.high)};
  }

 private:
  static Vec2 pointOf(const WireTrack& track, double t) {
    if (t == 0.0 || t == 1.0) return t == 0.0 ? track.from : track.to;
    return pointOnTrack(track, t);
  }

  const WireSweep& wire_;
  const HeightSpan& span_;
};

}  // namespace

Vec2 LevelStretch::direction() const {
  const Vec2 d = to - from;
  const double length = d.norm();
  return length > 0.0 ? Vec2(d / length) : Vec2::UnitX();
}

double LevelStretch::reach() const {
  return radius_mm * std::sqrt(1.0 + std::max(lean_from.squaredNorm(), lean_to.squaredNorm()));
}

void addLeanStretches(const WireSweep& wire, const HeightSpan& span, double radius_mm, double twist_mm,
                      MotionId motion, std::vector<LeanStretch>& out) {
  const LeanWay way(wire, span);
  const int count = way.count(twist_mm);
  const double step = 1.0 / count;
  LeanWay::Ends from = way.at(0.0);
  for (int k = 1; k <= count; ++k) {
    const LeanWay::Ends to = k == count ? way.at(1.0) : way.between(k * step, step);
    out.push_back({from.low, to.low, from.high, to.high, radius_mm, motion});
    from = to;
  }
}

std::vector<LeanStretch> cutUntil(const std::vector<LeanStretch>& cuts, const CutTime& time) {
  PROVEOUT_ASSERT(time.cuts < cuts.size() || (time.cuts == cuts.size() && time.share <= 0.0));
  std::vector<LeanStretch> done(cuts.begin(), cuts.begin() + time.cuts);
  if (time.share <= 0.0) return done;
  LeanStretch last = cuts[time.cuts];
  last.to_low = last.from_low + time.share * (last.to_low - last.from_low);
  last.to_high = last.from_high + time.share * (last.to_high - last.from_high);
  done.push_back(last);
  return done;
}

std::vector<LevelStretch> atHeight(const std::vector<LeanStretch>& pieces, const HeightSpan& span, double z) {
  const double w = (z - span.low) / span.length();
  std::vector<LevelStretch> out;
  out.reserve(pieces.size());
  for (const LeanStretch& piece : pieces) {
    out.push_back({(1.0 - w) * piece.from_low + w * piece.from_high,
                   (1.0 - w) * piece.to_low + w * piece.to_high,
                   (piece.from_high - piece.from_low) / span.length(),
                   (piece.to_high - piece.to_low) / span.length(), piece.radius_mm, piece.motion});
  }
  return out;
}

Vec2 kerfSupport(const Vec2& normal, const Vec2& lean, double radius_mm) {
  const double along = lean.dot(normal);
  return (normal + lean * along) * (radius_mm / std::sqrt(1.0 + along * along));
}

}  // namespace proveout
