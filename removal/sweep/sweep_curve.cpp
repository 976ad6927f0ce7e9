// The nearest place of a solid on a spiral or tilted arc, and on what is left of helices: branch and bound
// over the path parameter.
#include <array>
#include <utility>

#include "removal/sweep/curve_search.h"

namespace proveout {

namespace {

/// Spans up to this angle are bounded by the convexity of the distance, larger ones by their boxes.
const double kSpan = degToRad(30.0);
/// Spans looked at before the search gives its best value.
constexpr int kMostSpans = 20000;
/// Spans that wait; each is half of the one before.
constexpr int kMostHalves = 64;

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
  return beyond.cwiseMax(0.0).norm() - CurveSearch::kBoundSlackMm;
}

Sweep::CurveSearch::End Sweep::CurveSearch::end(double t) {
  const At e = consider(t);
  return {e.value, e.gradient, sweep.position(t)};
}

/// Lower bound on a span: convexity along the chord less the arc's distance from the chord.
double Sweep::CurveSearch::chordBound(double a, const End& ea, double b, const End& eb) const {
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
  return low - sweep.curvature_bound_ * (b - a) * (b - a) / 8.0;
}

/// Values from a to b are at least `low`: that settles them, or they are left to be divided.
void Sweep::CurveSearch::leave(double a, double b, double low) {
  if (low >= goal() || b <= a || size == kMostPieces) {
    bound = std::min(bound, low);
  } else {
    add({a, b, low, false, {}, {}});
  }
}

/// The better one of two is looked at first; of those alike the one that the tool is lower on.
void Sweep::CurveSearch::push(const Piece& first, const Piece& second) {
  const bool falls = sweep.frame_.n.z() * sweep.frame_.rise < 0.0;
  const bool first_better = first.low != second.low ? first.low < second.low : !falls;
  add(first_better ? second : first);
  add(first_better ? first : second);
}

/// Spans that are not settled by their boxes, by Newton's method; what it does not settle is left.
void Sweep::CurveSearch::spans() {
  struct Span {
    double a, b, low;
  };
  std::array<Span, kMostHalves> open;
  int count = 0;
  open[count++] = {0.0, 1.0, sweep.boxBound(p, 0.0, 1.0)};
  while (count > 0) {
    const Span span = open[static_cast<std::size_t>(--count)];
    if (span.low >= goal()) {
      bound = std::min(bound, span.low);
      continue;
    }
    const double middle = 0.5 * (span.a + span.b);
    if (angle * (span.b - span.a) <= kSpan || count + 2 > kMostHalves) {
      const bool in = place.t > span.a && place.t < span.b;
      newton(span.a, span.b, in ? place.t : middle, sweep.curvature_bound_);
      continue;
    }
    Span first{span.a, middle, std::max(span.low, sweep.boxBound(p, span.a, middle))};
    Span second{middle, span.b, std::max(span.low, sweep.boxBound(p, middle, span.b))};
    if (first.low < second.low) std::swap(first, second);
    open[static_cast<std::size_t>(count++)] = first;  // the better one is looked at first
    open[static_cast<std::size_t>(count++)] = second;
  }
}

void Sweep::CurveSearch::divide() {
  for (int count = 0; size > 0; ++count) {
    Piece piece = stack.pieces[static_cast<std::size_t>(--size)];
    if (piece.low >= goal() || count >= kMostSpans || size + 2 > kMostPieces) {
      bound = std::min(bound, piece.low);
      continue;
    }
    const double middle = 0.5 * (piece.a + piece.b);
    if (angle * (piece.b - piece.a) > kSpan) {
      push({piece.a, middle, std::max(piece.low, sweep.boxBound(p, piece.a, middle)), false, {}, {}},
           {middle, piece.b, std::max(piece.low, sweep.boxBound(p, middle, piece.b)), false, {}, {}});
      continue;
    }
    if (!piece.known) {
      piece.ea = end(piece.a);
      piece.eb = end(piece.b);
      piece.known = true;
      piece.low = std::max(piece.low, chordBound(piece.a, piece.ea, piece.b, piece.eb));
      add(piece);
      continue;
    }
    const End em = end(middle);
    push({piece.a, middle, chordBound(piece.a, piece.ea, middle, em), true, piece.ea, em},
         {middle, piece.b, chordBound(middle, em, piece.b, piece.eb), true, em, piece.eb});
  }
}

Sweep::Place Sweep::minimiseCurve(const Vec3& p, double cutoff, double tolerance, double& bound,
                                  double start) const {
  CurveSearch search(*this, p, cutoff, std::max(tolerance, 0.5 * kSweepToleranceMm));
  if (round_turns_) {
    search.turns(start);
  } else {
    for (const double t : {start >= 0.0 ? start : parameterAt(p), 0.0, 1.0}) search.consider(t);
    search.spans();
    search.divide();
  }
  bound = std::min(search.bound, search.best);
  return search.place;
}

}  // namespace proveout
