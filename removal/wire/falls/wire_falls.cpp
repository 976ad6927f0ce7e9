#include "removal/wire/falls/wire_falls.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>

#include "core/base/assert.h"
#include "core/geometry/plane.h"
#include "core/geometry/polygon.h"
#include "core/mesh/edge_table.h"
#include "removal/wire/section/kerf_section.h"
#include "removal/wire/section/stretch_index.h"

namespace proveout {
namespace {

/// Of the chords of ways and pieces, mm.
constexpr double kPieceChordMm = 1e-3;
/// A way that enters the hull of a piece by less than this does not go through it, mm.
constexpr double kIntoMm = 0.005;
/// How far the search for the cut that closed a body goes back from the last cut about it.
constexpr double kLookBackKerfs = 8.0;
/// Way of the wire, in half widths of the kerf, on which it trims the cusp that its front leaves on a piece,
/// where it comes to meet a kerf's round end.
constexpr double kTrimKerfs = 2.0;
/// Pieces that come free within so much of way come free at the same time, mm.
constexpr double kSameTimeMm = 1e-3;

bool isIn(const Box3& box, const Vec2& p) {
  return (p.array() >= box.min.head<2>().array()).all() && (p.array() <= box.max.head<2>().array()).all();
}

/// A body after all cuts.
struct LastBody {
  PlaneBody body;
  Box3 box;              ///< of its border
  PlanePolygons region;  ///< made when it is first asked for
  bool kept = false;

  bool holdsPoint(const Vec2& p) {
    if (!isIn(box, p)) return false;
    if (region.empty()) region = polygonsOf(body.loops, kPieceChordMm);
    return holds(region, p);
  }
};

/// A place about some motions, and what is there as more and more is cut. Between the first and the last of
/// these motions bodies part nowhere else.
class FallWindow {
 public:
  FallWindow(const std::vector<PlaneLoop>& blank, const std::vector<WireStretch>& cuts,
             const StretchIndex& index, const Box3& box, std::vector<LastBody>& bodies)
      : blank_(blank), cuts_(cuts), box_(box), near_(index.near(box, StretchIndex::kNone)) {
    for (const PlanePolygons& region : after({static_cast<std::uint32_t>(cuts.size()), 0.0})) {
      const Vec2 at = placeIn(region);
      for (std::uint32_t k = 0; k < bodies.size(); ++k) {
        if (!bodies[k].holdsPoint(at)) continue;
        parts_.push_back({at, k, areaOf(region)});
        break;
      }
    }
  }

  const Box3& box() const { return box_; }

  /// What body `k` is one with here, at a time.
  struct Company {
    bool kept = false;   ///< a body that is kept
    bool other = false;  ///< a loose one, that may be held by others
  };
  Company companyOf(std::uint32_t k, const std::vector<LastBody>& bodies, const CutTime& time) const {
    DisjointSets sets(bodies.size());
    for (const PlanePolygons& region : after(time)) {
      std::optional<std::uint32_t> first;
      for (const Part& part : parts_) {
        if (!holds(region, part.at)) continue;
        if (first) sets.join(*first, part.body);
        first = first.value_or(part.body);
      }
    }
    Company company;
    for (std::uint32_t other = 0; other < bodies.size(); ++other) {
      if (other != k && sets.find(other) == sets.find(k))
        (bodies[other].kept ? company.kept : company.other) = true;
    }
    return company;
  }

  /// What is taken behind that time of what is here about body `k`, mm2.
  double takenBehind(std::uint32_t k, const CutTime& time) const {
    double area = 0.0;
    for (const PlanePolygons& region : after(time)) {
      const bool own = std::any_of(parts_.begin(), parts_.end(), [&](const Part& part) {
        return part.body == k && holds(region, part.at);
      });
      if (own) area += areaOf(region);
    }
    for (const Part& part : parts_)
      if (part.body == k) area -= part.area_mm2;
    return area;
  }

 private:
  /// What a body has of the window after all cuts.
  struct Part {
    Vec2 at;
    std::uint32_t body;
    double area_mm2;
  };

  static double areaOf(const PlanePolygons& region) {
    double sum = 0.0;
    for (const std::vector<Vec2>& loop : region) sum += polygonArea(loop);
    return sum;
  }

  std::vector<PlanePolygons> after(const CutTime& time) const {
    std::vector<WireStretch> done;
    for (const std::uint32_t i : near_) {
      if (i < time.cuts) done.push_back(cuts_[i]);
      if (i == time.cuts && time.share > 0.0) done.push_back(beginningOf(cuts_[i], time.share));
    }
    return regionsInside(box_, blank_, done);
  }

