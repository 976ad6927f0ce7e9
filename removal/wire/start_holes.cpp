#include "removal/wire/start_holes.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "removal/wire/section/edge_curves.h"

namespace proveout {
namespace {

std::string nameOf(const StartHole& hole) {
  return fmt::format("the start hole of {:g} at X{:g} Y{:g}", hole.diameter, hole.at.x(), hole.at.y());
}

/// Requires that p is off all sides by more than `off` mm.
bool isInside(const std::vector<PlaneLoop>& loops, const Vec2& p, double off) {
  int around = 0;
  for (const PlaneLoop& loop : loops) around += surrounds(chordsOf(loop, 0.5 * off).points, p) ? 1 : 0;
  return around % 2 == 1;
}

Status checkBorders(const std::vector<PlaneLoop>& loops, const StartHole& hole) {
  double off = std::numeric_limits<double>::infinity();
  for (const WireStretch& side : wire_detail::sidesOf(loops))
    off = std::min(off, distanceTo(side, hole.at).mm);
  if (off <= 0.0 || !isInside(loops, hole.at, off))
    return inputError(nameOf(hole) + " is not in the stock: its middle must lie in the material");
  const double wall = off - 0.5 * hole.diameter;
  if (wall > kLeastWallMm) return Done{};
  return inputError(fmt::format(
      "{} reaches the border of the stock: its middle is {:.4g} mm from it; move it or make it smaller",
      nameOf(hole), off));
}

}  // namespace

Status addStartHoles(PrismBlank& blank, const std::vector<StartHole>& holes) {
  const std::vector<PlaneLoop> borders = blank.loops;
  for (std::size_t i = 0; i < holes.size(); ++i) {
    if (Status good = checkBorders(borders, holes[i]); !good) return good;
    for (std::size_t k = 0; k < i; ++k) {
      const double wall = (holes[i].at - holes[k].at).norm() - 0.5 * (holes[i].diameter + holes[k].diameter);
      if (wall > kLeastWallMm) continue;
      return inputError(fmt::format("{} comes to another one, {}: give one hole in place of both",
                                    nameOf(holes[i]), nameOf(holes[k])));
    }
    blank.loops.push_back(circleLoop(holes[i].at, 0.5 * holes[i].diameter, true));
  }
  return Done{};
}

}  // namespace proveout
