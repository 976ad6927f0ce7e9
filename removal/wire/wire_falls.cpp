#include "removal/wire/wire_falls.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "core/geometry/plane.h"
#include "removal/wire/kerf_section.h"
#include "removal/wire/stretch_index.h"

namespace proveout {
namespace {

/// Of the chords of ways and pieces, mm.
constexpr double kPieceChordMm = 1e-3;
/// Ways that come less deep into the hull of a piece do not go through it, mm.
constexpr double kIntoMm = 0.005;

/// Looks back from the end to when each body came free.
class FallFinder {
 public:
  FallFinder(const std::vector<PlaneLoop>& blank, const std::vector<WireStretch>& cuts,
             const WireHolding& holding)
      : blank_(blank), cuts_(cuts), holding_(holding), index_(cuts) {
    for (std::uint32_t i = 0; i < cuts.size(); ++i) {
      if (i + 1 == cuts.size() || cuts[i + 1].motion != cuts[i].motion) ends_.push_back(i + 1);
    }
  }

  WireFalls of(std::vector<PlaneBody> last) {
    WireFalls falls;
    std::vector<PlaneBody> loose;
    for (PlaneBody& body : last)
      (isCrumb(body) || holding_.keeps(body) ? falls.bodies : loose).push_back(std::move(body));
    for (const PlaneBody& body : loose) boxes_.push_back(boundsOf(body.loops.front()));
    std::map<std::uint32_t, std::vector<PlaneBody>> freed;  // by the cuts that were done
    for (std::size_t k = 0; k < loose.size(); ++k) {
      if (const auto cuts = fallOf(loose, k))
        freed[*cuts].push_back(loose[k]);
      else
        falls.bodies.push_back(loose[k]);
    }
    for (auto& [cuts, bodies] : freed) addPieces(cuts, std::move(bodies), falls);
    for (const FreePiece& piece : falls.pieces) falls.bodies.push_back(piece.body);
    std::stable_sort(falls.bodies.begin(), falls.bodies.end(),
                     [](const PlaneBody& a, const PlaneBody& b) { return a.area_mm2 > b.area_mm2; });
    return falls;
  }

 private:
  /// What is smaller than the kerf's circle.
  bool isCrumb(const PlaneBody& body) const {
    return !cuts_.empty() && body.area_mm2 < kPi * cuts_.front().kerf_mm * cuts_.front().kerf_mm;
  }

  /// The last motion that made an edge of the body closed its cut, unless it was free before that. None: a
  /// body that no motion has touched.
  std::optional<std::uint32_t> fallOf(const std::vector<PlaneBody>& loose, std::size_t k) const {
    const std::optional<MotionId> maker = lastMaker(loose[k]);
    if (!maker) return std::nullopt;
    const Look look{placeIn(loose[k]), neighbourhood(k)};
    std::size_t free = numberOf(*maker), held = shortlyBefore(free);
    if (free == 0) return ends_[0];
    // Small motions close a cut before the last of them: the kerf's front meets it from some way off.
    if (const auto body = heldAt(look, ends_[held])) {
      const std::uint32_t base = ends_[held];
      while (free - held > 1) {
        const std::size_t middle = held + (free - held) / 2;
        const bool still =
            heldIn(body->loops, {cuts_.begin() + base, cuts_.begin() + ends_[middle]}, look.at).has_value();
        (still ? held : free) = middle;
      }
      return ends_[free];
    }
    // The body is what later motions left of a piece that was free long before.
    for (free = held, held = 0; held < free;) {
      const std::size_t middle = held + (free - held) / 2;
      if (heldAt(look, ends_[middle]))
        held = middle + 1;
      else
        free = middle;
    }
    return ends_[free];
  }

  /// The last motion that ends some kerfs of way before motion `number`.
  std::size_t shortlyBefore(std::size_t number) const {
    constexpr double kKerfs = 8.0;
    double way = 0.0;
    std::size_t at = number;
    while (at > 0 && (at == number || way < kKerfs * cuts_.front().kerf_mm)) {
      --at;
      for (std::uint32_t i = at > 0 ? ends_[at - 1] : 0; i < ends_[at]; ++i) way += cuts_[i].length();
    }
    return at;
  }

  static std::optional<MotionId> lastMaker(const PlaneBody& body) {
    std::optional<MotionId> maker;
    for (const PlaneLoop& loop : body.loops) {
      for (const PlaneEdge& edge : loop.edges) {
        if (edge.motion != kNoMotion) maker = std::max(maker.value_or(0), edge.motion);
      }
    }
    return maker;
  }

  /// What cuts off a body runs about it, unless the body is a fragment of a larger one that fell before:
  /// another loose body is then beside it, and all cuts count.
  std::optional<Box3> neighbourhood(std::size_t k) const {
    const double beside = 3.0 * cuts_.front().kerf_mm;
    const Box3 box = boxes_[k].inflated(beside);
    for (std::size_t other = 0; other < boxes_.size(); ++other) {
      if (other != k && boxes_[other].inflated(beside).overlaps(box)) return std::nullopt;
    }
    return box.inflated(beside);
  }

  /// The place of a motion in ends_.
  std::size_t numberOf(MotionId motion) const {
    const auto at = std::lower_bound(ends_.begin(), ends_.end(), motion, [&](std::uint32_t end, MotionId id) {
      return cuts_[end - 1].motion < id;
    });
    return static_cast<std::size_t>(at - ends_.begin());
  }

