#include "core/nc/flexnc/flexnc_rapid_stage.h"

#include <algorithm>
#include <cmath>

namespace proveout::nc {

namespace {

constexpr double kSamePoint = 1e-9;  ///< mm

}  // namespace

bool FlexRapidStage::push(PathItem& item) {
  // Rates that nobody has told say nothing about the way.
  if (item.kind != PathItem::Kind::kLine || !item.rapid || settings_.rapid_by_default) return pass(item);
  const Vec3 from = emitter_.machine().xyz, way = item.to.xyz - from;
  const double x_min = std::abs(way.x()) / settings_.rapid_mm_min.x();
  const double z_min = std::abs(way.z()) / settings_.rapid_mm_min.z();
  const double first = std::min(x_min, z_min);
  if (!(first > 0.0)) return pass(item);
  const Vec3 both(from.x() + way.x() * first / x_min, item.to[1], from.z() + way.z() * first / z_min);
  if ((both - item.to.xyz).norm() > kSamePoint && (both - from).norm() > kSamePoint) {
    PathItem leg = item.copyMotion();
    leg.to.xyz = both;
    if (!pass(leg)) return false;
  }
  return pass(item);
}

}  // namespace proveout::nc
