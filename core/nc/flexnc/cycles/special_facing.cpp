// G79 and G5 (digest flexnc, 10.4 and 10.5).
#include <fmt/core.h>

#include <algorithm>

#include "core/nc/flexnc/cycles/cycle_checks.h"
#include "core/nc/flexnc/cycles/cycle_moves.h"
#include "core/nc/flexnc/cycles/special_cycles.h"

namespace proveout::nc {

namespace {

using Role = CycleMove::Role;

std::optional<CycleNote> checkFacing(const CycleCall& call) {
  const CycleArguments& a = call.arguments;
  const auto diameters = [&]() -> std::optional<CycleNote> {
    if (a.value('Y') < a.value('X')) return std::nullopt;
    return CycleNote{"fnc-x-le-a", fmt::format("G79: X{:g}, where the passes begin, has to be above Y{:g}",
                                               a.value('X'), a.value('Y'))};
  };
  const auto side = [&]() -> std::optional<CycleNote> {
    if (a.value('C') > 0.0) return std::nullopt;
    return CycleNote{"fnc-c-sign", "G79: C has to be above 0, the passes begin outside"};
  };
  return firstNote(
      side, [&] { return checkSigns(call.code, a, "XZPB", "Y"); }, diameters,
      [&] { return checkPasses(call.code, a.value('Z') / a.value('P'), "P"); });
}

std::optional<CycleNote> checkDrilling(const CycleCall& call) {
  const CycleArguments& a = call.arguments;
  const auto clearance = [&]() -> std::optional<CycleNote> {
    if (a.value('Y') < a.value('P')) return std::nullopt;
    return CycleNote{"fnc-param-sign", fmt::format("G5: Y{:g}, the way to stop before the bottom, has to be "
                                                   "below the depth P{:g}",
                                                   a.value('Y'), a.value('P'))};
  };
  return firstNote([&] { return checkSigns(call.code, a, "ZPB", "YV"); }, clearance,
                   [&] { return checkPasses(call.code, a.value('Z') / a.value('P'), "P"); });
}

}  // namespace

void faceEnd(const CycleCall& call, CycleAnswer& answer) {
  answer.alarm = checkFacing(call);
  if (answer.alarm) return;
  const CycleArguments& a = call.arguments;
  const double allowance = a.value('Z'), depth = a.value('P'), clearance = a.value('B');
  const double outside = 0.5 * a.value('X') + a.value('C'), inside = 0.5 * a.value('Y');
  CycleMoves moves(call.at);
  moves.rapidTo(Vec2(allowance + clearance, outside), Role::kApproach);
  const double passes = stepsOver(allowance, depth);
  for (double k = 1.0; k <= passes; k += 1.0) {
    moves.beginPass();
    moves.feedToZ(k < passes ? allowance - k * depth : 0.0, Role::kInfeed);
    moves.feedToR(inside, Role::kPass);
    moves.feedToZ(moves.at().x() + clearance, Role::kRetract);
    moves.rapidToR(outside, Role::kRetract);
  }
  answer.passes = moves.pass();
  moves.endPass();
  moves.rapidToZ(allowance + clearance, Role::kReturn);
  answer.moves = moves.take();
}

void drillDeep(const CycleCall& call, CycleAnswer& answer) {
  answer.alarm = checkDrilling(call);
  if (answer.alarm) return;
  const CycleArguments& a = call.arguments;
  const double face = -a.value('V'), depth = a.value('Z'), peck = a.value('P');
  const double start = face + a.value('B');
  CycleMoves moves(call.at);
  moves.rapidTo(Vec2(start, 0.0), Role::kApproach);
  const double pecks = stepsOver(depth, peck);
  for (double k = 1.0; k <= pecks; k += 1.0) {
    moves.beginPass();
    if (k > 1.0) moves.rapidToZ(face - ((k - 1.0) * peck - a.value('Y')), Role::kInfeed);
    moves.feedToZ(face - std::min(k * peck, depth), Role::kPass);
    moves.rapidToZ(start, k < pecks ? Role::kRetract : Role::kReturn);
  }
  answer.passes = moves.pass();
  answer.moves = moves.take();
}

}  // namespace proveout::nc
