#include "removal/wire/section/ruled_way.h"

#include <algorithm>
#include <cmath>

#include "removal/wire/section/wire_stretch.h"

namespace proveout {
namespace {

double speedOf(const WireTrack& track) {
  if (track.sweep_rad == 0.0) return (track.to - track.from).norm();
  const double radius = (track.from - track.center).norm(), end = (track.to - track.center).norm();
  return std::max(radius, end) * std::abs(track.sweep_rad) + std::abs(end - radius);
}

}  // namespace

Vec3 RuledWay::at(double t, double z) const {
  const double w = shareOf(z);
  const Vec2 p = (1.0 - w) * pointOnTrack(wire_.lower, t) + w * pointOnTrack(wire_.upper, t);
  return {p.x(), p.y(), z};
}

double RuledWay::speed(double z_low, double z_high) const {
  if (isUpright(wire_)) return speedOf(wire_.lower) + kUprightMm;
  if (wire_.lower.sweep_rad == 0.0 && wire_.upper.sweep_rad == 0.0)
    return std::max((at(1.0, z_low) - at(0.0, z_low)).norm(), (at(1.0, z_high) - at(0.0, z_high)).norm());
  const double lower = speedOf(wire_.lower), upper = speedOf(wire_.upper);
  const auto at = [&](double z) {
    const double w = shareOf(z);
    return std::abs(1.0 - w) * lower + std::abs(w) * upper;
  };
  return std::max(at(z_low), at(z_high));
}

Box3 RuledWay::bounds(double z_low, double z_high) const {
  // Every place is within half of the way between two of the stations.
  constexpr int kStations = 16;
  Box3 box;
  for (int k = 0; k <= kStations; ++k) {
    for (const double z : {z_low, z_high}) box.extend(at(static_cast<double>(k) / kStations, z));
  }
  return box.inflated(0.5 * speed(z_low, z_high) / kStations);
}

}  // namespace proveout
