#include "removal/cut/leaf_crossings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/assert.h"

namespace proveout {

namespace {

/// A later pass takes a crossing over only if it cuts the edge shorter by this fraction: equal cuts belong to
/// the first pass that made them.
constexpr double kShorter = 1e-7;

/// Chains of passes on one edge that are followed; more than any tool's parts within a cell.
constexpr int kMostRounds = 64;
/// How far behind an old crossing material is looked for, as a fraction of the edge: thinner films are not
/// spoken of.
constexpr double kFilm = 0.02;

}  // namespace

std::vector<Crossing> CrossingFinder::find(const LeafChange& change, const LeafEdges& edges,
                                           const std::vector<Crossing>& before, std::span<const Reach> list) {
  if (edges.count == 0) return {};
  collect(change, edges, before);
  probes_.clear();
  probes_of_edge_.assign(edges_.size(), {-1, -1});
  FourBlocks boxes{};  // of the probes, which move along their edges only
  for (int q = 0; q < 4; ++q) groups_[q] = addGroup(change, q, boxes);
  listPasses(list, boxes);
  cutEdges();
  giveUntaken();
  std::vector<Crossing> out;
  out.reserve(edges_.size());
  for (const Edge& edge : edges_) out.push_back(crossing(edge, before));
  PROVEOUT_ASSERT(out.size() == edges.count);
  return out;
}

void CrossingFinder::listPasses(std::span<const Reach> list, const FourBlocks& boxes) {
  const double highest = *std::max_element(boxes.z_high, boxes.z_high + 4);
  passes_.clear();
  for (const Reach& reach : list) {
    if (reach.low >= highest) continue;
    const Pass& pass = table_.passes[reach.pass];
    if (!pass.cuts()) continue;
    Near near{reach.pass, 0, {}, {}};
    pass.body.reach(boxes, near.low.data(), near.high.data());
    for (std::size_t q = 0; q < 4; ++q) near.quarters |= near.low[q] < boxes.z_high[q] ? 1u << q : 0u;
    if (near.quarters == 0) continue;
    // Pieces of one volume are all asked whole, or none is.
    if (pass.body.isAskedWhole() && !passes_.empty() &&
        pass.body.isPieceWith(table_.passes[passes_.back().pass].body)) {
      passes_.back().quarters |= near.quarters;
    } else {
      passes_.push_back(near);
    }
  }
}

/// A pass may cover the rest of an edge only after a later one moved the crossing to it: all are asked, over
/// and over, until each has seen the last crossing that moved.
void CrossingFinder::cutEdges() {
  std::size_t asked = 0;  // since a crossing moved
  moves_ = 0;
  asked_.assign(passes_.size(), -1);
  for (int round = 0; round < kMostRounds; ++round) {
    for (std::size_t k = 0; k < passes_.size(); ++k) {
      moved_ = false;
      const int since = std::exchange(asked_[k], moves_);
      if (table_.passes[passes_[k].pass].body.isAskedWhole()) {
        tryWhole(passes_[k], since);
      } else {
        tryPass(passes_[k], since);
      }
      asked = moved_ ? 1 : asked + 1;
      if (asked >= passes_.size()) return;
    }
  }
}

/// Where the surface that an edge crossed goes on over an edge beside it, and nothing is left on the other
/// side, what is left on this one is the corner of solid material and no film. Adds the places on the other
/// side.
void CrossingFinder::addBeyond(SampleReader& read, const Coord& start, int axis, bool material_first,
                               const Vec3& p) {
  for (int other = 0; other < 3; ++other) {
    for (const int step : {-1, 1}) {
      if (other == axis) continue;
      Coord at = start;
      at[other] += step;
      Coord end = at;
      ++end[axis];
      if (read.isMaterial(at) != material_first || read.isMaterial(end) == material_first) continue;
      Vec3 beyond = p;
      beyond[other] -= step * impl_.h;
      beyond_.push_back(beyond);
    }
  }
}

/// Whether straight below a place of a surface all is left as far as a sample that is: an edge that runs
/// almost along a surface that leans loses the corner of solid material, and no film.
bool CrossingFinder::isSolidBelow(SampleReader& read, const Vec3& p, const Vec3& normal,
                                  std::span<const Reach> list) {
  constexpr int kDown = 4;
  const Vec3 deep = p - impl_.h * normal, steps = (deep - impl_.position(Coord(0, 0, 0))) / impl_.h;
  const Coord nearest(static_cast<int>(std::lround(steps.x())), static_cast<int>(std::lround(steps.y())),
                      static_cast<int>(std::lround(steps.z())));
  if (!read.isMaterial(nearest)) return false;
  std::vector<Vec3> down;
  for (int k = 1; k <= kDown; ++k) down.push_back(p - impl_.h * k / kDown * normal);
  const std::vector<char> bare = barePoints(down, list);
  return std::all_of(bare.begin(), bare.end(), [](char is) { return is != 0; });
}

LostFilm CrossingFinder::findLost(const LeafChange& change, const LeafEdges& edges,
                                  const std::vector<Crossing>& before, std::span<const Reach> list) {
  struct Film {
    Vec3 p;
    Coord start;
    int axis;
    bool material_first;
    Vec3 normal;
  };
  PROVEOUT_ASSERT(before.size() == change.before.count);
  std::vector<Film> films;
  std::vector<Vec3> points;
  std::size_t next = 0;
  forEachEdge(change.before, [&](int axis, int x, int y, int z) {
    const Crossing& old = before[next++];
    if (edges.isCrossed(axis, x, y, z) || leafSample(change.material, x, y, z)) return;
    const Coord start = change.origin.offsetBy(x, y, z);
    const bool material_first = old.normal[axis] > 0;
    Film film{impl_.position(start), start, axis, material_first, old.unitNormal()};
    film.p[axis] += (material_first ? std::max(0.0, old.t - kFilm) : std::min(1.0, old.t + kFilm)) * impl_.h;
    films.push_back(film);
    points.push_back(film.p);
  });
  const std::vector<char> bare = barePoints(points, list);
  SampleReader read(impl_);
  beyond_.clear();
  std::vector<std::array<std::size_t, 2>> beyond(films.size());  // of bare films, into beyond_
  for (std::size_t i = 0; i < films.size(); ++i) {
    beyond[i][0] = beyond_.size();
    if (bare[i] != 0) addBeyond(read, films[i].start, films[i].axis, films[i].material_first, films[i].p);
    beyond[i][1] = beyond_.size();
  }
  const std::vector<char> bare_beyond = barePoints(beyond_, list);
  LostFilm lost;
  for (std::size_t i = 0; i < films.size(); ++i) {
    bool film = bare[i] != 0;
    for (std::size_t k = beyond[i][0]; film && k < beyond[i][1]; ++k)
      film = bare_beyond[k] != 0 && impl_.blank.overlaps({beyond_[k], beyond_[k]});
    if (!film || isSolidBelow(read, films[i].p, films[i].normal, list)) continue;
    if (lost.edges++ == 0) lost.where = films[i].p;
    lost.parts += LostFilm::kParts / 2;
  }
  return lost;
}

/// Of each point whether no cutter of the list covers it.
std::vector<char> CrossingFinder::barePoints(const std::vector<Vec3>& points, std::span<const Reach> list) {
  x_.clear();
  y_.clear();
  z_.clear();
  tag_.clear();
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    x_.push_back(points[i].x());
    y_.push_back(points[i].y());
    z_.push_back(points[i].z());
    tag_.push_back(i);
  }
  if (!points.empty()) unitePieces(table_, list, united_);
  for (const Reach& reach : united_) {
    if (tag_.empty()) break;
    dropCovered(table_.passes[reach.pass]);
  }
  std::vector<char> bare(points.size(), 0);
  for (const std::uint32_t i : tag_) bare[i] = 1;
  return bare;
}

