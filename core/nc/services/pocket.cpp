#include "core/nc/services/pocket.h"

#include <algorithm>
#include <cmath>

namespace proveout {
namespace {

PocketLayout failed(PocketError error, const char* reason) {
  PocketLayout layout;
  layout.error = error;
  layout.reason = reason;
  return layout;
}

/// Equal steps of at most `step` that make up `whole`; a last step that is a rounding error does not count.
std::int64_t stepsOf(double whole, double step) {
  constexpr double kRounding = 1e-9;
  const double steps = std::ceil(whole / step - kRounding);
  if (!(steps <= static_cast<double>(kMaxPocketSteps))) return -1;
  return std::max<std::int64_t>(0, static_cast<std::int64_t>(steps));
}

struct Sides {
  double length = 0.0, width = 0.0;
  bool length_is_first = true;
};

/// The special cases of missing sizes (manual 23.6).
Sides sidesOf(const PocketRequest& r, double diameter) {
  if (r.first && r.second) {
    const double a = std::abs(*r.first), b = std::abs(*r.second);
    return {std::max(a, b), std::min(a, b), a >= b};
  }
  const double across = r.corner ? 2.0 * std::abs(*r.corner) : diameter;
  if (!r.first && !r.second) return {across, across, true};
  return {std::abs(r.first ? *r.first : *r.second), across, r.first.has_value()};
}

}  // namespace

PocketLayout layOutPocket(const PocketRequest& r) {
  constexpr double kFit = 1e-9;
  const auto missing = [](const char* what) { return failed(PocketError::kMissing, what); };
  const auto wrong = [](const char* what) { return failed(PocketError::kWrongSize, what); };
  if (!r.depth || *r.depth == 0.0) return missing("the depth of the pocket is not given");
  if (!r.tool_radius) return missing("the tool radius (D) is not given");
  if (!r.cut) return missing("the depth of cut (Q) is not given");
  if (!(*r.tool_radius > 0.0)) return wrong("the diameter of the tool is 0");
  if (*r.cut == 0.0) return wrong("the depth of cut (Q) is 0");
  if (r.width_percent == 0.0) return wrong("the cutting width (E) is 0");
  const double radius = *r.tool_radius, diameter = 2.0 * radius;
  const Sides sides = sidesOf(r, diameter);
  const double corner = r.corner ? std::abs(*r.corner) : 0.0;
  if (sides.width < 2.0 * corner - kFit || sides.length < 2.0 * corner - kFit)
    return wrong("length or width are smaller than twice the corner radius (R)");
  if (sides.width < diameter - kFit || sides.length < diameter - kFit)
    return wrong("length or width are smaller than the diameter of the tool");

  PocketLayout layout;
  layout.length_is_first = sides.length_is_first;
  layout.clockwise = r.width_percent < 0.0;
  const double depth = std::abs(*r.depth);
  layout.levels = stepsOf(depth, std::abs(*r.cut));
  const double reach = std::max(0.0, sides.width / 2.0 - radius);
  layout.rings = stepsOf(reach, std::abs(r.width_percent) / 100.0 * diameter);
  if (layout.levels < 1 || layout.rings < 0) return wrong("the steps are too many: Q or E is too small");
  layout.level_step = depth / static_cast<double>(layout.levels);
  layout.ring_step = layout.rings == 0 ? 0.0 : reach / static_cast<double>(layout.rings);
  layout.core = std::max(0.0, (sides.length - sides.width) / 2.0);
  layout.outer_corner = std::max(corner, radius) - radius;
  return layout;
}

}  // namespace proveout
