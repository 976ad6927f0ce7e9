#include "removal/wire/section/face_triangles.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/assert.h"
#include "core/geometry/plane.h"

namespace proveout {
namespace {

/// A ring of corners from which ears are cut. A corner at the end of a bridge is in it twice.
class Ring {
 public:
  explicit Ring(const std::vector<std::vector<Vec2>>& loops) {
    std::vector<std::uint32_t> hollows;
    std::uint32_t first = kNone;
    PROVEOUT_ASSERT(!loops.empty());
    for (const std::vector<Vec2>& loop : loops) {
      const std::uint32_t start = addLoop(loop);
      if (first == kNone)
        first = start;
      else
        hollows.push_back(leftmost(start));
    }
    start_ = first;
    // From the left, so that a bridge to the left meets only what is joined already.
    std::sort(hollows.begin(), hollows.end(), [&](std::uint32_t a, std::uint32_t b) {
      return at_[a].x() != at_[b].x() ? at_[a].x() < at_[b].x() : a < b;
    });
    for (const std::uint32_t hollow : hollows) bridge(hollow);
    count_ = at_.size();
    findReflex();
  }

  std::vector<std::array<std::uint32_t, 3>> cut() {
    std::vector<std::array<std::uint32_t, 3>> out;
    out.reserve(count_);
    std::uint32_t at = start_;
    std::size_t tried = 0;
    int allowed = 0;  // what an ear may be: empty; flat and empty; anything
    while (count_ > 3) {
      const std::uint32_t next = next_[at];
      if (!isEar(at, allowed)) {
        at = next;
        if (++tried > count_) {
          tried = 0;
          allowed = std::min(allowed + 1, 2);
        }
        continue;
      }
      out.push_back({corner_[prev_[at]], corner_[at], corner_[next]});
      remove(at);
      // Not the neighbour: fans of thin triangles would come of it.
      at = next_[next];
      tried = 0;
      allowed = 0;
    }
    PROVEOUT_ASSERT(out.size() + 3 == at_.size());  // ears of all corners but those of the last triangle
    out.push_back({corner_[prev_[at]], corner_[at], corner_[next_[at]]});
    return out;
  }

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

  std::uint32_t add(const Vec2& p, std::uint32_t corner) {
    at_.push_back(p);
    corner_.push_back(corner);
    next_.push_back(kNone);
    prev_.push_back(kNone);
    return static_cast<std::uint32_t>(at_.size() - 1);
  }
  void link(std::uint32_t a, std::uint32_t b) {
    next_[a] = b;
    prev_[b] = a;
  }
  std::uint32_t addLoop(const std::vector<Vec2>& loop) {
    PROVEOUT_ASSERT(loop.size() >= 3);
    const auto start = static_cast<std::uint32_t>(at_.size());
    for (const Vec2& p : loop) {
      const std::uint32_t v = add(p, corners_++);
      if (v > start) link(v - 1, v);
    }
    link(static_cast<std::uint32_t>(at_.size() - 1), start);
    return start;
  }
  std::uint32_t leftmost(std::uint32_t start) const {
    std::uint32_t best = start;
    for (std::uint32_t v = next_[start]; v != start; v = next_[v]) {
      const Vec2 &p = at_[v], &q = at_[best];
      if (p.x() < q.x() || (p.x() == q.x() && p.y() < q.y())) best = v;
    }
    return best;
  }

  double area(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return cross2(at_[b] - at_[a], at_[c] - at_[a]);
  }
  bool inTriangle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& p) const {
    return cross2(b - a, p - a) >= 0.0 && cross2(c - b, p - b) >= 0.0 && cross2(a - c, p - c) >= 0.0;
  }

  /// Whether p lies within the angle of the ring at v.
  bool sees(std::uint32_t v, const Vec2& p) const {
    const Vec2 &a = at_[prev_[v]], &b = at_[v], &c = at_[next_[v]];
    const bool after = cross2(c - b, p - b) >= 0.0, before = cross2(b - a, p - b) >= 0.0;
    return area(prev_[v], v, next_[v]) > 0.0 ? after && before : after || before;
  }

  /// The corner to which a bridge from the leftmost corner of a hollow may go: an end of the edge to its
  /// left, or what stands in between.
  std::uint32_t bridgeEnd(std::uint32_t hollow) const {
    const Vec2 h = at_[hollow];
    double nearest = -std::numeric_limits<double>::infinity();
    std::uint32_t end = kNone, v = start_;
    do {
      const Vec2 &p = at_[v], &q = at_[next_[v]];
      // Material is on the left of the edges: those left of the hollow go down.
      if (p.y() >= h.y() && q.y() <= h.y() && p.y() != q.y()) {
        const double x = p.x() + (h.y() - p.y()) / (q.y() - p.y()) * (q.x() - p.x());
        if (x <= h.x() && x > nearest) {
          nearest = x;
          end = p.x() < q.x() ? v : next_[v];
        }
      }
      v = next_[v];
    } while (v != start_);
    if (end == kNone) return start_;
    return standingBetween(h, Vec2(nearest, h.y()), end);
  }