/// Moves the points that are not covered to the front, behind those that are kept. `covers`: of a number
/// from 0 to count - 1.
template <typename Covers>
void CrossingFinder::dropBatch(std::size_t first, std::size_t count, std::size_t& kept, Covers&& covers) {
  for (std::size_t i = 0; i < count; ++i) {
    if (covers(i)) continue;
    x_[kept] = x_[first + i];
    y_[kept] = y_[first + i];
    tag_[kept] = tag_[first + i];
    z_[kept++] = z_[first + i];
  }
}

/// Takes the points that the pass, or all that is asked as one with it, covers out of the lists.
void CrossingFinder::dropCovered(const Pass& pass) {
  std::size_t kept = 0;
  const std::size_t size = tag_.size();
  if (pass.body.isAskedWhole()) {
    dropBatch(0, size, kept, [&](std::size_t i) { return pass.body.covers({x_[i], y_[i], z_[i]}); });
  } else {
    for (std::vector<double>* list : {&x_, &y_, &z_}) list->resize((size + 7) & ~std::size_t{7});
    for (std::size_t first = 0; first < size; first += kMaxColumns) {
      const std::size_t count = std::min<std::size_t>(kMaxColumns, size - first);
      pass.body.columns(&x_[first], &y_[first], static_cast<int>(count), lo_.data(), hi_.data());
      dropBatch(first, count, kept,
                [&](std::size_t i) { return lo_[i] < z_[first + i] && z_[first + i] < hi_[i]; });
    }
  }
  for (std::vector<double>* list : {&x_, &y_, &z_}) list->resize(kept);
  tag_.resize(kept);
}

