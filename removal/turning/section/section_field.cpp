#include "removal/turning/section/section_field.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/geometry/plane.h"

namespace proveout {

namespace {

/// Edges that turn by less are one smooth curve (see kSectionChordMm: an arc of 0.1 mm turns by 0.09).
constexpr double kSmoothTurn = 0.1;
/// Points this near the axis lie on it, mm: the unit of the polygons.
constexpr double kAxis = 1e-6;
constexpr std::size_t kMostBins = 4096;

double turnBetween(const Vec2& a, const Vec2& b) { return std::abs(std::atan2(cross2(a, b), a.dot(b))); }

/// The normal of a curve where two of its chords meet: that of a parabola, so that a line that goes over into
/// an arc keeps its own.
Vec2 normalBetween(const Vec2& a, double length_a, const Vec2& b, double length_b) {
  return (a * length_b + b * length_a).normalized();
}

}  // namespace

Vec2 SectionField::Edge::normalAt(const Vec2& p) const {
  const Vec2 d = to - from;
  const double share = std::clamp(d.dot(p - from) / d.squaredNorm(), 0.0, 1.0);
  return ((1.0 - share) * normal_from + share * normal_to).normalized();
}

SectionField::SectionField(const std::vector<SectionBody>& bodies) {
  for (const SectionBody& body : bodies) {
    for (const SectionLoop& loop : body.loops) addLoop(loop);
  }
  if (edges_.empty()) return;
  min_ = max_ = edges_.front().from;
  for (const Edge& e : edges_) {
    min_ = min_.cwiseMin(e.from);
    max_ = max_.cwiseMax(e.from);
    const double a = e.from.x(), b = e.to.x();
    volume_ += kPi / 3.0 * (e.to.y() - e.from.y()) * (a * a + a * b + b * b);
  }
  makeBins();
  simple_.assign(static_cast<std::size_t>(faces_), true);
  for (const Edge& e : edges_) {
    const bool straight = e.from.x() == e.to.x() || e.from.y() == e.to.y();
    if (!straight || !e.first || !e.last) simple_[static_cast<std::size_t>(e.face)] = false;
  }
}

void SectionField::addLoop(const SectionLoop& loop) {
  std::vector<Edge> edges;
  const std::size_t n = loop.points.size();
  PROVEOUT_ASSERT(loop.motion.size() == n);
  for (std::size_t i = 0; i < n; ++i) {
    Edge e;
    e.from = loop.points[i];
    e.to = loop.points[(i + 1) % n];
    if (e.from == e.to) continue;
    e.motion = loop.motion[i];
    e.on_axis = e.from.x() < kAxis && e.to.x() < kAxis;
    const Vec2 d = (e.to - e.from).normalized();
    e.normal_from = e.normal_to = {d.y(), -d.x()};
    edges.push_back(e);
  }
  const std::size_t count = edges.size();
  std::vector<std::uint8_t> smooth(count);  // where the edge begins
  std::vector<Vec2> normals(count);
  for (std::size_t i = 0; i < count; ++i) normals[i] = edges[i].normal_from;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t before = (i + count - 1) % count;
    Edge &a = edges[before], &b = edges[i];
    const Vec2 &na = normals[before], &nb = normals[i];
    if (a.on_axis != b.on_axis) {  // a dome goes on beyond the axis
      Edge& e = a.on_axis ? b : a;
      const Vec2& normal = a.on_axis ? nb : na;
      if (2.0 * std::asin(std::min(1.0, std::abs(normal.x()))) < kSmoothTurn)
        (a.on_axis ? e.normal_from : e.normal_to) = {0.0, normal.y() > 0.0 ? 1.0 : -1.0};
      continue;
    }
    smooth[i] = a.motion == b.motion && !a.on_axis && turnBetween(na, nb) < kSmoothTurn;
    if (!smooth[i]) continue;
    a.normal_to = b.normal_from = normalBetween(na, (a.to - a.from).norm(), nb, (b.to - b.from).norm());
  }
  const auto corner = std::find(smooth.begin(), smooth.end(), 0);
  const std::size_t first = corner == smooth.end() ? 0 : static_cast<std::size_t>(corner - smooth.begin());
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = (first + k) % count;
    if (k > 0 && !smooth[i]) ++faces_;
    edges[i].face = faces_;
    edges[i].first = smooth[i] == 0;
    edges[i].last = smooth[(i + 1) % count] == 0;
  }
  ++faces_;
  edges_.insert(edges_.end(), edges.begin(), edges.end());
}

