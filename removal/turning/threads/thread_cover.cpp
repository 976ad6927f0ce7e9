#include "removal/turning/threads/thread_cover.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "removal/turning/threads/thread_group.h"

namespace proveout {

namespace {

/// Helices and sides that differ by less are the same: mm, turns.
constexpr double kSame = 1e-6;
/// Turns that parts of a pass reach into the groove which holds the rest.
constexpr double kOverlap = 0.05;
/// A pass is shortened where that makes it at least so much shorter.
constexpr double kWorthCutting = 0.8;

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

/// Corners of the shallow outline as far as they are in the material somewhere on the way.
std::vector<Vec2> cornersInside(const ThreadSweep& thread, double low, double high) {
  const auto [least, most] = std::minmax(thread.from.x(), thread.to.x());
  std::vector<Vec2> polygon;
  thread.outline->chain(0.0, 2.0 * kPi, kSectionChordMm, polygon);
  return clipped(clipped(polygon, low - most, true), high - least, false);
}

/// Whether the corners, seen from the control point of the shallow tool, lie in the deep outline that stands
/// `by` from it.
bool holds(const ConvexOutline& deep, const std::vector<Vec2>& corners, const Vec2& by) {
  return std::all_of(corners.begin(), corners.end(),
                     [&](const Vec2& p) { return deep.sample(p + by).value <= kSame; });
}

/// A part of the turns of a thread, 0..1.
struct Turns {
  double first, last;
};

/// The turns of a thread whose outline reaches between these heights.
Turns turnsBetween(const ThreadSweep& thread, const Range& heights) {
  const double way = thread.to.y() - thread.from.y();
  if (std::abs(way) < kSame) return {0.0, 1.0};
  double a = (heights.low - thread.outline->max().y() - thread.from.y()) / way,
         b = (heights.high - thread.outline->min().y() - thread.from.y()) / way;
  if (a > b) std::swap(a, b);
  return {std::max(0.0, a), std::min(1.0, b)};
}

/// Passes of one even lead that start elsewhere, as with infeed along a flank: the turns of `shallow` for
/// which the deep tool passes the same angle with the shallow outline in its own. Nothing where there are
/// none.
std::optional<Turns> heldTurns(const ThreadSweep& deep, const ThreadSweep& shallow,
                               const std::vector<Vec2>& corners) {
  const bool even = same(deep.bend, 0.0) && same(shallow.bend, 0.0) && deep.turns * shallow.turns > 0.0;
  if (!even) return std::nullopt;
  const Vec2 lead = (shallow.to - shallow.from) / shallow.turns, other = (deep.to - deep.from) / deep.turns;
  if ((lead - other).norm() * std::abs(shallow.turns) > kSame || std::abs(lead.y()) < kSame)
    return std::nullopt;
  // Turns from the start of the deep tool to that of the shallow one, by the angle and by the height.
  const double angle = (shallow.start_rad - deep.start_rad) / (2.0 * kPi),
               height = (shallow.from.y() - deep.from.y()) / lead.y();
  const double between = angle + std::round(height - angle);
  const Vec2 by = shallow.from - (deep.from + between * lead);
  if (!holds(*deep.outline, corners, by)) return std::nullopt;
  double a = -between / shallow.turns, b = (deep.turns - between) / shallow.turns;
  if (a > b) std::swap(a, b);
  const Turns held{std::max(0.0, a), std::min(1.0, b)};
  return held.first < held.last ? std::optional(held) : std::nullopt;
}

ThreadSweep partOf(const ThreadSweep& thread, const Turns& part) {
  ThreadSweep out = thread;
  out.from = thread.from + part.first * (thread.to - thread.from);
  out.to = thread.from + part.last * (thread.to - thread.from);
  out.start_rad = thread.start_rad + 2.0 * kPi * thread.turns * part.first;
  out.turns = thread.turns * (part.last - part.first);
  return out;
}

/// Heights of the material.
Range heightsOf(const std::vector<SectionBody>& bodies) {
  Range heights;
  for (const SectionBody& body : bodies) {
    for (const SectionLoop& loop : body.loops) {
      for (const Vec2& p : loop.points) heights.extend(p.y());
    }
  }
  return heights;
}

/// What is left of thread `i` beside those that hold some of it: at both ends, or nothing.
std::vector<ThreadSweep> leftOf(const std::vector<ThreadSweep>& threads, std::size_t i, const Range& radii,
                                const Range& heights) {
  const ThreadSweep& thread = threads[i];
  const std::vector<Vec2> corners = cornersInside(thread, radii.low, radii.high);
  const Turns inside = turnsBetween(thread, heights);
  if (corners.empty() || inside.first >= inside.last) return {};
  // Beyond where the other one ends a little stays, so that no ends lie in one plane.
  const double overlap = kOverlap / std::abs(thread.turns);
  std::vector<Turns> least{{0.0, 1.0}};
  double length = 1.0;
  for (std::size_t k = 0; k < threads.size(); ++k) {
    const std::optional<Turns> held = k == i ? std::nullopt : heldTurns(threads[k], thread, corners);
    if (!held) continue;
    std::vector<Turns> rest;
    if (inside.first < held->first - kSame)
      rest.push_back({inside.first, std::min(inside.last, held->first + overlap)});
    if (inside.last > held->last + kSame)
      rest.push_back({std::max(inside.first, held->last - overlap), inside.last});
    // Two that hold each other stay, but for what the first one holds whole.
    const std::vector<Vec2> others = cornersInside(threads[k], radii.low, radii.high);
    if (heldTurns(thread, threads[k], others) && (!rest.empty() || k > i)) continue;
    double sum = 0.0;
    for (const Turns& turns : rest) sum += turns.last - turns.first;
    if (sum >= kWorthCutting * length) continue;
    length = sum;
    least = std::move(rest);
  }
  std::vector<ThreadSweep> out;
  for (const Turns& turns : least) {
    const bool whole = turns.first <= 0.0 && turns.last >= 1.0;
    out.push_back(whole ? thread : partOf(thread, turns));
  }
  return out;
}

/// Of passes that go together those that make what all of them take of the material. `radii`: of the material
/// beside each pass.
std::vector<std::size_t> withoutInner(const std::vector<ThreadSweep>& threads,
                                      const std::vector<Range>& radii) {
  std::vector<std::size_t> out;
  for (const std::vector<std::size_t>& group : threadGroups(threads)) {
    if (group.size() < 3) {
      out.insert(out.end(), group.begin(), group.end());
      continue;
    }
    Range band;
    for (const std::size_t i : group) {
      // The way leads the tool away from radii at the start: what is in the material somewhere counts.
      const double away = threads[i].to.x() - threads[i].from.x();
      band.extend(radii[i].low - std::max(0.0, away));
      band.extend(radii[i].high - std::min(0.0, away));
    }
    for (const std::size_t k : passesThatCount(threads, group, band.low, band.high)) out.push_back(group[k]);
  }
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace

bool coversThread(const ThreadSweep& deep, const ThreadSweep& shallow, double low, double high) {
  if (!sameHelix(deep, shallow)) return false;
  // Both outlines are convex and their distance changes evenly, so that the corners at both ends decide.
  const std::vector<Vec2> corners = cornersInside(shallow, low, high);
  return holds(*deep.outline, corners, shallow.from - deep.from) &&
         holds(*deep.outline, corners, shallow.to - deep.to);
}

std::vector<ThreadSweep> withoutCovered(const std::vector<ThreadSweep>& threads,
                                        const std::vector<SectionBody>& bodies) {
  std::vector<ThreadSweep> kept;
  std::vector<Range> radii;
  for (std::size_t i = 0; i < threads.size(); ++i) {
    const Range material = radiiBeside(threads[i], bodies);
    const auto covers = [&](std::size_t deep, std::size_t shallow) {
      return coversThread(threads[deep], threads[shallow], material.low, material.high);
    };
    bool covered = material.low > material.high;
    for (std::size_t k = 0; k < threads.size() && !covered; ++k) {
      if (k != i && covers(k, i)) covered = k < i || !covers(i, k);
    }
    if (covered) continue;
    kept.push_back(threads[i]);
    radii.push_back(material);
  }
  std::vector<ThreadSweep> outer;
  std::vector<Range> beside;
  for (const std::size_t i : withoutInner(kept, radii)) {
    outer.push_back(kept[i]);
    beside.push_back(radii[i]);
  }
  const Range heights = heightsOf(bodies);
  std::vector<ThreadSweep> out;
  for (std::size_t i = 0; i < outer.size(); ++i) {
    for (ThreadSweep& left : leftOf(outer, i, beside[i], heights)) out.push_back(std::move(left));
  }
  return out;
}

}  // namespace proveout
