#include "removal/leaf_crossings.h"

#include <algorithm>
#include <cmath>

#include "removal/level_cut.h"

namespace proveout {

namespace {

/// A later pass takes a crossing over only if it cuts the edge shorter by this fraction: equal cuts belong to the
/// first pass that made them.
constexpr double kShorter = 1e-7;

/// Normal of the ball's sphere at `p`, where that is the surface; false on the flank.
bool ballNormal(const Pass& pass, const Vec3& p, Vec3& normal) {
  const ColumnSweep& c = pass.columns;
  const Vec3 way = sweepWay(c);
  const Vec3 q = p - sweepStart(c) - Vec3(0, 0, c.solid->radius);
  const double length2 = way.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp(q.dot(way) / length2, 0.0, 1.0) : 0.0;
  normal = q - t * way;
  if (normal.z() > 0.0) return false;
  normal.normalize();
  return true;
}

}  // namespace

std::vector<Crossing> CrossingFinder::find(const LeafChange& change, const LeafEdges& edges,
                                           const std::vector<Crossing>& before,
                                           std::span<const std::uint32_t> list) {
  collect(change, edges, before);
  addProbes();
  const Vec3 middle = impl_.position(change.origin) + Vec3::Constant(4.0 * impl_.h);
  BlockBox box{middle.x(), middle.y(), 4.0 * impl_.h, 0.0, 0.0};
  for (std::size_t first = 0; first < probes_.size(); first += kMaxColumns) {
    const std::size_t count = std::min<std::size_t>(kMaxColumns, probes_.size() - first);
    const auto [low, high] = std::minmax_element(z_.begin() + first, z_.begin() + first + count);
    // Probes move along their edges only.
    box.z_low = *low - impl_.h;
    box.z_high = *high + impl_.h;
    for (const std::uint32_t number : list) {
      const Pass& pass = table_.passes[number];
      if (pass.part == ToolPart::kCutter && reachIn(pass, box) < box.z_high) tryPass(number, first, count);
    }
  }
  std::vector<Crossing> out;
  out.reserve(edges_.size());
  for (const Edge& edge : edges_) out.push_back(crossing(edge, before));
  return out;
}

void CrossingFinder::collect(const LeafChange& change, const LeafEdges& edges, const std::vector<Crossing>& before) {
  edges_.clear();
  forEachEdge(edges, [&](int axis, int x, int y, int z) {
    Edge e;
    e.axis = static_cast<std::int8_t>(axis);
    const bool start_in = leafSample(change.material, x, y, z);
    e.forward = start_in ? 1 : -1;
    openvdb::Coord at = change.origin.offsetBy(x, y, z);
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

/// The probe at the crossing found so far meets every pass that cuts the edge shorter, as long as the pass covers
/// the rest of the edge; the one in the middle meets most of those that cut a piece out of the edge.
void CrossingFinder::addProbes() {
  probes_.clear();
  probes_of_edge_.assign(edges_.size(), {-1, -1});
  const auto add = [&](std::size_t edge, Probe kind) {
    probes_of_edge_[edge][kind == Probe::kEnd ? 0 : 1] = static_cast<std::int32_t>(probes_.size());
    probes_.push_back({static_cast<std::uint32_t>(edge), kind});
  };
  for (std::size_t i = 0; i < edges_.size(); ++i) add(i, Probe::kEnd);
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    if (edges_[i].axis != 2) add(i, Probe::kMiddle);
  }
  const std::size_t padded = (probes_.size() + 7) & ~std::size_t{7};
  x_.assign(padded, 0.0);
  y_.assign(padded, 0.0);
  z_.assign(padded, 0.0);
  for (std::size_t i = 0; i < probes_.size(); ++i) placeProbe(i);
}

void CrossingFinder::placeProbe(std::size_t i) {
  const Edge& e = edges_[probes_[i].edge];
  const double s = probes_[i].kind == Probe::kEnd ? (e.s < 1.0 ? std::max(0.0, e.s - kShorter) : 1.0) : 0.5 * e.s;
  Vec3 p = e.a;
  p[e.axis] += e.forward * s * impl_.h;
  x_[i] = p.x();
  y_[i] = p.y();
  z_[i] = p.z();
}

void CrossingFinder::tryPass(std::uint32_t number, std::size_t first, std::size_t count) {
  kernel_(table_.passes[number].columns, &x_[first], &y_[first], static_cast<int>(count), lo_.data(), hi_.data());
  for (std::size_t i = 0; i < count; ++i) {
    if (lo_[i] < z_[first + i] && z_[first + i] < hi_[i]) tryEdge(number, first + i, lo_[i], hi_[i]);
  }
}

void CrossingFinder::tryEdge(std::uint32_t number, std::size_t probe, double lo, double hi) {
  const std::uint32_t index = probes_[probe].edge;
  Edge& e = edges_[index];
  if (e.pass == number) return;  // by its other probe; this one has moved since lo and hi were asked
  double cut;
  if (e.axis == 2) {
    cut = e.forward > 0 ? lo - e.a.z() : e.a.z() - hi;
  } else {
    const double inside = std::abs(e.axis == 0 ? x_[probe] - e.a.x() : y_[probe] - e.a.y());
    const Pass& pass = table_.passes[number];
    cut = levelCut(pass, e.a, e.axis == 0 ? e.forward : 0.0, e.axis == 1 ? e.forward : 0.0, inside,
                   table_.levelArc(pass));
  }
  const double s = std::clamp(cut / impl_.h, 0.0, 1.0);
  if (s >= e.s - kShorter && !(e.pass == kOld && e.old < 0)) return;
  e.s = s;
  e.pass = number;
  for (const std::int32_t moved : probes_of_edge_[index]) {
    if (moved >= 0) placeProbe(static_cast<std::size_t>(moved));
  }
}

Crossing CrossingFinder::crossing(const Edge& e, const std::vector<Crossing>& before) const {
  if (e.pass == kOld && e.old >= 0) return before[static_cast<std::size_t>(e.old)];
  Crossing c;
  c.setPosition(e.forward > 0 ? e.s : 1.0 - e.s);
  Vec3 p = e.a, normal = Vec3::Unit(e.axis) * e.forward;
  p[e.axis] += e.forward * e.s * impl_.h;
  if (e.pass == kOld) {  // not expected: the sample was cut by a pass that is not in the list
    c.setNormal(normal);
    return c;
  }
  const Pass& pass = table_.passes[e.pass];
  c.motion = pass.motion;
  if (pass.curve < 0 && pass.columns.kind != ColumnSweep::Kind::kArc && pass.columns.solid->ball && ballNormal(pass, p, normal)) {
    c.setNormal(-normal);
    c.element = static_cast<std::uint16_t>(pass.profile->firstElementId());
    return c;
  }
  const SweepSample sample =
      pass.curve >= 0 ? table_.curves[static_cast<std::size_t>(pass.curve)].sample(p) : pass.lineSweep().sample(p);
  c.setNormal(-sample.gradient);
  c.element = static_cast<std::uint16_t>(sample.element);
  return c;
}

}  // namespace proveout
