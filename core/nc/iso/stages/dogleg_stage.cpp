#include "core/nc/iso/stages/dogleg_stage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace proveout::nc {
namespace {

/// Shares of the whole time nearer than this are one corner.
constexpr double kSameTime = 1e-9;

}  // namespace

bool DoglegStage::push(PathItem& item) {
  const bool straight = item.kind != PathItem::Kind::kLine || !item.rapid || item.in_polar || item.pose ||
                        item.space != PathItem::Space::kMachine;
  if (straight) return pass(item);
  const AxisPoint from = emitter_.machine();
  std::array<double, kMaxAxes> minutes{}, times{};
  std::size_t count = 0;
  for (int k = 0; k < axes_.count(); ++k) {
    const double rate = k < kMainAxes ? settings_.rapid_mm_min[k] : axes_.at(k).rapid;
    const auto at = static_cast<std::size_t>(k);
    minutes[at] = std::abs(item.to[k] - from[k]) / rate;
    if (minutes[at] > 0.0) times[count++] = minutes[at];
  }
  std::sort(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(count));
  double last = 0.0;
  for (std::size_t i = 0; i + 1 < count; ++i) {
    const double time = times[i];
    if (time - last <= kSameTime * times[count - 1] ||
        times[count - 1] - time <= kSameTime * times[count - 1])
      continue;
    last = time;
    if (told_) std::exchange(told_, nullptr)();
    PathItem corner = item.copyMotion();
    for (int k = 0; k < axes_.count(); ++k) {
      const double whole = minutes[static_cast<std::size_t>(k)];
      if (whole > time) corner.to[k] = from[k] + (item.to[k] - from[k]) * (time / whole);
    }
    if (!pass(corner)) return false;
  }
  return pass(item);
}

}  // namespace proveout::nc