int SectionField::binOf(double z) const {
  return static_cast<int>(std::clamp((z - min_.y()) / bin_height_, 0.0, bins_ - 1.0));
}

void SectionField::makeBins() {
  bins_ = static_cast<int>(std::min(edges_.size(), kMostBins));
  bin_height_ = std::max((max_.y() - min_.y()) / bins_, 1e-9);
  const auto reach = [&](const Edge& e) {
    return std::pair(binOf(std::min(e.from.y(), e.to.y())), binOf(std::max(e.from.y(), e.to.y())));
  };
  bin_start_.assign(static_cast<std::size_t>(bins_) + 1, 0);
  for (const Edge& e : edges_) {
    const auto [low, high] = reach(e);
    for (int b = low; b <= high; ++b) ++bin_start_[static_cast<std::size_t>(b) + 1];
  }
  for (std::size_t b = 1; b < bin_start_.size(); ++b) bin_start_[b] += bin_start_[b - 1];
  bin_edges_.resize(bin_start_.back());
  std::vector<std::uint32_t> next(bin_start_.begin(), bin_start_.end() - 1);
  for (std::uint32_t i = 0; i < edges_.size(); ++i) {
    const auto [low, high] = reach(edges_[i]);
    for (int b = low; b <= high; ++b) bin_edges_[next[static_cast<std::size_t>(b)]++] = i;
  }
}

void SectionField::radiiAt(double z, std::vector<double>& radii) const {
  radii.clear();
  forEachAtLevel(z, [&](int, double r) { radii.push_back(r); });
}

bool SectionField::inside(const Vec2& p) const {
  bool odd = false;
  const double radius = std::max(p.x(), kLeastRadius);
  forEachAtLevel(p.y(), [&](int, double r) { odd ^= r < radius; });
  return odd;
}

SectionField::Nearest SectionField::nearest(const Vec2& p, double most, int face) const {
  Nearest best{most, -1, p};
  double best2 = most * most;
  const auto look = [&](int bin) {
    const auto b = static_cast<std::size_t>(bin);
    for (std::uint32_t i = bin_start_[b]; i < bin_start_[b + 1]; ++i) {
      const Edge& e = edges_[bin_edges_[i]];
      if (e.on_axis || (face >= 0 && e.face != face)) continue;
      const Vec2 d = e.to - e.from;
      const double share = std::clamp(d.dot(p - e.from) / d.squaredNorm(), 0.0, 1.0);
      const Vec2 at = e.from + share * d;
      const double distance2 = (p - at).squaredNorm();
      if (distance2 >= best2) continue;
      best2 = distance2;
      best = {0.0, static_cast<int>(bin_edges_[i]), at};
    }
  };
  const auto away = [&](int bin) {  // of the bin's heights from the point
    const double low = min_.y() + bin * bin_height_;
    return std::max({0.0, low - p.y(), p.y() - (low + bin_height_)});
  };
  const int middle = binOf(p.y());
  look(middle);
  for (int below = middle - 1; below >= 0 && away(below) * away(below) < best2; --below) look(below);
  for (int above = middle + 1; above < bins_ && away(above) * away(above) < best2; ++above) look(above);
  best.distance = std::sqrt(best2);
  return best;
}

SectionField::Nearest SectionField::nearestOn(int face, const Vec2& p, double most) const {
  Nearest best = nearest(p, most, face);
  if (best.edge < 0) return best;
  const Edge& e = edge(best.edge);
  const bool before = e.first && best.point == e.from;
  if (!before && !(e.last && (best.point - e.to).norm() < 1e-12)) return best;
  const Vec2 normal = before ? e.normal_from : e.normal_to;
  best.point = p - normal * normal.dot(p - (before ? e.from : e.to));
  best.distance = (best.point - p).norm();
  return best;
}

}  // namespace proveout
