// Where on its way a solid touches a point of the surface that it leaves: the least value of the distance is
// known to be 0, so that a place with this value needs no proof that there is no better one.
#include <algorithm>
#include <cmath>

#include "removal/sweep/sweep.h"

namespace proveout {

namespace {

/// Rounds of a search; what needs more is a rim or far off.
constexpr int kMostRounds = 12;
/// It stops where the next step gains less, mm.
constexpr double kGainMm = 1e-10;
/// And at once where the solid is as near as this, mm: as near as other searches come.
constexpr double kThereMm = 0.1 * kSweepToleranceMm;
/// A point this near to the solid is touched by it, mm: points of chords are off the curve by half of it.
constexpr double kTouchedMm = 1e-4;

}  // namespace

double Sweep::parameterAt(const Vec3& at) const {
  const Vec3 from = at - arc_.center;
  const double angle = std::abs(arc_.sweep_rad), turn = 2.0 * kPi;
  double around = std::atan2(from.dot(frame_.v), from.dot(frame_.u));
  if (arc_.sweep_rad < 0.0) around = -around;
  if (around < 0.0) around += turn;
  if (frame_.rise != 0.0 && angle > turn) {
    const double along = from.dot(frame_.n) / frame_.rise * angle;
    around += turn * std::max(0.0, std::round((along - around) / turn));
  }
  if (around > angle && around - angle > turn - around) around -= turn;  // nearer to the start
  return std::clamp(around / angle, 0.0, 1.0);
}

/// Newton's method from place.t, within what the slopes on both sides tell; between them, and at rims, on to
/// where the tangents meet. False if it finds no place that touches the point.
bool Sweep::touch(const Vec3& p, Place& place) const {
  Place low{0.0, {}}, high{1.0, {}};
  bool low_known = false, high_known = false;
  double t = place.t;
  for (int round = 0; round < kMostRounds; ++round) {
    place = {t, evaluateCurve(p, t)};
    const double slope = place.at.slope;
    const bool at_end = slope == 0.0 || (t == 0.0 && slope > 0.0) || (t == 1.0 && slope < 0.0);
    if (std::abs(place.at.value) < kThereMm) return true;
    if (at_end) return std::abs(place.at.value) < kTouchedMm;
    (slope < 0.0 ? low : high) = place;
    (slope < 0.0 ? low_known : high_known) = true;
    // Where the solid comes over the point with its rim, a little more than the way that is left at this
    // rate.
    double next = t - (place.at.bend > 0.0 ? slope / place.at.bend : kOvershoot * place.at.value / slope);
    next = std::clamp(next, low_known ? low.t : 0.0, high_known ? high.t : 1.0);
    if (low_known && high_known && (next == low.t || next == high.t)) {
      const double meet = low.at.value - high.at.value + high.at.slope * (high.t - low.t);
      next = low.t + meet / (high.at.slope - low.at.slope);
      if (!(next > low.t && next < high.t)) next = 0.5 * (low.t + high.t);
    }
    if (std::abs(slope * (next - t)) < kGainMm) return std::abs(place.at.value) < kTouchedMm;
    if (place.at.bend <= 0.0 && place.at.value < 0.0 && !(low_known && high_known)) return false;
    t = next;
  }
  return false;
}

SweepSample Sweep::sampleOnSurface(const Vec3& p, double start) const {
  if (kind_ != Kind::kCurve) return sample(p);
  Place place{start, {}};
  return touch(p, place) ? withRim(p, place) : sample(p);
}

}  // namespace proveout
