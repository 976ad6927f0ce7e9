#include "removal/wire/falls/wire_bridges.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <span>

#include "core/base/assert.h"
#include "core/geometry/plane.h"
#include "core/geometry/polygon.h"
#include "removal/wire/falls/wire_holding.h"

namespace proveout {
namespace {

/// Wider bridges are walls of the part, mm.
constexpr double kWidestBridge = 10.0;
/// How many directions about an end are searched, and how many consecutive ones must show its round front.
constexpr int kRays = 64, kFrontRays = 3;
/// Of chords, and by how much a front may be off its circle, mm.
constexpr double kChordMm = 1e-4, kOffCircle = 3e-4;
/// Material that is no farther from an end than so many kerfs is beside it.
constexpr double kBeside = 1.5;
/// A piece has room for a circle of this radius, in widths of its bridge; what has not is a wall of one
/// width.
constexpr double kRoom = 0.75, kRoomTolerance = 0.01;

struct Place {
  std::uint32_t loop = 0, edge = 0;
  double share = 0.0;  ///< of the edge
};

struct Hit {
  double away = std::numeric_limits<double>::infinity();
  Place place;
};

struct Neck {
  CutEnd end;
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();
  Place near, far;
  double width() const { return (to - from).norm(); }
  Vec2 middle() const { return 0.5 * (from + to); }
};

/// The borders of all bodies.
class Borders {
 public:
  explicit Borders(const std::vector<PlaneBody>& bodies) {
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      for (const PlaneLoop& loop : bodies[k].loops) {
        loops_.push_back(chordsOf(loop, kChordMm).points);
        body_of_.push_back(k);
      }
    }
  }

  const std::vector<Vec2>& loop(std::uint32_t k) const { return loops_[k]; }
  std::size_t bodyOf(std::uint32_t loop) const { return body_of_[loop]; }

  /// Edges that come within a distance of a point.
  std::vector<Place> near(const Vec2& p, double reach) const {
    std::vector<Place> out;
    for (std::uint32_t k = 0; k < loops_.size(); ++k) {
      for (std::uint32_t i = 0; i < loops_[k].size(); ++i) {
        if (distanceToSegment(p, start({k, i, 0.0}), end({k, i, 0.0})) <= reach) out.push_back({k, i, 0.0});
      }
    }
    return out;
  }

  /// The first two meetings of a ray with these edges.
  std::pair<Hit, Hit> along(const Vec2& from, const Vec2& direction, const std::vector<Place>& edges) const {
    Hit first, second;
    for (const Place& edge : edges) {
      const Vec2 a = start(edge) - from, d = end(edge) - start(edge);
      const double across = cross2(direction, d);
      if (across == 0.0) continue;
      const double away = cross2(a, d) / across, share = cross2(a, direction) / across;
      if (away <= 0.0 || share < 0.0 || share >= 1.0 || away >= second.away) continue;
      second = {away, {edge.loop, edge.edge, share}};
      if (second.away < first.away) std::swap(first, second);
    }
    return {first, second};
  }

  /// The loop from one of its places to another.
  std::vector<Vec2> between(const Place& from, const Place& to) const {
    PROVEOUT_ASSERT(from.loop == to.loop);
    std::vector<Vec2> out{at(from)};
    const auto n = static_cast<std::uint32_t>(loops_[from.loop].size());
    const bool ahead = from.edge == to.edge && from.share <= to.share;
    for (std::uint32_t i = from.edge; !ahead;) {
      i = (i + 1) % n;
      out.push_back(loops_[from.loop][i]);
      if (i == to.edge) break;
    }
    out.push_back(at(to));
    return out;
  }

 private:
  const Vec2& start(const Place& p) const { return loops_[p.loop][p.edge]; }
  const Vec2& end(const Place& p) const { return loops_[p.loop][(p.edge + 1) % loops_[p.loop].size()]; }
  Vec2 at(const Place& p) const { return start(p) + p.share * (end(p) - start(p)); }

  std::vector<std::vector<Vec2>> loops_;
  std::vector<std::size_t> body_of_;
};

/// Looks across the material in front of one end.
class EndLook {
 public:
  EndLook(const Borders& borders, const CutEnd& end)
      : borders_(borders), end_(end), edges_(borders.near(end.at, end.kerf_mm + kWidestBridge)) {}

