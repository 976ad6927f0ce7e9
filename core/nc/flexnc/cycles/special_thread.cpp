// G76 (digest flexnc, 10.8): a data block, and a block that cuts.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/geometry/types.h"
#include "core/nc/flexnc/cycles/cycle_checks.h"
#include "core/nc/flexnc/cycles/cycle_moves.h"
#include "core/nc/flexnc/cycles/special_cycles.h"

namespace proveout::nc {

namespace {

using Role = CycleMove::Role;

/// P of the data block is LLNNHH: spring passes, run-out in tenths of the pitch, angle of the tool.
void keepThreadData(const CycleCall& call, CycleAnswer& answer) {
  const CycleArguments& a = call.arguments;
  const double digits = a.value('P');
  answer.alarm = firstNote([&] { return checkLetters(call.code, a, "PQR", ""); },
                           [&] { return checkSigns(call.code, a, "Q", "PR"); });
  if (answer.alarm) return;
  if (digits != std::floor(digits) || digits > 999999.0) {
    answer.alarm =
        CycleNote{"fnc-num", fmt::format("G76: P{:g} has to be six digits: finishing passes, run-out "
                                         "in tenths of the pitch, angle of the tool",
                                         digits)};
    return;
  }
  const int fields = static_cast<int>(digits);
  answer.thread = ThreadData{.spring_passes = fields / 10000,
                             .run_out = fields / 100 % 100 / 10.0,
                             .angle_deg = static_cast<double>(fields % 100),
                             .second_depth = a.value('Q')};
  if (a.value('R') != 0.0) {
    answer.warnings.push_back(
        {"fnc-param-sign", "G76: R of the data block is not described: it has no effect, R0"});
  }
}

/// A thread that is to be cut.
struct ThreadCut {
  double start_z, start_r;  ///< where it is cut from
  double end_z, end_r;      ///< end and nominal radius; the major one
  double side;              ///< +1 outside, -1 inside
  double depth, first;      ///< radial; of the thread, of the first pass
  double taper;             ///< radius at the end less that at the start
  double lead, run_out;     ///< mm
};

/// How often a pass of equal section goes into the depth; without the passes at full depth.
double infeeds(const ThreadCut& t, const ThreadData& data) {
  if (t.first >= t.depth) return 1.0;
  const double second = t.first + data.second_depth;
  const double growth = second * second - t.first * t.first;
  return 1.0 + stepsOver(t.depth * t.depth - t.first * t.first, growth);
}

/// Depths of all passes: the squares grow evenly, so that each pass takes less than the one before.
std::vector<double> threadDepths(const ThreadCut& t, const ThreadData& data) {
  const double second = t.first + data.second_depth;
  const double growth = second * second - t.first * t.first, count = infeeds(t, data);
  std::vector<double> depths;
  for (double k = 0.0; k < count - 1.0; k += 1.0) depths.push_back(std::sqrt(t.first * t.first + k * growth));
  depths.insert(depths.end(), static_cast<std::size_t>(data.spring_passes) + 1, t.depth);
  return depths;
}

std::optional<CycleNote> checkThread(const CycleCall& call, const ThreadCut& t) {
  const CycleArguments& a = call.arguments;
  const auto lengths = [&]() -> std::optional<CycleNote> {
    if (std::abs(t.end_z - t.start_z) > t.run_out + 1e-9) return std::nullopt;
    return CycleNote{"fnc-param-sign",
                     fmt::format("G76: the thread from Z{:g} to Z{:g} has to be longer than "
                                 "its run-out of {:g} mm",
                                 t.start_z, t.end_z, t.run_out)};
  };
  const auto core = [&]() -> std::optional<CycleNote> {
    if (t.end_r - std::max(t.taper, 0.0) - t.depth > 0.0) return std::nullopt;
    return CycleNote{"fnc-dia-neg", fmt::format("G76: depth P{:g} and taper R{:g} leave no core of diameter "
                                                "X{:g}",
                                                a.value('P'), a.value('R'), a.value('X'))};
  };
  return firstNote(lengths, core,
                   [&] { return checkPasses(call.code, infeeds(t, *call.thread), "Q of both blocks"); });
}

/// One pass: to the depth, along the thread, off at 45 degrees where there is a run-out, and back.
void cutThreadPass(const ThreadCut& t, double depth, double shift, CycleMoves& moves) {
  const double way = t.end_z < t.start_z ? -1.0 : 1.0;
  const double offset = t.side > 0.0 ? -depth : depth - t.depth;
  const Vec2 from(t.start_z - way * shift, t.end_r - t.taper + offset), end(t.end_z, t.end_r + offset);
  const double share = 1.0 - t.run_out / std::abs(end.x() - from.x());
  const Vec2 leave = from + share * (end - from);
  moves.beginPass();
  moves.rapidToZ(from.x(), Role::kInfeed);
  moves.rapidToR(from.y(), Role::kInfeed);
  moves.threadTo(leave, t.lead, 0.0, Role::kPass);
  const double turn = std::abs(leave.x() - from.x()) / t.lead;
  moves.threadTo(Vec2(end.x(), leave.y() + t.side * t.run_out), t.lead, turn - std::floor(turn), Role::kPass);
  moves.rapidToR(t.start_r, Role::kRetract);
  moves.rapidToZ(t.start_z, Role::kRetract);
}

ThreadCut threadOf(const CycleCall& call) {
  const CycleArguments& a = call.arguments;
  const double major = 0.5 * a.value('X');
  return {.start_z = call.at.x(),
          .start_r = call.at.y(),
          .end_z = a.value('Z'),
          .end_r = major,
          .side = call.at.y() < major ? -1.0 : 1.0,
          .depth = a.value('P'),
          .first = std::min(a.value('Q'), a.value('P')),
          .taper = a.value('R'),
          .lead = a.value('F'),
          .run_out = call.thread ? call.thread->run_out * a.value('F') : 0.0};
}

void cutThreadPasses(const CycleCall& call, CycleAnswer& answer) {
  const CycleArguments& a = call.arguments;
  answer.alarm = firstNote([&] { return checkLetters(call.code, a, "XZPQRF", ""); },
                           [&] { return checkSigns(call.code, a, "XPQF", ""); });
  if (answer.alarm) return;
  if (!call.thread) {
    answer.alarm = CycleNote{"fnc-param-missing", "G76 with X and Z needs a block G76 P Q R before it"};
    return;
  }
  const ThreadCut thread = threadOf(call);
  answer.alarm = checkThread(call, thread);
  if (answer.alarm) return;
  if (thread.side < 0.0) {
    answer.warnings.push_back({"fnc-thread",
                               "G76 starts below X: it cuts an internal thread, which is not "
                               "described, from the minor diameter outwards"});
  }
  const double flank = std::tan(degToRad(0.5 * call.thread->angle_deg));
  CycleMoves moves(call.at);
  for (const double depth : threadDepths(thread, *call.thread)) {
    cutThreadPass(thread, depth, (thread.depth - depth) * flank, moves);
  }
  answer.passes = moves.pass();
  answer.moves = moves.take();
}

}  // namespace

void cutThread(const CycleCall& call, CycleAnswer& answer) {
  const bool cuts = call.arguments.has('X') || call.arguments.has('Z');
  cuts ? cutThreadPasses(call, answer) : keepThreadData(call, answer);
}

}  // namespace proveout::nc