  const std::vector<PlaneLoop>& blank_;
  const std::vector<WireStretch>& cuts_;
  Box3 box_;
  std::vector<std::uint32_t> near_;
  std::vector<Part> parts_;
};

/// Looks back from the end to when each body came free.
class FallFinder {
 public:
  FallFinder(const std::vector<PlaneLoop>& blank, const std::vector<WireStretch>& cuts,
             const WireHolding& holding)
      : blank_(blank), cuts_(cuts), holding_(holding) {
    for (std::uint32_t i = 0; i < cuts.size(); ++i) {
      if (i + 1 == cuts.size() || cuts[i + 1].motion != cuts[i].motion) ends_.push_back(i + 1);
    }
  }

  WireFalls of(std::vector<PlaneBody> last) {
    WireFalls falls;
    std::vector<std::uint32_t> loose;
    for (PlaneBody& body : last) {
      const Box3 box = boundsOf(body.loops.front());
      bodies_.push_back({std::move(body), box, {}, false});
      bodies_.back().kept = holding_.keeps(bodies_.back().body);
      if (!bodies_.back().kept && !isCrumb(bodies_.back().body))
        loose.push_back(static_cast<std::uint32_t>(bodies_.size()) - 1);
    }
    std::map<CutTime, std::vector<Freed>> freed;
    for (const std::uint32_t k : loose) {
      if (const auto fall = fallOf(k)) freed[fall->time].push_back({k, fall->closed, fall->goes_on});
    }
    joinSameTimes(freed);
    std::vector<bool> fell(bodies_.size(), false);
    for (auto& [time, bodies] : freed) {
      for (const Freed& body : bodies) fell[body.number] = true;
      addPieces(time, bodies, falls);
    }
    for (std::size_t k = 0; k < bodies_.size(); ++k)
      if (!fell[k] && !isOfPiece(bodies_[k], falls)) falls.bodies.push_back(std::move(bodies_[k].body));
    PROVEOUT_ASSERT_DEAR(std::ranges::is_sorted(falls.pieces, {}, &FreePiece::fell));
    for (const FreePiece& piece : falls.pieces) falls.bodies.push_back(piece.body);
    std::stable_sort(falls.bodies.begin(), falls.bodies.end(),
                     [](const PlaneBody& a, const PlaneBody& b) { return a.area_mm2 > b.area_mm2; });
    return falls;
  }

 private:
  struct Fall {
    CutTime time;
    std::uint32_t closed;  ///< the stretch that closed its cut
    bool goes_on;          ///< what follows cuts more of it than a crumb
  };
  struct Freed {
    std::uint32_t number, closed;
    bool goes_on;
  };

  /// The kerf's front frees a piece before its sides have met what was cut before: as long as the wire goes
  /// on it trims the cusp in between.
  CutTime trimmed(CutTime time) const {
    constexpr double kSamePlace = 1e-6;
    double way = kTrimKerfs * cuts_.front().kerf_mm;
    while (time.cuts < cuts_.size()) {
      const WireStretch& on = cuts_[time.cuts];
      const bool begins = time.share <= 0.0;
      if (begins && time.cuts > 0 && (on.from - cuts_[time.cuts - 1].to).norm() > kSamePlace) break;
      const double left = (1.0 - time.share) * on.length();
      if (left > way) {
        time.share += way / on.length();
        break;
      }
      way -= left;
      time = {time.cuts + 1, 0.0};
    }
    return time;
  }

  /// What comes free at once was looked for in places of its own, and found within some kWayMm.
  void joinSameTimes(std::map<CutTime, std::vector<Freed>>& freed) const {
    for (auto at = freed.begin(); at != freed.end();) {
      const auto next = std::next(at);
      if (next == freed.end()) break;
      if (wayBetween(at->first, next->first) <= kSameTimeMm) {
        next->second.insert(next->second.begin(), at->second.begin(), at->second.end());
        freed.erase(at);
      }
      at = next;
    }
  }
  /// Infinite beyond the next stretch, mm.
  double wayBetween(const CutTime& a, const CutTime& b) const {
    if (a.cuts == b.cuts) return (b.share - a.share) * cuts_[a.cuts].length();
    if (b.cuts > a.cuts + 1) return std::numeric_limits<double>::infinity();
    const double on = b.share > 0.0 ? b.share * cuts_[b.cuts].length() : 0.0;
    return (1.0 - a.share) * cuts_[a.cuts].length() + on;
  }

  /// What later motions would have cut off a piece that fell before.
  static bool isOfPiece(const LastBody& body, const WireFalls& falls) {
    return !body.kept && std::any_of(falls.pieces.begin(), falls.pieces.end(), [&](const FreePiece& piece) {
      return piece.passed_over && holds(piece.region, placeIn(body.body));
    });
  }

