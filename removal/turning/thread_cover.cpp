#include "removal/turning/thread_cover.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace proveout {

namespace {

/// Helices and sides that differ by less are the same: mm, turns.
constexpr double kSame = 1e-6;

bool same(double a, double b) { return std::abs(a - b) <= kSame; }

/// The part of a convex polygon on one side of r = `border`; `above`: where r is larger.
std::vector<Vec2> clipped(const std::vector<Vec2>& polygon, double border, bool above) {
  std::vector<Vec2> out;
  const auto off = [&](const Vec2& p) { return above ? p.x() - border : border - p.x(); };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double da = off(a), db = off(b);
    if (da >= 0.0) out.push_back(a);
    if ((da < 0.0) != (db < 0.0)) out.push_back(a + da / (da - db) * (b - a));
  }
  return out;
}

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  void extend(double v) {
    low = std::min(low, v);
    high = std::max(high, v);
  }
};

/// Radii of the material at the heights that the thread's tool passes.
Range radiiBeside(const ThreadSweep& thread, const std::vector<SectionBody>& bodies) {
  const auto [first, last] = std::minmax(thread.from.y(), thread.to.y());
  const double low = first + thread.outline->min().y(), high = last + thread.outline->max().y();
  Range radii;
  for (const SectionBody& body : bodies) {
    for (const SectionLoop& loop : body.loops) {
      for (std::size_t i = 0; i < loop.points.size(); ++i) {
        const Vec2 &a = loop.points[i], &b = loop.points[(i + 1) % loop.points.size()];
        const auto [bottom, top] = std::minmax(a.y(), b.y());
        if (top < low || bottom > high) continue;
        for (const double z : {std::max(bottom, low), std::min(top, high)}) {
          const double share = top > bottom ? (z - a.y()) / (b.y() - a.y()) : 0.0;
          radii.extend(a.x() + share * (b.x() - a.x()));
        }
        if (top == bottom) radii.extend(b.x());
      }
    }
  }
  return radii;
}

bool sameHelix(const ThreadSweep& a, const ThreadSweep& b) {
  return same(a.from.y(), b.from.y()) && same(a.to.y(), b.to.y()) && same(a.turns, b.turns) &&
         same(a.bend, b.bend) && std::abs(std::remainder(a.start_rad - b.start_rad, 2.0 * kPi)) <= kSame;
}

}  // namespace

bool coversThread(const ThreadSweep& deep, const ThreadSweep& shallow, double low, double high) {
  if (!sameHelix(deep, shallow)) return false;
  // Points of the shallow outline that are in the material somewhere on the way. Both outlines are convex and
  // their distance changes evenly, so that the corners at both ends decide.
  const auto [least, most] = std::minmax(shallow.from.x(), shallow.to.x());
  std::vector<Vec2> polygon;
  shallow.outline->chain(0.0, 2.0 * kPi, kSectionChordMm, polygon);
  polygon = clipped(clipped(polygon, low - most, true), high - least, false);
  for (const Vec2& by : {Vec2(shallow.from - deep.from), Vec2(shallow.to - deep.to)}) {
    for (const Vec2& p : polygon) {
      if (deep.outline->sample(p + by).value > kSame) return false;
    }
  }
  return true;
}

std::vector<ThreadSweep> withoutCovered(const std::vector<ThreadSweep>& threads,
                                        const std::vector<SectionBody>& bodies) {
  std::vector<ThreadSweep> kept;
  for (std::size_t i = 0; i < threads.size(); ++i) {
    const Range material = radiiBeside(threads[i], bodies);
    const auto covers = [&](std::size_t deep, std::size_t shallow) {
      return coversThread(threads[deep], threads[shallow], material.low, material.high);
    };
    bool covered = material.low > material.high;
    for (std::size_t k = 0; k < threads.size() && !covered; ++k) {
      if (k != i && covers(k, i)) covered = k < i || !covers(i, k);
    }
    if (!covered) kept.push_back(threads[i]);
  }
  return kept;
}

}  // namespace proveout