  /// Of the corners in the triangle between hollow, the point on the edge and its end: the one nearest in
  /// angle.
  std::uint32_t standingBetween(const Vec2& h, const Vec2& on_edge, std::uint32_t end) const {
    const Vec2 m = at_[end];
    const bool above = m.y() > h.y();
    const Vec2 &a = above ? on_edge : m, &b = h, &c = above ? m : on_edge;
    double flattest = std::numeric_limits<double>::infinity();
    std::uint32_t best = end, v = end;
    do {
      const Vec2& p = at_[v];
      if (p.x() < h.x() && p.x() >= std::min(m.x(), on_edge.x()) && inTriangle(a, b, c, p) && sees(v, h)) {
        const double slope = std::abs(h.y() - p.y()) / (h.x() - p.x());
        if (slope < flattest || (slope == flattest && p.x() > at_[best].x())) {
          flattest = slope;
          best = v;
        }
      }
      v = next_[v];
    } while (v != end);
    return best;
  }

  void bridge(std::uint32_t hollow) {
    const std::uint32_t end = bridgeEnd(hollow);
    const std::uint32_t end2 = add(at_[end], corner_[end]), hollow2 = add(at_[hollow], corner_[hollow]);
    const std::uint32_t behind_end = next_[end], before_hollow = prev_[hollow];
    link(end, hollow);
    link(before_hollow, hollow2);
    link(hollow2, end2);
    link(end2, behind_end);
  }

  /// Only corners where the ring does not turn left can lie in an ear, and no other becomes one; they are
  /// kept in cells.
  void findReflex() {
    Vec2 high = at_.front();
    low_ = at_.front();
    for (const Vec2& p : at_) {
      low_ = low_.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    const Vec2 size = (high - low_).cwiseMax(1e-9);
    const double cell = std::sqrt(size.x() * size.y() / static_cast<double>(at_.size()));
    columns_ = std::clamp(static_cast<int>(size.x() / cell), 1, kMostCells);
    rows_ = std::clamp(static_cast<int>(size.y() / cell), 1, kMostCells);
    per_mm_ = Vec2(columns_ / size.x(), rows_ / size.y());
    cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for (std::uint32_t v = 0; v < at_.size(); ++v) {
      if (area(prev_[v], v, next_[v]) <= 0.0) cells_[cellOf(at_[v])].push_back(v);
    }
  }
  int column(double x) const {
    return std::clamp(static_cast<int>((x - low_.x()) * per_mm_.x()), 0, columns_ - 1);
  }
  int row(double y) const { return std::clamp(static_cast<int>((y - low_.y()) * per_mm_.y()), 0, rows_ - 1); }
  std::size_t cellOf(const Vec2& p) const {
    return static_cast<std::size_t>(row(p.y())) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column(p.x()));
  }

  bool isEar(std::uint32_t v, int allowed) {
    if (allowed == 2) return true;
    const Vec2 &a = at_[prev_[v]], &b = at_[v], &c = at_[next_[v]];
    const double twice = cross2(b - a, c - a);
    if (allowed == 0 ? twice <= 0.0 : twice < 0.0) return false;
    const Vec2 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    for (int y = row(low.y()); y <= row(high.y()); ++y) {
      for (int x = column(low.x()); x <= column(high.x()); ++x) {
        if (blocked(cells_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
                           static_cast<std::size_t>(x)],
                    a, b, c))
          return false;
      }
    }
    return true;
  }
  /// Forgets corners that are cut off or turn left by now.
  bool blocked(std::vector<std::uint32_t>& cell, const Vec2& a, const Vec2& b, const Vec2& c) {
    for (std::size_t i = 0; i < cell.size();) {
      const std::uint32_t v = cell[i];
      if (next_[v] == kNone || area(prev_[v], v, next_[v]) > 0.0) {
        cell[i] = cell.back();
        cell.pop_back();
        continue;
      }
      const Vec2& p = at_[v];
      if (p != a && p != b && p != c && inTriangle(a, b, c, p)) return true;
      ++i;
    }
    return false;
  }

  void remove(std::uint32_t v) {
    link(prev_[v], next_[v]);
    next_[v] = kNone;
    --count_;
  }

  static constexpr int kMostCells = 1024;
  std::vector<Vec2> at_;
  std::vector<std::uint32_t> corner_, next_, prev_;
  std::vector<std::vector<std::uint32_t>> cells_;
  Vec2 low_ = Vec2::Zero(), per_mm_ = Vec2::Zero();
  int columns_ = 1, rows_ = 1;
  std::uint32_t start_ = kNone, corners_ = 0;
  std::size_t count_ = 0;
};

}  // namespace

std::vector<std::array<std::uint32_t, 3>> faceTriangles(const std::vector<std::vector<Vec2>>& loops) {
  return Ring(loops).cut();
}

}  // namespace proveout
