#include "core/nc/services/zone_check.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/assert.h"

namespace proveout::nc {
namespace {

/// Above the rounding of coordinates, far below the control's increment, mm.
constexpr double kSame = 1e-9;
/// Pieces of a path shorter than this, in t, are points.
constexpr double kPoint = 1e-13;
/// More pieces are needed by no path; the search then takes the place where it is for forbidden.
constexpr int kMaxPieces = 200000;

class Search {
 public:
  Search(const Zone& zone, const ZonePath& path) : zone_(zone), path_(path) {}

  std::optional<ZoneHit> run() { return look(0.0, path_.at(0.0), 1.0, path_.at(1.0)); }

 private:
  /// Whether no point between a and b is forbidden, by bounds.
  bool isFree(const AxisPoint& pa, const AxisPoint& pb, double span, ZoneHit& beyond) const {
    for (int k = 0; k < path_.count(); ++k) {
      if (!zone_.axes[static_cast<std::size_t>(k)]) continue;
      const double bulge = path_.bulge(k, span);
      const double least = std::min(pa[k], pb[k]) - bulge, most = std::max(pa[k], pb[k]) + bulge;
      if (!zone_.outside && (least > zone_.high[k] + kSame || most < zone_.low[k] - kSame)) return true;
      if (zone_.outside && (most > zone_.high[k] + kSame || least < zone_.low[k] - kSame)) {
        beyond.axis = k;
        beyond.above = most > zone_.high[k] + kSame;
        return false;
      }
    }
    return zone_.outside;
  }

  std::optional<ZoneHit> look(double a, const AxisPoint& pa, double b, const AxisPoint& pb) {
    if (auto hit = forbidden(zone_, pa, path_.count())) {
      hit->t = a;
      return hit;
    }
    PROVEOUT_ASSERT_DEAR(a <= b);
    ZoneHit here;
    if (isFree(pa, pb, b - a, here)) return std::nullopt;
    here.t = a;
    if (b - a <= kPoint || ++pieces_ > kMaxPieces) return here;
    const double middle = 0.5 * (a + b);
    const AxisPoint pm = path_.at(middle);
    if (const auto hit = look(a, pa, middle, pm)) return hit;
    return look(middle, pm, b, pb);
  }

  const Zone& zone_;
  const ZonePath& path_;
  int pieces_ = 0;
};

}  // namespace

void ZonePath::setArc(int u, int v, int w, const ArcGeometry& arc) {
  is_arc_ = true;
  arc_axes_ = {u, v, w};
  arc_ = arc;
  frame_ = arcFrame({from_[u], from_[v], from_[w]}, {to_[u], to_[v], to_[w]}, arc);
  const double sweep = std::abs(arc.sweep_rad);
  bend_ = std::max(frame_.radius_start, frame_.radius_end) * sweep * sweep +
          2.0 * std::abs(frame_.radius_end - frame_.radius_start) * sweep;
}

int ZonePath::arcIndex(int axis) const {
  if (!is_arc_) return -1;
  for (int k = 0; k < 3; ++k) {
    if (arc_axes_[static_cast<std::size_t>(k)] == axis) return k;
  }
  return -1;
}

AxisPoint ZonePath::at(double t) const {
  if (t >= 1.0) return to_;
  AxisPoint p = from_;
  for (int k = 0; k < count_; ++k) p[k] += t * (to_[k] - from_[k]);
  if (!is_arc_) return p;
  const Vec3 q = arcPoint(frame_, arc_, t);
  for (int k = 0; k < 3; ++k) p[arc_axes_[static_cast<std::size_t>(k)]] = q[k];
  return p;
}

double ZonePath::bulge(int axis, double span) const {
  const int k = arcIndex(axis);
  if (k < 0) return 0.0;
  return bend_ * std::hypot(frame_.u[k], frame_.v[k]) * span * span / 8.0;
}

std::optional<ZoneHit> forbidden(const Zone& zone, const AxisPoint& point, int count) {
  ZoneHit hit;
  for (int k = 0; k < count; ++k) {
    if (!zone.axes[static_cast<std::size_t>(k)]) continue;
    const bool above = point[k] > zone.high[k] + kSame, below = point[k] < zone.low[k] - kSame;
    if (zone.outside && (above || below)) {
      hit.axis = k;
      hit.above = above;
      return hit;
    }
    if (!zone.outside && (above || below)) return std::nullopt;
  }
  if (zone.outside || zone.axes.none()) return std::nullopt;
  return hit;
}

std::optional<ZoneHit> firstForbidden(const Zone& zone, const ZonePath& path) {
  if (zone.axes.none()) return std::nullopt;
  return Search(zone, path).run();
}

}  // namespace proveout::nc
