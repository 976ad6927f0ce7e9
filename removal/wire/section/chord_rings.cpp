#include "removal/wire/section/chord_rings.h"

#include <algorithm>

#include "core/base/assert.h"
#include "core/geometry/plane.h"
#include "removal/wire/section/segment_meetings.h"

namespace proveout {
namespace {

/// A chord is halved at most so many times.
constexpr int kMostRounds = 20;
/// Chords shorter than so many steps of a mesh are not halved; corners stand back by as many.
constexpr double kShortest = 8.0, kStandBack = 2.0;

ChordRing ringOf(const PlaneLoop& loop, double tolerance) {
  const ChordLoop chords = chordsOf(loop, tolerance);
  ChordRing ring;
  for (const auto& [point, edge] : meshCorners(chords.points)) {
    const PlaneEdge& of = loop.edges[chords.edge[edge]];
    ring.points.push_back(asFloat(chords.points[point]));
    ring.motion.push_back(of.motion);
    ring.center.push_back(of.sweep_rad != 0.0 ? std::optional(of.center) : std::nullopt);
  }
  return ring;
}

/// Separates rings that meet.
class RingParter {
 public:
  explicit RingParter(std::vector<ChordRing>& rings) : rings_(rings) {}

  void part() {
    for (int round = 0; round < kMostRounds; ++round) {
      number();
      PROVEOUT_ASSERT(places_.size() == segments_.size());
      const auto pairs = meetingSegments(segments_);
      if (pairs.empty()) return;
      halved_.assign(segments_.size(), false);
      moved_.assign(segments_.size(), false);
      for (const auto& [a, b] : pairs) {
        repair(a, b);
        repair(b, a);
      }
      if (!apply()) return;
    }
  }

 private:
  struct Place {
    std::size_t ring, at;
  };

  void number() {
    segments_.clear();
    places_.clear();
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      const auto first = static_cast<std::uint32_t>(segments_.size());
      const std::size_t n = rings_[r].points.size();
      for (std::size_t i = 0; n > 2 && i < n; ++i) {
        const std::size_t next = (i + 1) % n;
        segments_.push_back({rings_[r].points[i], rings_[r].points[next],
                             first + static_cast<std::uint32_t>(i),
                             first + static_cast<std::uint32_t>(next)});
        places_.push_back({r, i});
      }
    }
  }

  void repair(std::uint32_t edge, std::uint32_t other) {
    const PlaneSegment &s = segments_[edge], &t = segments_[other];
    const double step = meshStep(s.from);
    if (rings_[places_[edge].ring].center[places_[edge].at] && (s.to - s.from).norm() > kShortest * step)
      halved_[edge] = true;
    if (s.start != t.end && s.start != t.start && distanceToSegment(s.from, t.from, t.to) <= step)
      moved_[s.start] = true;
    if (s.end != t.end && s.end != t.start && distanceToSegment(s.to, t.from, t.to) <= step)
      moved_[s.end] = true;
  }

  /// Moves a corner away from what it touches, towards both neighbours.
  Vec2 stoodBack(const ChordRing& ring, std::size_t i) const {
    const std::size_t n = ring.points.size();
    const Vec2& p = ring.points[i];
    const Vec2 way =
        (ring.points[(i + n - 1) % n] - p).normalized() + (ring.points[(i + 1) % n] - p).normalized();
    return way.norm() > 1e-6 ? asFloat(p + kStandBack * meshStep(p) * way.normalized()) : p;
  }

  static Vec2 halfWay(const Vec2& from, const Vec2& to, const Vec2& center) {
    const Vec2 u = from - center, v = to - center;
    return asFloat(center + (u + v).normalized() * (0.5 * (u.norm() + v.norm())));
  }

  /// False if there is nothing left to do.
  bool apply() {
    bool changed = false;
    std::vector<ChordRing> out(rings_.size());
    for (std::size_t k = 0; k < places_.size(); ++k) {
      const std::size_t r = places_[k].ring, i = places_[k].at;
      const ChordRing& ring = rings_[r];
      const auto add = [&](const Vec2& p) {
        out[r].points.push_back(p);
        out[r].motion.push_back(ring.motion[i]);
        out[r].center.push_back(ring.center[i]);
      };
      add(moved_[k] ? stoodBack(ring, i) : ring.points[i]);
      if (halved_[k])
        add(halfWay(ring.points[i], ring.points[(i + 1) % ring.points.size()], *ring.center[i]));
      changed = changed || halved_[k] || moved_[k];
    }
    rings_ = std::move(out);
    return changed;
  }

  std::vector<ChordRing>& rings_;
  std::vector<PlaneSegment> segments_;  ///< all rings' edges; corner k begins edge k
  std::vector<Place> places_;
  std::vector<bool> halved_, moved_;
};

}  // namespace

std::vector<ChordRing> chordRings(const std::vector<const PlaneLoop*>& loops, double tolerance) {
  std::vector<ChordRing> rings;
  for (const PlaneLoop* loop : loops) rings.push_back(ringOf(*loop, tolerance));
  RingParter(rings).part();
  PROVEOUT_ASSERT(rings.size() == loops.size());
  return rings;
}

}  // namespace proveout