void CrossingFinder::collect(const LeafChange& change, const LeafEdges& edges,
                             const std::vector<Crossing>& before) {
  edges_.clear();
  forEachEdge(edges, [&](int axis, int x, int y, int z) {
    Edge e;
    e.axis = static_cast<std::int8_t>(axis);
    e.quarter = static_cast<std::uint8_t>((x >> 2) << 1 | y >> 2);
    const bool start_in = leafSample(change.material, x, y, z);
    e.forward = start_in ? 1 : -1;
    Coord at = change.origin.offsetBy(x, y, z);
    if (!start_in) ++at[axis];
    e.a = impl_.position(at);
    if (change.before.isCrossed(axis, x, y, z)) {
      e.old = change.before.indexOf(axis, x, y, z);
      const double t = before[static_cast<std::size_t>(e.old)].t;
      e.s = start_in ? t : 1.0 - t;
    }
    edges_.push_back(e);
  });
}

CrossingFinder::Group CrossingFinder::addGroup(const LeafChange& change, int quarter, FourBlocks& boxes) {
  Group group;
  group.first = probes_.size();
  addProbes(quarter);
  group.last = probes_.size();
  boxes.z_high[quarter] = -std::numeric_limits<double>::infinity();
  if (group.first == group.last) return group;
  // An edge may end one step beyond the quarter.
  const Vec3 low = impl_.position(change.origin);
  const double half = 2.0 * impl_.h;
  boxes.half_width = half;
  boxes.x[quarter] = low.x() + half + (quarter >> 1) * 2.0 * half;
  boxes.y[quarter] = low.y() + half + (quarter & 1) * 2.0 * half;
  const auto [least, most] = std::minmax_element(z_.begin() + static_cast<std::ptrdiff_t>(group.first),
                                                 z_.begin() + static_cast<std::ptrdiff_t>(group.last));
  boxes.z_low[quarter] = *least - impl_.h;
  boxes.z_high[quarter] = *most + kShorter * impl_.h;
  for (std::size_t i = group.first; i < group.last; ++i) {
    // Material above the cut: the probe may rise to the end in the material.
    const Edge& e = edges_[probes_[i].edge];
    if (e.axis == 2 && e.forward < 0) boxes.z_high[quarter] = std::max(boxes.z_high[quarter], e.a.z());
  }
  return group;
}

/// The probe at the crossing found so far meets every pass that cuts the edge shorter, as long as the pass
/// covers the rest of the edge; the one in the middle meets most of those that cut a piece out of the edge.
void CrossingFinder::addProbes(int quarter) {
  const std::size_t first = probes_.size();
  const auto add = [&](std::size_t edge, Probe kind) {
    probes_of_edge_[edge][kind == Probe::kEnd ? 0 : 1] = static_cast<std::int32_t>(probes_.size());
    probes_.push_back({static_cast<std::uint32_t>(edge), kind});
  };
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    if (edges_[i].quarter != quarter) continue;
    add(i, Probe::kEnd);
    if (edges_[i].axis != 2) add(i, Probe::kMiddle);
  }
  for (std::vector<double>* list : {&x_, &y_, &z_}) list->resize(probes_.size());
  for (std::size_t i = first; i < probes_.size(); ++i) placeProbe(i);
}

