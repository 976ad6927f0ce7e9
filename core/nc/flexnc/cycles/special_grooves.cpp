// G79.1 and G79.2 (digest flexnc, 10.6 and 10.7): layers of plunges side by side.
#include <fmt/core.h>

#include <algorithm>
#include <vector>

#include "core/nc/flexnc/cycles/cycle_checks.h"
#include "core/nc/flexnc/cycles/cycle_moves.h"
#include "core/nc/flexnc/cycles/special_cycles.h"

namespace proveout::nc {

namespace {

using Role = CycleMove::Role;

constexpr double kSameWidth = 1e-9;  ///< mm

/// What both grooves have: a width that a tool steps over, and a depth that it goes down.
struct GrooveSize {
  double width, depth;
};

std::optional<CycleNote> checkGroove(const CycleCall& call, const GrooveSize& size) {
  const CycleArguments& a = call.arguments;
  const double tool = a.value('H'), overlap = a.value('Q'), x = a.value('X');
  const std::string name = cycleName(call.code);
  const auto diameters = [&]() -> std::optional<CycleNote> {
    if (a.value('A') < x) return std::nullopt;
    return CycleNote{"fnc-x-le-a", fmt::format("{}: A{:g}, the inner diameter, has to be below X{:g}", name,
                                               a.value('A'), x)};
  };
  const auto widths = [&]() -> std::optional<CycleNote> {
    if (tool <= size.width + kSameWidth) return std::nullopt;
    return CycleNote{
        "fnc-groove-width",
        fmt::format("{}: the tool, H{:g}, is wider than the groove of {:g} mm", name, tool, size.width)};
  };
  const auto steps = [&]() -> std::optional<CycleNote> {
    if (overlap <= 1.0) return std::nullopt;
    return CycleNote{"fnc-param-sign", fmt::format("{}: Q{:g} steps over more than the width of the tool and "
                                                   "leaves ridges: at most 1",
                                                   name, overlap)};
  };
  const auto passes = [&] {
    return checkPasses(call.code, size.depth / a.value('P') * (1.0 + size.width / (tool * overlap)),
                       "P, H and Q");
  };
  return firstNote(diameters, widths, steps, passes);
}

/// Steps from 0 to `way`, the last one shorter.
std::vector<double> stepsTo(double way, double step) {
  std::vector<double> steps = {0.0};
  const double count = stepsOver(way, step);
  for (double k = 1.0; k <= count; k += 1.0) steps.push_back(std::min(k * step, way));
  return steps;
}

/// Layer by layer, plunge by plunge. `position(width, depth)`: where the working point is; depth below 0 is
/// the height of the start over the groove.
template <typename Position>
void plunge(const CycleCall& call, const GrooveSize& size, double clearance, const Position& position,
            CycleAnswer& answer) {
  const CycleArguments& a = call.arguments;
  const double depth = a.value('P'), layers = stepsOver(size.depth, depth);
  const std::vector<double> steps = stepsTo(size.width - a.value('H'), a.value('H') * a.value('Q'));
  CycleMoves moves(call.at);
  moves.rapidTo(position(0.0, -clearance), Role::kApproach);
  for (double layer = 1.0; layer <= layers; layer += 1.0) {
    for (const double step : steps) {
      moves.beginPass();
      moves.rapidTo(position(step, -clearance), Role::kInfeed);
      moves.feedTo(position(step, std::min(layer * depth, size.depth)), Role::kPass);
      moves.rapidTo(position(step, -clearance), Role::kRetract);
    }
  }
  answer.passes = moves.pass();
  moves.endPass();
  moves.rapidTo(position(0.0, -clearance), Role::kReturn);
  answer.moves = moves.take();
}

}  // namespace

void cutRadialGroove(const CycleCall& call, CycleAnswer& answer) {
  const CycleArguments& a = call.arguments;
  const double outside = 0.5 * a.value('X'), wall = -(a.value('V') + a.value('H'));
  const GrooveSize size{a.value('Y'), outside - 0.5 * a.value('A')};
  const auto side = [&]() -> std::optional<CycleNote> {
    if (a.value('C') > 0.0) return std::nullopt;
    return CycleNote{"fnc-c-sign", "G79.1: C has to be above 0, the groove is cut from outside"};
  };
  answer.alarm = firstNote(
      side, [&] { return checkSigns(call.code, a, "XAHPYQ", "V"); }, [&] { return checkGroove(call, size); });
  if (answer.alarm) return;
  const auto position = [&](double width, double depth) { return Vec2(wall - width, outside - depth); };
  plunge(call, size, a.value('C'), position, answer);
}

void cutFaceGroove(const CycleCall& call, CycleAnswer& answer) {
  const CycleArguments& a = call.arguments;
  const double inside = 0.5 * a.value('A'), face = -a.value('V');
  const GrooveSize size{0.5 * a.value('X') - inside, a.value('Z')};
  answer.alarm = firstNote([&] { return checkSigns(call.code, a, "XAZPBHQ", "V"); },
                           [&] { return checkGroove(call, size); });
  if (answer.alarm) return;
  const auto position = [&](double width, double depth) { return Vec2(face - depth, inside + width); };
  plunge(call, size, a.value('B'), position, answer);
}

}  // namespace proveout::nc