  /// The shortest way through material from its round front.
  std::optional<Neck> narrowest() const {
    std::vector<std::pair<Hit, Hit>> hits;
    for (int k = 0; k < kRays; ++k) hits.push_back(look(angleOf(k)));
    if (!isOneBody(hits)) return std::nullopt;
    int best = -1;
    for (int k = 0; k < kRays; ++k) {
      if (!isInFront(hits, k) || !std::isfinite(hits[k].second.away)) continue;
      if (best < 0 || hits[k].second.away < hits[best].second.away) best = k;
    }
    if (best < 0) return std::nullopt;
    const double angle = nearest(angleOf(best));
    const auto [first, second] = look(angle);
    if (!isFront(first) || second.away - first.away > kWidestBridge) return std::nullopt;
    const Vec2 along(std::cos(angle), std::sin(angle));
    return Neck{end_, end_.at + first.away * along, end_.at + second.away * along, first.place, second.place};
  }

 private:
  static double angleOf(int k) { return 2.0 * kPi * (k + 0.5) / kRays; }
  std::pair<Hit, Hit> look(double angle) const {
    return borders_.along(end_.at, Vec2(std::cos(angle), std::sin(angle)), edges_);
  }
  bool isFront(const Hit& hit) const { return std::abs(hit.away - end_.kerf_mm) <= kOffCircle; }
  bool isInFront(const std::vector<std::pair<Hit, Hit>>& hits, int k) const {
    for (int first = k - kFrontRays + 1; first <= k; ++first) {
      int count = 0;
      while (count < kFrontRays && isFront(hits[(first + count + kRays) % kRays].first)) ++count;
      if (count == kFrontRays) return true;
    }
    return false;
  }
  /// A contour that is closed here has two bodies beside it.
  bool isOneBody(const std::vector<std::pair<Hit, Hit>>& hits) const {
    std::optional<std::size_t> body;
    for (const auto& [first, second] : hits) {
      if (first.away > kBeside * end_.kerf_mm) continue;
      const std::size_t found = borders_.bodyOf(first.place.loop);
      if (body.value_or(found) != found) return false;
      body = found;
    }
    return body.has_value();
  }
  /// Between the rays beside it: golden section.
  double nearest(double angle) const {
    constexpr double kGolden = 0.6180339887498949;
    constexpr int kSteps = 30;
    double low = angle - 2.0 * kPi / kRays, high = angle + 2.0 * kPi / kRays;
    const auto cost = [&](double a) {
      const auto [first, second] = look(a);
      return isFront(first) ? second.away : std::numeric_limits<double>::infinity();
    };
    double best = angle, least = cost(angle);
    for (int k = 0; k < kSteps; ++k) {
      const double a = high - kGolden * (high - low), b = low + kGolden * (high - low);
      const double at_a = cost(a), at_b = cost(b);
      (at_a <= at_b ? high : low) = at_a <= at_b ? b : a;
      if (std::min(at_a, at_b) < least) least = std::min(at_a, at_b), best = at_a <= at_b ? a : b;
    }
    return best;
  }

