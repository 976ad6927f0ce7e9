// A worm of several starts, cut with a round insert pass by pass, and what must be left of its blank.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/unit/turning/turning_fixture.h"

namespace proveout::test {

/// The groove's section is an arc of `depth` about a centre on the bar's surface. The centre of the insert is
/// led over it in layers, and in each layer across the width. Lengths mm.
struct Worm {
  int starts = 4;
  double bar = 20.0;    ///< radius of the blank
  double depth = 3.0;   ///< of the groove: radius of its section
  double insert = 1.0;  ///< radius
  double lead = 40.0;
  double layer = 0.25, step = 0.25;  ///< from layer to layer, across a layer: at most
  double front = 10.0,
         end = -60.0;  ///< z of the insert's centre at both ends of a pass in the groove's middle

  /// Centres of the insert in the order of the passes, seen from the groove's centre: (r, z), r <= 0.
  std::vector<Vec2> centers() const {
    const double reach = depth - insert;
    std::vector<Vec2> all;
    const int layers = std::max(1, static_cast<int>(std::ceil(reach / layer - 1e-9)));
    for (int i = 0; i <= layers; ++i) {
      const double down = reach * i / layers, half = std::sqrt(std::max(0.0, reach * reach - down * down));
      const int steps = static_cast<int>(std::ceil(2.0 * half / step - 1e-9));
      for (int k = 0; k <= steps; ++k)
        all.emplace_back(-down, steps == 0 ? 0.0 : half * (2.0 * k / steps - 1.0));
    }
    return all;
  }
  int passes() const { return starts * static_cast<int>(centers().size()); }

  Tool tool() const {
    Insert round;
    round.shape = InsertShape::kRound;
    round.orientation = 8;
    round.at_center = true;
    round.nose_radius = insert;
    return insertTool(1, round);
  }

  /// Every pass begins in front of the bar at the phase of its start, and the insert leaves straight outwards
  /// where it ends.
  TurningPath path() const {
    const double clear = bar + 10.0;
    TurningPath path({clear, front});
    for (int j = 0; j < starts; ++j) {
      for (const Vec2& center : centers()) {
        const double r = bar + center.x();
        path.rapid(clear, front + center.y()).rapid(r, front + center.y());
        path.thread(r, end + center.y(), (front - end) / lead, 360.0 * j / starts);
        path.rapid(clear, end + center.y());
      }
    }
    return path;
  }
};

}  // namespace proveout::test