void CrossingFinder::placeProbe(std::size_t i) {
  const Edge& e = edges_[probes_[i].edge];
  const double s =
      probes_[i].kind == Probe::kEnd ? (e.s < 1.0 ? std::max(0.0, e.s - kShorter) : 1.0) : 0.5 * e.s;
  Vec3 p = e.a;
  p[e.axis] += e.forward * s * impl_.h;
  x_[i] = p.x();
  y_[i] = p.y();
  z_[i] = p.z();
}

/// Asks a pass, for edges that have moved after the first `since` moves (below 0: for all): of others it says
/// the same again.
void CrossingFinder::tryPass(const Near& near, int since) {
  ask_count_ = 0;
  for (std::size_t q = 0; q < 4; ++q) {
    if ((near.quarters >> q & 1) == 0) continue;
    for (std::size_t i = groups_[q].first; i < groups_[q].last; ++i) {
      const Edge& e = edges_[probes_[i].edge];
      if (e.moved <= since || e.pass == near.pass || z_[i] <= near.low[q] || z_[i] >= near.high[q]) continue;
      ask_x_[ask_count_] = x_[i];
      ask_y_[ask_count_] = y_[i];
      ask_[ask_count_++] = i;
      if (ask_count_ == kMaxColumns) tryBatch(near.pass);
    }
  }
  if (ask_count_ > 0) tryBatch(near.pass);
}

void CrossingFinder::tryBatch(std::uint32_t number) {
  const std::size_t count = std::exchange(ask_count_, 0);
  const SweptBody& body = table_.passes[number].body;
  const bool together = body.cutsTogether();
  body.columns(ask_x_.data(), ask_y_.data(), static_cast<int>(count), lo_.data(), hi_.data());
  level_cuts_.cuts.count = upright_cuts_.cuts.count = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t probe = ask_[i];
    if (!(lo_[i] < z_[probe] && z_[probe] < hi_[i])) continue;
    if (together) {
      addTogether(probe, lo_[i], hi_[i]);
    } else {
      tryEdge(number, probe, lo_[i], hi_[i]);
    }
  }
  for (TogetherCuts* cuts : {&level_cuts_, &upright_cuts_}) {
    if (cuts->cuts.count > 0) cutTogether(number, *cuts);
  }
}

/// Adds the edge of a probe to those that are cut together.
void CrossingFinder::addTogether(std::size_t probe, double lo, double hi) {
  const std::uint32_t index = probes_[probe].edge;
  const Edge& e = edges_[index];
  const bool level = e.axis != 2;
  TogetherCuts& together = level ? level_cuts_ : upright_cuts_;
  EdgeCuts& cuts = together.cuts;
  const auto i = static_cast<std::size_t>(cuts.count);
  if (i > 0 && together.edge[i - 1] == index) return;  // by its other probe
  together.edge[i] = index;
  together.at[i] = e.forward > 0 ? lo - e.a.z() : e.a.z() - hi;
  cuts.x[i] = e.a.x();
  cuts.y[i] = e.a.y();
  cuts.z[i] = e.a.z();
  cuts.dx[i] = e.axis == 0 ? e.forward : 0.0;
  cuts.dy[i] = e.axis == 1 ? e.forward : 0.0;
  cuts.inside[i] = level ? std::abs(e.axis == 0 ? x_[probe] - e.a.x() : y_[probe] - e.a.y()) : 0.0;
  cuts.end[i] = level ? 0.0 : e.forward;
  ++cuts.count;
}

void CrossingFinder::cutTogether(std::uint32_t number, TogetherCuts& together) {
  EdgeCuts& cuts = together.cuts;
  table_.passes[number].body.cutEdges(cuts);
  for (std::size_t i = 0; i < static_cast<std::size_t>(cuts.count); ++i) {
    const bool level = cuts.end[i] == 0.0;
    moveCrossing(number, together.edge[i], {level ? cuts.at[i] : together.at[i], cuts.start[i]});
  }
}

