#include "core/machine/reach.h"

#include <algorithm>
#include <cmath>

#include "core/machine/machine_chain.h"

namespace proveout {

namespace {

constexpr double kStepDeg = 2.0;

std::vector<double> positionsOf(const MachineAxis& axis) {
  double low = axis.travel ? axis.travel->min : -180.0, high = axis.travel ? axis.travel->max : 180.0;
  if (high - low > 360.0) high = low + 360.0;
  std::vector<double> out;
  const int steps = std::max(1, static_cast<int>(std::ceil((high - low) / kStepDeg)));
  for (int k = 0; k <= steps; ++k) out.push_back(low + (high - low) * k / steps);
  return out;
}

}  // namespace

ToolReach toolReach(const MachineModel& model) {
  const MachineChain chain(model, Vec3::Zero());
  std::vector<std::vector<double>> positions(2, {0.0});
  std::array<int, 2> axes{-1, -1};
  const std::vector<MachineChain::Turn> turns = chain.rotaryAxes();
  for (std::size_t k = 0; k < std::min<std::size_t>(2, turns.size()); ++k) {
    axes[k] = turns[k].axis;
    positions[k] = positionsOf(model.axes[static_cast<std::size_t>(axes[k])]);
  }
  const Vec3 rest = chain.toolAxis(AxisPoint());
  ToolReach out;
  AxisPoint at;
  for (const double first : positions[0]) {
    for (const double second : positions[1]) {
      if (axes[0] >= 0) at[axes[0]] = first;
      if (axes[1] >= 0) at[axes[1]] = second;
      const Vec3 t = chain.toolAxis(at);
      out.least = out.least.cwiseMin(t);
      out.largest = out.largest.cwiseMax(t);
      out.most_tilt_deg =
          std::max(out.most_tilt_deg, radToDeg(std::acos(std::clamp(t.dot(rest), -1.0, 1.0))));
    }
  }
  return out;
}

}  // namespace proveout