  /// A place in a body, and where what may have cut it off is; none: everywhere.
  struct Look {
    Vec2 at;
    std::optional<Box3> box;
  };

  /// The body at that place after so many cuts, where it is held.
  std::optional<PlaneBody> heldAt(const Look& look, std::uint32_t cuts) const {
    if (!look.box) return heldIn(blank_, {cuts_.begin(), cuts_.begin() + cuts}, look.at);
    std::vector<WireStretch> done;
    for (const std::uint32_t i : index_.near(*look.box, cuts)) done.push_back(cuts_[i]);
    // Hollows elsewhere cut nothing off here.
    std::vector<PlaneLoop> region;
    for (const PlaneLoop& loop : blank_) {
      if (areaOf(loop) > 0.0 || boundsOf(loop).overlaps(*look.box)) region.push_back(loop);
    }
    return heldIn(region, done, look.at);
  }

  /// The same of a region less some cuts.
  std::optional<PlaneBody> heldIn(const std::vector<PlaneLoop>& region, const std::vector<WireStretch>& cuts,
                                  const Vec2& p) const {
    for (PlaneBody& body : cutSection(region, cuts)) {
      if (holds(polygonsOf(body.loops, kPieceChordMm), p))
        return holding_.keeps(body) ? std::optional(std::move(body)) : std::nullopt;
    }
    return std::nullopt;
  }

  /// What fell at once. Where the motions behind left the bodies alone they are as they fell.
  void addPieces(std::uint32_t cuts, std::vector<PlaneBody> bodies, WireFalls& falls) const {
    const auto later = [&](const PlaneEdge& edge) {
      return edge.motion != kNoMotion && ends_[numberOf(edge.motion)] > cuts;
    };
    const bool cut = std::any_of(bodies.begin(), bodies.end(), [&](const PlaneBody& body) {
      return std::any_of(body.loops.begin(), body.loops.end(), [&](const PlaneLoop& loop) {
        return std::any_of(loop.edges.begin(), loop.edges.end(), later);
      });
    });
    if (!cut) {
      for (PlaneBody& body : bodies) falls.pieces.push_back({std::move(body), cuts, false, {}});
      return;
    }
    std::vector<PlaneBody> then = cutSection(blank_, {cuts_.begin(), cuts_.begin() + cuts});
    for (PlaneBody& piece : then) {
      const PlanePolygons region = polygonsOf(piece.loops, kPieceChordMm);
      const bool here = std::any_of(bodies.begin(), bodies.end(),
                                    [&](const PlaneBody& body) { return holds(region, placeIn(body)); });
      if (here) falls.pieces.push_back({std::move(piece), cuts, true, region});
    }
  }

  const std::vector<PlaneLoop>& blank_;
  const std::vector<WireStretch>& cuts_;
  const WireHolding& holding_;
  StretchIndex index_;
  std::vector<Box3> boxes_;          ///< of the loose bodies
  std::vector<std::uint32_t> ends_;  ///< how many stretches there are up to the end of each motion
};

/// Counter-clockwise (A. M. Andrew, 1979).
std::vector<Vec2> hullOf(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(),
            [](const Vec2& a, const Vec2& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  std::vector<Vec2> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t begin = hull.size();
    for (const Vec2& p : points) {
      while (hull.size() >= begin + 2 && cross2(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

/// Whether a segment comes into a convex polygon by more than kIntoMm.
bool comesInto(const std::vector<Vec2>& hull, const Vec2& from, const Vec2& to) {
  double begin = 0.0, end = 1.0;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2 &a = hull[i], side = hull[(i + 1) % hull.size()] - a;
    if (!(side.norm() > 0.0)) continue;
    const Vec2 in = leftOf(side) / side.norm();
    const double at_from = in.dot(from - a) - kIntoMm, at_to = in.dot(to - a) - kIntoMm;
    if (at_from < 0.0 && at_to < 0.0) return false;
    if (at_from < 0.0) begin = std::max(begin, at_from / (at_from - at_to));
    if (at_to < 0.0) end = std::min(end, at_from / (at_from - at_to));
  }
  return begin < end;
}

bool goesInto(const std::vector<Vec2>& hull, const WireStretch& way) {
  const int chords = way.isArc() ? chordCount(way.radius(), way.sweep_rad, kPieceChordMm) : 1;
  for (int k = 0; k < chords; ++k) {
    if (comesInto(hull, way.at(static_cast<double>(k) / chords), way.at((k + 1.0) / chords))) return true;
  }
  return false;
}

}  // namespace

WireFalls findFalls(const std::vector<PlaneLoop>& blank, const std::vector<WireStretch>& cuts,
                    std::vector<PlaneBody> last, const WireHolding& holding) {
  return FallFinder(blank, cuts, holding).of(std::move(last));
}

std::uint32_t firstThrough(const FreePiece& piece, const std::vector<WireStretch>& cuts, std::uint32_t end) {
  const std::vector<Vec2> hull = hullOf(chordsOf(piece.body.loops.front(), kPieceChordMm).points);
  const Box3 bounds = boundsOf(piece.body.loops.front());
  for (std::uint32_t i = piece.cuts; i < end; ++i) {
    if (boundsOf(cuts[i]).overlaps(bounds) && goesInto(hull, cuts[i])) return i;
  }
  return end;
}

}  // namespace proveout
