// The nearest place of a solid on a helix, spiral or tilted arc: branch and bound over the path parameter.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "removal/sweep.h"

namespace proveout {

namespace {

/// Spans up to this angle are bounded by the convexity of the distance, larger ones by their boxes.
const double kSpan = degToRad(30.0);
/// Spans looked at before the search gives its best value.
constexpr int kMostSpans = 20000;
/// Away from the surface the search may stop this much (relative) above the least value.
constexpr double kFarTolerance = 1e-4;
/// Rounding of bounds that the value may meet exactly, mm.
constexpr double kBoundSlackMm = 1e-10;

}  // namespace

/// Of the control point between two parameters.
Box3 Sweep::wayBounds(double a, double b) const {
  Box3 box;
  if (std::abs(arc_.sweep_rad) * (b - a) < kPi) {
    box.extend(position(a));
    box.extend(position(b));
    return box.inflated(curvature_bound_ * (b - a) * (b - a) / 8.0);
  }
  const double dr = frame_.radius_end - frame_.radius_start;
  const double radius = std::max(frame_.radius_start + a * dr, frame_.radius_start + b * dr);
  const Vec3 ring = radius * (frame_.u.cwiseAbs2() + frame_.v.cwiseAbs2()).cwiseSqrt();
  for (const double t : {a, b}) {
    const Vec3 middle = arc_.center + frame_.n * (t * frame_.rise);
    box.extend(middle - ring);
    box.extend(middle + ring);
  }
  return box;
}

/// No part of the solid on this part of the way is nearer than that; minus infinity for points in its box.
double Sweep::boxBound(const Vec3& p, double a, double b) const {
  const Box3 way = wayBounds(a, b);
  const double radius = profile_->maxRadius();
  const Vec3 low = way.min + Vec3(-radius, -radius, profile_->zMin()),
             high = way.max + Vec3(radius, radius, profile_->zMax());
  const Vec3 beyond = (low - p).cwiseMax(p - high);
  if (beyond.maxCoeff() <= 0.0) return -std::numeric_limits<double>::infinity();
  return beyond.cwiseMax(0.0).norm() - kBoundSlackMm;
}

/// The same for the whole way about a vertical axis: the flank of the solid, were it endless. On the walls
/// that many turns make alike it is the value itself.
double Sweep::flankBound(const Vec3& p) const {
  if (!vertical_) return -std::numeric_limits<double>::infinity();
  const double d = (p - arc_.center).head<2>().norm();
  const auto [least, most] = std::minmax(frame_.radius_start, frame_.radius_end);
  return std::max({d - most, least - d, 0.0}) - profile_->maxRadius() - kBoundSlackMm;
}

/// Where a way about a vertical axis passes the point: on its lowest turn, and on the highest whose tip is
/// not above the point.
std::array<double, 2> Sweep::turnsNear(const Vec3& p) const {
  const Vec3 from = p - arc_.center;
  double angle = std::atan2(from.dot(frame_.v), from.dot(frame_.u));
  if (arc_.sweep_rad < 0.0) angle = -angle;
  if (angle < 0.0) angle += 2.0 * kPi;
  const double span = std::abs(arc_.sweep_rad), last = std::floor((span - angle) / (2.0 * kPi));
  if (last < 0.0) return {0.0, 1.0};
  const double rise = frame_.n.z() * frame_.rise, first_tip = from_.z() + rise * angle / span,
               pitch = rise * 2.0 * kPi / span;
  const double turn = pitch != 0.0 ? (p.z() - first_tip) / pitch : 0.0;
  const double near = std::clamp(pitch < 0.0 ? std::ceil(turn) : std::floor(turn), 0.0, last);
  const double lowest = pitch < 0.0 ? last : 0.0;
  return {(angle + 2.0 * kPi * lowest) / span, (angle + 2.0 * kPi * near) / span};
}

Sweep::Place Sweep::minimiseCurve(const Vec3& p, double cutoff, double& bound) const {
  struct End {
    double value = 0.0;
    Vec3 gradient = Vec3::Zero(), at = Vec3::Zero();
  };
  const auto end = [&](double t) {
    const At e = evaluate(p, t);
    return End{e.value, e.gradient, position(t)};
  };
  // Lower bound on a span: convexity along the chord less the arc's distance from the chord.
  const auto chordBound = [&](double a, const End& ea, double b, const End& eb) {
    const Vec3 chord = eb.at - ea.at;
    const double sa = -ea.gradient.dot(chord), sb = -eb.gradient.dot(chord);
    double low;
    if (sa >= 0.0) {
      low = ea.value;
    } else if (sb <= 0.0) {
      low = eb.value;
    } else {
      low = ea.value + sa * (eb.value - sb - ea.value) / (sa - sb);  // where the two support lines meet
    }
    return low - curvature_bound_ * (b - a) * (b - a) / 8.0;
  };
  struct Piece {
    double a, b, low;
    bool known;  ///< its ends
    End ea, eb;
  };
  std::array<Piece, 128> stack;
  int size = 0;
  double best = std::numeric_limits<double>::infinity(), best_t = 0.0;
  bound = best;
  const auto consider = [&](double t, const End& e) {
    if (e.value < best) {
      best = e.value;
      best_t = t;
    }
  };
  // The better one of two is looked at first; of those alike the one that the tool is lower on.
  const bool falls = frame_.n.z() * frame_.rise < 0.0;
  const auto push = [&](const Piece& first, const Piece& second) {
    const bool first_better = first.low != second.low ? first.low < second.low : !falls;
    stack[size++] = first_better ? second : first;
    stack[size++] = first_better ? first : second;
  };
  const double flank = flankBound(p), sweep = std::abs(arc_.sweep_rad);
  for (const double t : {0.0, 1.0}) consider(t, end(t));
  if (vertical_ && sweep > 2.0 * kPi) {
    for (const double t : turnsNear(p)) consider(t, end(t));
  }
  stack[size++] = {0.0, 1.0, std::max(flank, boxBound(p, 0.0, 1.0)), false, {}, {}};
  for (int count = 0; size > 0; ++count) {
    Piece piece = stack[--size];
    const double goal = std::min(best - 0.5 * kSweepToleranceMm - kFarTolerance * std::abs(best), cutoff);
    if (piece.low >= goal || count >= kMostSpans || size + 2 > static_cast<int>(stack.size())) {
      bound = std::min(bound, piece.low);
      continue;
    }
    const double middle = 0.5 * (piece.a + piece.b);
    if (sweep * (piece.b - piece.a) > kSpan) {
      push({piece.a, middle, std::max(piece.low, boxBound(p, piece.a, middle)), false, {}, {}},
           {middle, piece.b, std::max(piece.low, boxBound(p, middle, piece.b)), false, {}, {}});
      continue;
    }
    if (!piece.known) {
      piece.ea = end(piece.a);
      piece.eb = end(piece.b);
      consider(piece.a, piece.ea);
      consider(piece.b, piece.eb);
      piece.known = true;
      piece.low = std::max(piece.low, chordBound(piece.a, piece.ea, piece.b, piece.eb));
      stack[size++] = piece;
      continue;
    }
    const End em = end(middle);
    consider(middle, em);
    push({piece.a, middle, std::max(flank, chordBound(piece.a, piece.ea, middle, em)), true, piece.ea, em},
         {middle, piece.b, std::max(flank, chordBound(middle, em, piece.b, piece.eb)), true, em, piece.eb});
  }
  bound = std::min(bound, best);
  return {best_t, evaluateCurve(p, best_t)};
}

}  // namespace proveout
