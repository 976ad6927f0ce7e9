// G30 (digest flexnc, 10.9): a worm whose groove has a round section, on K helices.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/nc/flexnc/cycles/cycle_checks.h"
#include "core/nc/flexnc/cycles/cycle_moves.h"
#include "core/nc/flexnc/cycles/special_cycles.h"

namespace proveout::nc {

namespace {

using Role = CycleMove::Role;

constexpr double kSameDepth = 0.001;  ///< mm
constexpr double kMostStarts = 1000.0;

/// Radii, unless a name says otherwise.
struct Worm {
  double inner, outer;        ///< of bottom and crest
  double groove, tool;        ///< of the section of the groove, of the tool
  double length, lead, step;  ///< Z, F, H
  double depth;               ///< of a layer
  double start_r, start_z;
  double starts;
};

Worm wormOf(const CycleArguments& a) {
  return {.inner = 0.5 * a.value('A'),
          .outer = 0.5 * a.value('X'),
          .groove = a.value('R'),
          .tool = a.value('Q'),
          .length = a.value('Z'),
          .lead = a.value('F'),
          .step = a.value('H'),
          .depth = a.value('P'),
          .start_r = 0.5 * a.value('U'),
          .start_z = a.value('L'),
          .starts = a.value('K')};
}

/// How far to both sides of the groove's middle the tool goes where its lowest point is at radius `bottom`.
double halfWidth(const Worm& w, double bottom) {
  const double reach = w.groove - w.tool;
  const double above = std::min(bottom + w.tool - (w.inner + w.groove), 0.0);
  return std::sqrt(std::max(reach * reach - above * above, 0.0));
}

std::optional<CycleNote> checkWormSizes(const Worm& w) {
  if (w.tool > w.groove) {
    return CycleNote{"fnc-groove-width",
                     fmt::format("G30: the tool's radius Q{:g} does not fit into the groove of radius R{:g}",
                                 w.tool, w.groove)};
  }
  if (!(w.inner < w.outer)) {
    return CycleNote{"fnc-x-le-a", "G30: A, the inner diameter, has to be below X, the outer one"};
  }
  if (!(w.start_r > w.outer)) {
    return CycleNote{"fnc-x-le-a", fmt::format("G30: U{:g}, the diameter to go back on, has to be above the "
                                               "outer diameter X{:g}",
                                               2.0 * w.start_r, 2.0 * w.outer)};
  }
  if (w.starts != std::floor(w.starts) || w.starts > kMostStarts) {
    return CycleNote{"fnc-num",
                     fmt::format("G30: K{:g}, the number of starts, has to be a whole number of at "
                                 "most {:g}",
                                 w.starts, kMostStarts)};
  }
  return std::nullopt;
}

std::optional<CycleNote> checkWorm(const CycleCall& call, const Worm& w) {
  return firstNote([&] { return checkSigns(call.code, call.arguments, "AXZRQFHPUK", "L"); },
                   [&] { return checkWormSizes(w); },
                   [&] {
                     const double layers = stepsOver(w.outer - w.inner, w.depth);
                     return checkPasses(call.code,
                                        w.starts * layers * (1.0 + 2.0 * (w.groove - w.tool) / w.step),
                                        "K, P and H");
                   });
}

void warnOfWorm(const Worm& w, CycleAnswer& answer) {
  if (std::abs(w.outer - w.inner - w.groove) > kSameDepth) {
    answer.warnings.push_back(
        {"fnc-worm", fmt::format("G30: A{:g} and X{:g} are {:.3f} mm apart, R{:g} says a depth of that: the "
                                 "groove has radius R and its bottom at A",
                                 2.0 * w.inner, 2.0 * w.outer, w.outer - w.inner, w.groove)});
  }
}

/// Scans across the width of one layer of one start. All have the same way and turn, beside each other along
/// Z; the one that is nearest to the chuck begins at L, so that none begins in the bar.
void cutWormLayer(const Worm& w, double bottom, double turn, CycleMoves& moves) {
  const double half = halfWidth(w, bottom), scans = stepsOver(2.0 * half, w.step);
  for (double k = 0.0; k <= scans; k += 1.0) {
    const double across = std::min(-half + k * w.step, half);
    moves.beginPass();
    moves.rapidToZ(w.start_z + (w.groove - w.tool) + across, Role::kInfeed);
    moves.rapidToR(bottom, Role::kInfeed);
    moves.threadTo(Vec2(across - w.length, bottom), w.lead, turn, Role::kPass);
    moves.rapidToR(w.start_r, Role::kRetract);
    moves.rapidToZ(w.start_z, Role::kRetract);
  }
}

}  // namespace

void cutWorm(const CycleCall& call, CycleAnswer& answer) {
  const Worm worm = wormOf(call.arguments);
  answer.alarm = checkWorm(call, worm);
  if (answer.alarm) return;
  warnOfWorm(worm, answer);
  CycleMoves moves(call.at);
  moves.rapidTo(Vec2(worm.start_z, worm.start_r), Role::kApproach);
  const double layers = stepsOver(worm.outer - worm.inner, worm.depth);
  for (double start = 0.0; start < worm.starts; start += 1.0) {
    for (double layer = 1.0; layer <= layers; layer += 1.0) {
      const double bottom = std::max(worm.outer - layer * worm.depth, worm.inner);
      cutWormLayer(worm, bottom, start / worm.starts, moves);
    }
  }
  answer.passes = moves.pass();
  answer.moves = moves.take();
}

}  // namespace proveout::nc
