// Paths of the wire EDM control for tests: run a text, look at the tracks.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "control_path.h"

namespace proveout::test {

struct WedmPath : ControlPath {
  explicit WedmPath(const std::string& text, const ControlSettings& settings = {})
      : ControlPath(ControlId::kWedm, text, settings) {}
  const WireSweep& wire(std::size_t k) const {
    return path.wires.at(static_cast<std::size_t>(path.motions.at(k).wire));
  }
  /// Where the lower, or the upper, track ends.
  std::vector<Vec2> ends(bool upper = false) const {
    std::vector<Vec2> points;
    for (std::size_t k = 0; k < count(); ++k) points.push_back(upper ? wire(k).upper.to : wire(k).lower.to);
    return points;
  }
};

inline double wireTrackLength(const WireTrack& t) {
  return t.sweep_rad == 0.0 ? (t.to - t.from).norm() : (t.from - t.center).norm() * std::abs(t.sweep_rad);
}
inline Vec2 wireTrackPoint(const WireTrack& t, double f) {
  if (t.sweep_rad == 0.0) return t.from + f * (t.to - t.from);
  const Vec2 arm = t.from - t.center;
  const double c = std::cos(f * t.sweep_rad), s = std::sin(f * t.sweep_rad);
  return t.center + Vec2(c * arm.x() - s * arm.y(), s * arm.x() + c * arm.y());
}

}  // namespace proveout::test
