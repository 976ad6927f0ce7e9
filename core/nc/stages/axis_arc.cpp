#include "core/nc/stages/axis_arc.h"

#include <cmath>

#include "core/nc/services/virtual_plane.h"

namespace proveout::nc {

AxisArc::AxisArc(const AxisPoint& from, const AxisPoint& to, const MachineArc& arc)
    : from_(from),
      to_(to),
      arc_(arc),
      main_(arc.plane.u < kMainAxes && arc.plane.v < kMainAxes),
      space_{arc.center, arc.normal, arc.sweep_rad},
      from_uv_(from[arc.plane.u], from[arc.plane.v]),
      to_uv_(to[arc.plane.u], to[arc.plane.v]) {
  if (main_) frame_ = arcFrame(from.xyz, to.xyz, space_);
}

AxisPoint AxisArc::at(double share) const {
  AxisPoint p = between(from_, to_, share);
  if (share >= 1.0) return p;
  if (main_) {
    p.xyz = arcPoint(frame_, space_, share);
  } else {
    const Vec2 uv = pointOfArc(from_uv_, to_uv_, arc_.center.head<2>(), arc_.sweep_rad, share);
    p[arc_.plane.u] = uv.x();
    p[arc_.plane.v] = uv.y();
  }
  return p;
}

double AxisArc::pacedLength(const FeedStyle& style, int axes, const AxisSet& apart) const {
  const Vec2 center = arc_.center.head<2>();
  const double r0 = main_ ? frame_.radius_start : (from_uv_ - center).norm();
  const double r1 = main_ ? frame_.radius_end : (to_uv_ - center).norm();
  if (style.along == FeedStyle::Along::kPlane) return arcLength(r0, r1, arc_.sweep_rad, 0.0);
  if (style.along == FeedStyle::Along::kStartRadius && r0 > 0.0) return r0 * std::abs(arc_.sweep_rad);
  double rise2 = main_ ? frame_.rise * frame_.rise : 0.0;
  for (int k = main_ ? kMainAxes : 0; k < axes; ++k) {
    if (k == arc_.plane.u || k == arc_.plane.v || apart.test(static_cast<std::size_t>(k))) continue;
    rise2 += (to_[k] - from_[k]) * (to_[k] - from_[k]);
  }
  return arcLength(r0, r1, arc_.sweep_rad, std::sqrt(rise2));
}

}  // namespace proveout::nc
