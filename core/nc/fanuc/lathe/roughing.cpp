// G71, G72: roughing over a contour (section 16).
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/nc/fanuc/lathe/contour_blocks.h"
#include "core/nc/fanuc/lathe/lathe_codes.h"
#include "core/nc/fanuc/lathe/lathe_data.h"
#include "core/nc/fanuc/lathe/lathe_moves.h"
#include "core/nc/fanuc/lathe/lathe_plans.h"
#include "core/nc/fanuc/lathe/lathe_words.h"
#include "core/nc/fanuc/lathe/roughing_passes.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/motion/feed.h"
#include "core/nc/services/contour/contour_offset.h"

namespace proveout::nc {
namespace {

/// What the words of the block and of the first line say, mm; X as a radius.
struct RoughingWords {
  ContourLines lines;
  Vec2 allowance = Vec2::Zero();  ///< of the finish, (z, x)
  Vec2 extra = Vec2::Zero();      ///< of the levels beyond that
  double depth = 0.0, escape = 0.0;
  bool pockets = false;  ///< R1 of one-line forms
};

bool facing(const BlockPlan& plan) { return plan.governor->code10 == lathe_code::kRoughFacing; }
std::string codeName(const BlockPlan& plan) { return gName(plan.governor->number10()); }

bool isSettingLine(const IsoContext& c) {
  return !c.block.present.has('P') && !c.block.present.has('Q') && !c.block.present.has('D');
}

bool checkDepth(IsoContext& c, const BlockPlan& plan, double depth) {
  return depth > 0.0 || c.fail("062", fmt::format("{}: the depth of a cut must be above 0", codeName(plan)));
}

/// The first line: U (G72: W) depth, R escape.
bool planSettingLine(IsoContext& c, BlockPlan& plan) {
  const Word* depth = c.ownWord(plan, facing(plan) ? 'W' : 'U');
  if (depth != nullptr && !checkDepth(c, plan, depth->value)) return false;
  if (c.ownWord(plan, 'R') != nullptr && lengthWord(c, plan, 'R') < 0.0)
    return c.fail("062", fmt::format("{}: the escape R must not be negative", codeName(plan)));
  plan.motion.target = plan.start;
  plan.perform = [](IsoContext& context, BlockPlan& planned) {
    const Address letter = facing(planned) ? 'W' : 'U';
    if (context.ownWord(planned, letter) != nullptr)
      context.parameters.put(FanucParam::kG71Depth, lengthWord(context, planned, letter));
    if (context.ownWord(planned, 'R') != nullptr)
      context.parameters.put(FanucParam::kG71Escape, lengthWord(context, planned, 'R'));
    return true;
  };
  return true;
}

bool takeRoughingWords(IsoContext& c, BlockPlan& plan, RoughingWords& words) {
  if (!findContour(c, plan, codeName(plan), words.lines)) return false;
  words.allowance = {lengthWord(c, plan, 'W'), 0.5 * lengthWord(c, plan, 'U')};
  words.extra = {lengthWord(c, plan, 'K'), lengthWord(c, plan, 'I')};
  words.escape = c.parameters[FanucParam::kG71Escape];
  if (const Word* d = c.ownWord(plan, 'D')) {
    words.depth = depthWord(c, plan, *d);
    const Word* r = c.ownWord(plan, 'R');
    words.pockets = r != nullptr && r->value != 0.0;
    noteSetting(c, FanucParam::kG71Escape,
                fmt::format("the tool leaves a level by {:g} mm", c.parameters[FanucParam::kG71Escape]));
  } else {
    words.depth = c.parameters[FanucParam::kG71Depth];
    if (!c.parameters.given(FanucParam::kG71Depth))
      noteSetting(c, FanucParam::kG71Depth,
                  fmt::format("levels are {:g} mm deep", c.parameters[FanucParam::kG71Depth]));
  }
  return checkDepth(c, plan, words.depth);
}

/// The contour of a roughing cycle and how its levels lie.
struct RoughingWork {
  BlockContour contour;
  PlaneContour finish;  ///< the contour moved by its allowance, without the way to it
  LevelRules rules;
  PlaneContour levels;  ///< the contour that the levels go down to
};

bool checkShape(IsoContext& c, const BlockPlan& plan, const PlaneContour& contour, bool pockets) {
  const int along = facing(plan) ? 1 : 0;
  const char* const letters = "ZX";
  if (!goesOneWay(contour, along)) {
    return c.fail(
        "064", fmt::format("{}: the contour does not go one way along {}", codeName(plan), letters[along]));
  }
  if (pockets || goesOneWay(contour, 1 - along)) return true;
  return c.fail("064",
                fmt::format("{0}: the contour does not go one way along {1}: pockets need type II, X and "
                            "Z in the first block (W0 is enough)",
                            codeName(plan), letters[1 - along]));
}

bool checkFirstAxes(IsoContext& c, const BlockPlan& plan, const BlockContour& contour) {
  const bool good = facing(plan) ? contour.names_z : contour.names_x;
  return good || c.fail("065", fmt::format("{}: the first block of the contour names no {}", codeName(plan),
                                           facing(plan) ? 'Z' : 'X'));
}

bool prepare(IsoContext& c, BlockPlan& plan, const RoughingWords& words, const Vec2& start,
             RoughingWork& work) {
  if (!readContour(c, plan, words.lines, work.contour) || !checkFirstAxes(c, plan, work.contour))
    return false;
  work.finish.assign(work.contour.elements.begin() + 1, work.contour.elements.end());
  const bool pockets = words.pockets || (work.contour.names_x && work.contour.names_z);
  if (!checkShape(c, plan, work.finish, pockets)) return false;
  LevelRules& rules = work.rules;
  rules.depth_axis = facing(plan) ? 0 : 1;
  const int depth = rules.depth_axis;
  double room = start[depth] - work.finish.front().from[depth];
  if (std::abs(room) < 1e-9) room = start[depth] - work.finish.back().to[depth];
  rules.side = room < 0.0 ? -1.0 : 1.0;
  if (words.allowance[depth] * rules.side < 0.0) {
    c.warn("allowance", fmt::format("{}: the allowance lies on the side of the finished part: it is cut into",
                                    codeName(plan)));
  }
  work.levels = work.finish;
  shiftContour(work.finish, words.allowance);
  shiftContour(work.levels, words.allowance + words.extra);
  rules.from = start + words.allowance;
  rules.first = c.parameters.flag(FanucParam::kG71Levels) ? start[depth] : rules.from[depth];
  rules.depth = words.depth;
  rules.escape = words.escape;
  rules.pockets = pockets;
  double deepest = 0.0;
  for (const ContourElement& e : work.levels) {
    deepest = std::max(
        {deepest, rules.side * (rules.first - e.from[depth]), rules.side * (rules.first - e.to[depth])});
  }
  if (deepest / words.depth > kMostLevels - 1)
    return c.fail("062", fmt::format("{}: the depth of a cut, {:g} mm, makes more than {} levels",
                                     codeName(plan), words.depth, kMostLevels));
  return true;
}

const SourceRef* sourceOf(const BlockContour& contour, const ContourElement& e) {
  return e.source < 0 ? nullptr : &contour.sources[static_cast<std::size_t>(e.source)];
}

bool cutLevels(IsoContext& c, LatheMoves& moves, const RoughingWork& work) {
  const bool rapid_infeed = work.contour.rapids.front();
  for (const ContourMove& move : levelPasses(work.levels, work.rules)) {
    const bool rapid = move.speed == ContourMove::Speed::kRapid ||
                       (move.speed == ContourMove::Speed::kInfeed && rapid_infeed);
    const bool good =
        rapid ? moves.rapid(move.element.to) : moves.feed(move.element, sourceOf(work.contour, move.element));
    if (!good) return false;
    if (move.speed == ContourMove::Speed::kInfeed && c.watch.workOver(c.calls.place())) return false;
  }
  return true;
}

/// Along the finish contour with its allowance.
bool cutLastPass(LatheMoves& moves, const RoughingWork& work) {
  const int depth = work.rules.depth_axis, along = 1 - depth;
  const bool rapid_infeed = work.contour.rapids.front();
  const Vec2& first = work.finish.front().from;
  if (std::abs(moves.at()[along] - work.rules.from[along]) > 1e-9) {  // out of a pocket
    Vec2 out = moves.at();
    out[depth] = work.rules.from[depth];
    if (!moves.rapid(out) || !moves.rapid(work.rules.from)) return false;
  }
  if (!(rapid_infeed ? moves.rapid(first) : moves.feed(first))) return false;
  for (const ContourElement& e : work.finish) {
    if (!moves.feed(e, sourceOf(work.contour, e))) return false;
  }
  return true;
}

bool performRoughing(IsoContext& c, BlockPlan& plan) {
  RoughingWords words;
  RoughingWork work;
  if (!takeRoughingWords(c, plan, words)) return false;
  LatheMoves moves(c, plan);
  const Vec2 start = moves.at();
  if (!prepare(c, plan, words, start, work)) return false;
  if (!moves.rapid(work.rules.from) || !cutLevels(c, moves, work) || !cutLastPass(moves, work) ||
      !moves.rapid(start)) {
    return false;
  }
  moves.finish();
  if (words.lines.first > c.calls.lineIndex()) plan.go_on = words.lines.last + 1;
  return true;
}

}  // namespace

bool planRoughing(IsoContext& c, BlockPlan& plan) {
  if (!turningPlane(c, plan)) return false;
  if (isSettingLine(c)) return planSettingLine(c, plan);
  RoughingWords words;
  if (!takeRoughingWords(c, plan, words)) return false;
  plan.motion.target = plan.start;
  plan.perform = performRoughing;
  return feedStyle(c, plan, plan.motion.feed);
}

}  // namespace proveout::nc