  const Borders& borders_;
  const CutEnd& end_;
  std::vector<Place> edges_;
};

/// Whether the piece has room for a circle: squares of its bounds are quartered as long as they may hold its
/// middle (pole of inaccessibility).
bool hasRoom(const std::vector<Vec2>& piece, double width) {
  const double radius = kRoom * width, least = kRoomTolerance * radius;
  struct Square {
    Vec2 middle;
    double half;
  };
  Box3 box;
  for (const Vec2& p : piece) box.extend(Vec3(p.x(), p.y(), 0.0));
  std::vector<Square> open{{box.center().head<2>(), 0.5 * box.size().maxCoeff()}};
  while (!open.empty()) {
    const Square square = open.back();
    open.pop_back();
    const double border = borderDistance({piece}, square.middle),
                 inside = holds({piece}, square.middle) ? border : -border;
    if (inside >= radius) return true;
    if (inside + std::numbers::sqrt2 * square.half < radius || square.half < least) continue;
    for (const double x : {-0.5, 0.5})
      for (const double y : {-0.5, 0.5})
        open.push_back({square.middle + square.half * Vec2(x, y), 0.5 * square.half});
  }
  return false;
}

/// What cutting a neck between two places of one loop parts, mm2; none: nothing that hangs on by it.
std::optional<double> partedBy(const Neck& neck, const Borders& borders) {
  const std::vector<Vec2> one = borders.between(neck.near, neck.far),
                          other = borders.between(neck.far, neck.near);
  const double a = polygonArea(one), b = polygonArea(other);
  const bool hollow = polygonArea(borders.loop(neck.near.loop)) < 0.0;
  const bool first = hollow ? a > b : a < b;  // a hollow parts into the piece and what is about it
  if ((first ? a : b) <= 0.0 || !hasRoom(first ? one : other, neck.width())) return std::nullopt;
  if (!hollow && !hasRoom(first ? other : one, neck.width())) return std::nullopt;
  return first ? a : b;
}

/// Those of necks between different loops that together go round a piece.
std::vector<Neck> closedRound(std::vector<Neck> necks) {
  for (bool changed = true; changed;) {
    std::map<std::uint32_t, int> degree;
    for (const Neck& neck : necks) ++degree[neck.near.loop], ++degree[neck.far.loop];
    const auto ends = [&](const Neck& n) { return degree[n.near.loop] < 2 || degree[n.far.loop] < 2; };
    changed = std::erase_if(necks, ends) > 0;
  }
  return necks;
}

/// Two ends that face each other see one neck.
bool isKnown(const Neck& neck, const std::vector<Neck>& known) {
  return std::any_of(known.begin(), known.end(), [&](const Neck& other) {
    return (other.middle() - neck.middle()).norm() <= neck.end.kerf_mm + 0.5 * neck.width();
  });
}

UncutBridge bridgeOf(const Neck& neck, double volume_mm3, double z) {
  UncutBridge out;
  out.motion = neck.end.motion;
  out.where = Vec3(neck.middle().x(), neck.middle().y(), z);
  out.width_mm = neck.width();
  out.open_mm = neck.width() + 2.0 * neck.end.kerf_mm;
  out.volume_mm3 = volume_mm3;
  return out;
}

bool stopsBefore(const Toolpath& path, MotionId id) {
  return std::any_of(path.events.begin(), path.events.end(), [&](const Toolpath::EventAt& at) {
    return at.before == id && at.event.as<event::Stop>() != nullptr;
  });
}

bool areJoined(const WireStretch& a, const WireStretch& b) {
  constexpr double kJoined = 1e-6;
  return (a.to - b.from).norm() <= kJoined;
}

/// Of a run of cuts that follow each other. What has no offset in a run that has some is a way to the contour
/// or back.
void addEnds(const Toolpath& path, std::span<const WireStretch> run, std::vector<CutEnd>& ends) {
  const auto isOffset = [&](const WireStretch& s) { return path.motions[s.motion].compensated; };
  const bool offset = std::any_of(run.begin(), run.end(), isOffset);
  for (std::size_t i = 0; i <= run.size(); ++i) {
    const bool before = i > 0 && (!offset || isOffset(run[i - 1])),
               behind = i < run.size() && (!offset || isOffset(run[i]));
    const bool stops =
        before && behind && run[i - 1].motion != run[i].motion && stopsBefore(path, run[i].motion);
    if (before && (!behind || stops)) ends.push_back({run[i - 1].to, run[i - 1].kerf_mm, run[i - 1].motion});
    if (behind && !before) ends.push_back({run[i].from, run[i].kerf_mm, run[i].motion});
  }
}

}  // namespace

std::vector<CutEnd> cutEnds(const Toolpath& path, const WireWork& work) {
  std::vector<CutEnd> ends;
  const std::vector<WireStretch>& cuts = work.cuts;
  for (std::size_t first = 0; first < cuts.size();) {
    std::size_t last = first;
    while (last + 1 < cuts.size() && areJoined(cuts[last], cuts[last + 1])) ++last;
    addEnds(path, {cuts.data() + first, last + 1 - first}, ends);
    first = last + 1;
  }
  return ends;
}

std::vector<UncutBridge> findBridges(const std::vector<PlaneBody>& bodies, const std::vector<CutEnd>& ends,
                                     double height_mm, double z) {
  const Borders borders(bodies);
  std::vector<UncutBridge> bridges;
  std::vector<Neck> told, others;
  for (const CutEnd& end : ends) {
    const std::optional<Neck> neck = EndLook(borders, end).narrowest();
    if (!neck || isKnown(*neck, told) || isKnown(*neck, others)) continue;
    if (neck->near.loop != neck->far.loop) {
      others.push_back(*neck);
    } else if (const auto area = partedBy(*neck, borders)) {
      told.push_back(*neck);
      bridges.push_back(bridgeOf(*neck, *area * height_mm, z));
    }
  }
  for (const Neck& neck : closedRound(std::move(others))) bridges.push_back(bridgeOf(neck, 0.0, z));
  return bridges;
}

}  // namespace proveout