  double crumb() const { return cuts_.empty() ? 0.0 : kPi * cuts_.front().kerf_mm * cuts_.front().kerf_mm; }
  /// What is smaller than the kerf's circle.
  bool isCrumb(const PlaneBody& body) const { return body.area_mm2 < crumb(); }

  /// The last motion that made an edge of the body closed its cut, unless it was free before that. None: a
  /// body that no motion has touched.
  std::optional<Fall> fallOf(std::uint32_t k) {
    const std::optional<MotionId> maker = lastMaker(bodies_[k].body);
    if (!maker) return std::nullopt;
    if (!index_) index_.emplace(cuts_);
    // Small motions close a cut before the last of them: the kerf's front meets it from some way off.
    std::size_t free = numberOf(*maker), held = shortlyBefore(free);
    if (free == 0) return fallByAll(k, 0, 0);
    const FallWindow window(blank_, cuts_, *index_, boxAbout(held, free), bodies_);
    const FallWindow::Company before = window.companyOf(k, bodies_, {ends_[held], 0.0});
    if (!before.kept || before.other) return fallByAll(k, held, free);
    const CutTime time = firstTime(cuts_, {ends_[held], 0.0}, {ends_[free], 0.0},
                                   [&](const CutTime& at) { return !window.companyOf(k, bodies_, at).kept; });
    const CutTime fell = trimmed(time);
    return Fall{fell, time.last(), isCutBehind(k, fell, &window)};
  }

  /// The same from sections of all cuts about it, where the place of the last motion does not tell: the body
  /// may be what later motions left of a piece that was free long before, or was held by one that fell later.
  Fall fallByAll(std::uint32_t k, std::size_t held, std::size_t free) const {
    const Look look{placeIn(bodies_[k].body), neighbourhood(k)};
    CutTime later{ends_[free], 0.0}, earlier{free > 0 ? ends_[held] : 0, 0.0};
    if (earlier.cuts > 0 && !isHeldAt(look, earlier)) {
      later = earlier;
      earlier = {};
    }
    const CutTime time =
        firstTime(cuts_, earlier, later, [&](const CutTime& at) { return !isHeldAt(look, at); });
    const CutTime fell = trimmed(time);
    return Fall{fell, time.last(), isCutBehind(k, fell, nullptr)};
  }

  /// What cuts off a body runs about it, unless another loose body is beside it, of which it may be a
  /// fragment: then all cuts count.
  std::optional<Box3> neighbourhood(std::uint32_t k) const {
    const double beside = 3.0 * cuts_.front().kerf_mm;
    const Box3 box = bodies_[k].box.inflated(beside);
    for (std::uint32_t other = 0; other < bodies_.size(); ++other) {
      const bool loose = !bodies_[other].kept && !isCrumb(bodies_[other].body);
      if (other != k && loose && bodies_[other].box.inflated(beside).overlaps(box)) return std::nullopt;
    }
    return box.inflated(beside);
  }

  /// A place in a body, and where what may have cut it off is; none: everywhere.
  struct Look {
    Vec2 at;
    std::optional<Box3> box;
  };
  /// Whether the body at that place is held at that time.
  bool isHeldAt(const Look& look, const CutTime& time) const {
    std::vector<WireStretch> done;
    std::vector<PlaneLoop> region;
    if (look.box) {
      for (const std::uint32_t i : index_->near(*look.box, time.cuts)) done.push_back(cuts_[i]);
      if (time.share > 0.0) done.push_back(beginningOf(cuts_[time.cuts], time.share));
      // Hollows elsewhere cut nothing off here.
      std::copy_if(blank_.begin(), blank_.end(), std::back_inserter(region), [&](const PlaneLoop& loop) {
        return areaOf(loop) > 0.0 || boundsOf(loop).overlaps(*look.box);
      });
    } else {
      done = cutUntil(cuts_, time);
      region = blank_;
    }
    for (const PlaneBody& body : cutSection(region, done)) {
      if (holds(polygonsOf(body.loops, kPieceChordMm), look.at)) return holding_.keeps(body);
    }
    return false;
  }

  /// The last motion that ends some kerfs of way before motion `number`.
  std::size_t shortlyBefore(std::size_t number) const {
    const double way = kLookBackKerfs * cuts_.front().kerf_mm;
    double gone = 0.0;
    std::size_t at = number;
    while (at > 0 && (at == number || gone < way)) {
      --at;
      for (std::uint32_t i = at > 0 ? ends_[at - 1] : 0; i < ends_[at]; ++i) gone += cuts_[i].length();
    }
    return at;
  }