void CrossingFinder::tryEdge(std::uint32_t number, std::size_t probe, double lo, double hi) {
  const std::uint32_t index = probes_[probe].edge;
  Edge& e = edges_[index];
  if (e.pass == number) return;  // by its other probe; this one has moved since lo and hi were asked
  EdgeCut cut{0.0, -1.0};
  if (e.axis == 2) {
    cut.at = e.forward > 0 ? lo - e.a.z() : e.a.z() - hi;
  } else {
    const double inside = std::abs(e.axis == 0 ? x_[probe] - e.a.x() : y_[probe] - e.a.y());
    const double dx = e.axis == 0 ? e.forward : 0.0, dy = e.axis == 1 ? e.forward : 0.0;
    cut = table_.passes[number].body.levelCut(e.a, dx, dy, inside);
  }
  moveCrossing(number, index, cut);
}

/// The whole volume at once: it is convex nowhere, and may cut several pieces out of an edge. Edges are asked
/// that have moved after the first `since` moves; below 0: all.
void CrossingFinder::tryWhole(const Near& near, int since) {
  const SweptBody& body = table_.passes[near.pass].body;
  for (std::size_t i = 0; i < probes_.size(); ++i) {
    const Edge& e = edges_[probes_[i].edge];
    if ((near.quarters >> e.quarter & 1) == 0) continue;
    if (e.moved <= since || (probes_[i].kind == Probe::kEnd && e.pass == near.pass)) continue;
    const Vec3 p(x_[i], y_[i], z_[i]);
    if (!body.covers(p)) continue;
    const double inside = std::abs(p[e.axis] - e.a[e.axis]);
    moveCrossing(near.pass, probes_[i].edge,
                 {body.wholeCut(e.a, e.forward * Vec3::Unit(e.axis), inside), -1.0});
  }
}

/// Chords lie off the curve that is asked whole, so that a sample may be gone to which it does not quite
/// reach: its edges end there.
void CrossingFinder::giveUntaken() {
  for (std::uint32_t i = 0; i < edges_.size(); ++i) {
    const Edge& e = edges_[i];
    if (e.pass != kOld || e.old >= 0) continue;
    const Vec3 gone = e.a + e.forward * impl_.h * Vec3::Unit(e.axis);
    double least = impl_.h;
    std::uint32_t nearest = kOld;
    for (const Near& near : passes_) {
      const SweptBody& body = table_.passes[near.pass].body;
      const bool asked = body.isAskedWhole() && (near.quarters >> e.quarter & 1) != 0;
      const double distance = asked ? body.distance(gone, least) : least;
      if (distance < least) least = distance, nearest = near.pass;
    }
    if (nearest != kOld) moveCrossing(nearest, i, {impl_.h, -1.0});
  }
}

void CrossingFinder::moveCrossing(std::uint32_t number, std::uint32_t index, const EdgeCut& cut) {
  Edge& e = edges_[index];
  const double s = std::clamp(cut.at / impl_.h, 0.0, 1.0);
  if (s >= e.s - kShorter && !(e.pass == kOld && e.old < 0)) return;
  e.s = s;
  e.pass = number;
  e.start = cut.start;
  e.moved = ++moves_;
  moved_ = true;
  for (const std::int32_t moved : probes_of_edge_[index]) {
    if (moved >= 0) placeProbe(static_cast<std::size_t>(moved));
  }
}

Crossing CrossingFinder::crossing(const Edge& e, const std::vector<Crossing>& before) const {
  if (e.pass == kOld && e.old >= 0) return before[static_cast<std::size_t>(e.old)];
  Crossing c;
  c.setPosition(e.forward > 0 ? e.s : 1.0 - e.s);
  Vec3 p = e.a;
  p[e.axis] += e.forward * e.s * impl_.h;
  if (e.pass == kOld) {  // not expected: the sample was cut by a pass that is not in the list
    c.setNormal(Vec3::Unit(e.axis) * e.forward);
    return c;
  }
  const Pass& pass = table_.passes[e.pass];
  c.motion = pass.motion;
  const SweptSurface surface = pass.body.surface(p, e.axis, e.forward > 0, e.start);
  c.setNormal(-surface.normal);
  c.element = static_cast<std::uint16_t>(surface.element);
  return c;
}

}  // namespace proveout
