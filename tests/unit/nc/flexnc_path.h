// Paths of the FlexNC control for tests.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "control_path.h"

namespace proveout::test {

/// Tool, spindle and feed, three lines.
inline const std::string kStart = "T1M06D1\nS300M03\nG98F100\n";

struct FlexncPath : ControlPath {
  /// With a start that no test runs into, (x, z) = (100, 50).
  explicit FlexncPath(const std::string& text, ControlSettings settings = {})
      : ControlPath(ControlId::kFlexNc, text, started(std::move(settings))) {}

  const Motion& motion(std::size_t k) const { return path.motions.at(k); }
  /// (x, z) of the end of a motion.
  Vec2 end(std::size_t k) const { return {motion(k).to.x(), motion(k).to.z()}; }
  std::vector<Vec2> ends() const {
    std::vector<Vec2> points;
    for (std::size_t k = 0; k < count(); ++k) points.push_back(end(k));
    return points;
  }
  /// The events of a kind, in their order.
  template <class Kind>
  std::vector<Kind> events() const {
    std::vector<Kind> found;
    for (const Toolpath::EventAt& at : path.events) {
      if (const Kind* kind = at.event.as<Kind>()) found.push_back(*kind);
    }
    return found;
  }

 private:
  static ControlSettings started(ControlSettings settings) {
    settings.start = Vec3(100.0, 0.0, 50.0);
    return settings;
  }
};

}  // namespace proveout::test