  /// About the motions behind `held` up to `free`, with what is beside them.
  Box3 boxAbout(std::size_t held, std::size_t free) const {
    constexpr double kBesideKerfs = 3.0;
    Box3 box;
    for (std::uint32_t i = ends_[held]; i < ends_[free]; ++i) {
      box.extend(boundsOf(cuts_[i]).min);
      box.extend(boundsOf(cuts_[i]).max);
    }
    return box.inflated(kBesideKerfs * cuts_[ends_[free] - 1].kerf_mm);
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

  /// The place of a motion in ends_.
  std::size_t numberOf(MotionId motion) const {
    const auto at = std::lower_bound(ends_.begin(), ends_.end(), motion, [&](std::uint32_t end, MotionId id) {
      return cuts_[end - 1].motion < id;
    });
    PROVEOUT_ASSERT(at != ends_.end());  // what made an edge has cut
    return static_cast<std::size_t>(at - ends_.begin());
  }

  /// Whether the end of an edge that this motion made is made behind a time.
  bool isMadeBehind(MotionId motion, const Vec2& end, const CutTime& time) const {
    if (motion == kNoMotion) return false;
    const std::size_t number = numberOf(motion);
    if (CutTime{ends_[number], 0.0} <= time) return false;
    const std::uint32_t begin = number > 0 ? ends_[number - 1] : 0;
    return begin > time.last() || isNearerBehind(end, begin, ends_[number], time);
  }
  /// Whether of the stretches from `begin` to `end` those behind a time are the nearest to a point.
  bool isNearerBehind(const Vec2& p, std::uint32_t begin, std::uint32_t end, const CutTime& time) const {
    constexpr double kAsNear = 1e-4;
    double before = std::numeric_limits<double>::infinity(), behind = before;
    for (std::uint32_t i = begin; i < end; ++i) {
      const double off = distanceTo(cuts_[i], p).mm;
      if (i == time.cuts && time.share > 0.0)
        before = std::min(before, distanceTo(beginningOf(cuts_[i], time.share), p).mm);
      (i < time.cuts ? before : behind) = std::min(i < time.cuts ? before : behind, off);
    }
    return behind < before - kAsNear;
  }

  /// Whether what is cut behind a time takes something of a body. `window`: where its cut was closed; less
  /// than a crumb does not count there.
  bool isCutBehind(std::uint32_t k, const CutTime& time, const FallWindow* window) const {
    bool within = false;
    for (const PlaneLoop& loop : bodies_[k].body.loops) {
      for (std::size_t i = 0; i < loop.edges.size(); ++i) {
        for (const Vec2& p : {loop.edges[i].from, loop.edges[(i + 1) % loop.edges.size()].from}) {
          if (!isMadeBehind(loop.edges[i].motion, p, time)) continue;
          if (window == nullptr || !isIn(window->box(), p)) return true;
          within = true;
        }
      }
    }
    return within && window->takenBehind(k, time) >= crumb();
  }

  /// What fell at once. Where what is cut behind left the bodies alone they are as they fell.
  void addPieces(const CutTime& time, const std::vector<Freed>& freed, WireFalls& falls) const {
    if (std::none_of(freed.begin(), freed.end(), [](const Freed& body) { return body.goes_on; })) {
      for (const Freed& body : freed)
        falls.pieces.push_back({bodies_[body.number].body, time, false, {}, body.closed});
      return;
    }
    for (PlaneBody& piece : cutSection(blank_, cutUntil(cuts_, time))) {
      const PlanePolygons region = polygonsOf(piece.loops, kPieceChordMm);
      const auto here = std::find_if(freed.begin(), freed.end(), [&](const Freed& body) {
        return holds(region, placeIn(bodies_[body.number].body));
      });
      if (here != freed.end()) falls.pieces.push_back({std::move(piece), time, true, region, here->closed});
    }
  }

  const std::vector<PlaneLoop>& blank_;
  const std::vector<WireStretch>& cuts_;
  const WireHolding& holding_;
  std::optional<StretchIndex> index_;  ///< of the cuts
  std::vector<LastBody> bodies_;
  std::vector<std::uint32_t> ends_;  ///< how many stretches there are up to the end of each motion
};

/// Counter-clockwise (A. M. Andrew, 1979).
std::vector<Vec2> hullOf(std::vector<Vec2> points) {
  PROVEOUT_ASSERT(!points.empty());
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
  PROVEOUT_ASSERT(piece.closed < cuts.size() && end <= cuts.size());
  const std::vector<Vec2> hull = hullOf(chordsOf(piece.body.loops.front(), kPieceChordMm).points);
  const Box3 bounds = boundsOf(piece.body.loops.front());
  std::uint32_t begin = piece.closed + 1;
  while (begin < end && cuts[begin].motion == cuts[begin - 1].motion) ++begin;
  for (std::uint32_t i = begin; i < end; ++i) {
    if (boundsOf(cuts[i]).overlaps(bounds) && goesInto(hull, cuts[i])) return i;
  }
  return end;
}

}  // namespace proveout
