// G74, G75: pecks along Z or X, column by column (section 16).
#include <fmt/core.h>

#include <cmath>

#include "core/nc/fanuc/lathe/lathe_codes.h"
#include "core/nc/fanuc/lathe/lathe_moves.h"
#include "core/nc/fanuc/lathe/lathe_plans.h"
#include "core/nc/fanuc/lathe/lathe_words.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/motion/feed.h"

namespace proveout::nc {
namespace {

constexpr double kMostPecks = 100000.0;

struct PeckWords {
  int along = 0;        ///< coordinate of the pecks: 0 z, 1 x
  double peck = 0.0;    ///< 0: in one go
  double step = 0.0;    ///< between columns
  double relief = 0.0;  ///< aside at the bottom
  double back = 0.0;    ///< between pecks
};

std::string peckName(const BlockPlan& plan) { return gName(plan.governor->number10()); }
bool along_x(const BlockPlan& plan) { return plan.governor->code10 == lathe_code::kGroove; }

bool isPeckSetting(const IsoContext& c) {
  return c.block.present.has('R') && (c.block.present & AddressSet("XZUWPQIKD")).empty();
}

bool planPeckLine(IsoContext& c, BlockPlan& plan) {
  if (lengthWord(c, plan, 'R') < 0.0)
    return c.fail("062", fmt::format("{}: the return R must not be negative", peckName(plan)));
  plan.motion.target = plan.start;
  plan.perform = [](IsoContext& context, BlockPlan& planned) {
    context.parameters.put(FanucParam::kG74Return, lengthWord(context, planned, 'R'));
    return true;
  };
  return true;
}

/// P steps along X and Q along Z; I and K of one-line forms, with D for the relief.
bool takePeckWords(IsoContext& c, BlockPlan& plan, PeckWords& words) {
  words.along = along_x(plan) ? 1 : 0;
  double x = 0.0, z = 0.0;
  if (const Word* p = c.ownWord(plan, 'P')) x = stepWord(c, plan, *p);
  if (const Word* q = c.ownWord(plan, 'Q')) z = stepWord(c, plan, *q);
  if (c.ownWord(plan, 'I') != nullptr) x = lengthWord(c, plan, 'I');
  if (c.ownWord(plan, 'K') != nullptr) z = lengthWord(c, plan, 'K');
  words.peck = words.along == 1 ? x : z;
  words.step = words.along == 1 ? z : x;
  words.relief = lengthWord(c, plan, 'R');
  if (const Word* d = c.ownWord(plan, 'D')) words.relief = depthWord(c, plan, *d);
  words.back = c.parameters[FanucParam::kG74Return];
  if (x < 0.0 || z < 0.0 || words.relief < 0.0)
    return c.fail("062", fmt::format("{}: depths and steps must not be negative", peckName(plan)));
  return true;
}

/// One column down to `bottom`, aside, and back to the start.
bool cutColumn(LatheMoves& moves, const PeckWords& words, double bottom, double aside) {
  const int a = words.along;
  const Vec2 top = moves.at();
  const double way = bottom < top[a] ? -1.0 : 1.0;
  const auto point = [&](double v) {
    Vec2 p = top;
    p[a] = v;
    return p;
  };
  for (double n = 1.0; words.peck > 0.0 && n * words.peck < std::abs(bottom - top[a]) - 1e-9; n += 1.0) {
    const double depth = top[a] + way * n * words.peck;
    if (!moves.feed(point(depth)) || !moves.rapid(point(depth - way * words.back))) return false;
  }
  if (!moves.feed(point(bottom))) return false;
  if (aside != 0.0) {
    Vec2 p = moves.at();
    p[1 - a] += aside;
    if (!moves.rapid(p)) return false;
  }
  Vec2 out = moves.at();
  out[a] = top[a];
  return moves.rapid(out);
}

bool performPecking(IsoContext& c, BlockPlan& plan) {
  PeckWords words;
  if (!takePeckWords(c, plan, words)) return false;
  AxisPoint programmed = plan.start;
  plan.motion.named.reset();
  if (!axisTarget(c, plan, programmed)) return false;
  LatheMoves moves(c, plan);
  const Vec2 start = moves.at(), end = moves.pointOf(programmed);
  const int a = words.along, b = 1 - a;
  const double width = std::abs(end[b] - start[b]), depth = std::abs(end[a] - start[a]);
  const double side = end[b] < start[b] ? -1.0 : 1.0;
  if (width > 1e-9 && !(words.step > 0.0))
    return c.fail("062", fmt::format("{}: the step to the next column is missing", peckName(plan)));
  const double columns = width > 1e-9 ? std::ceil(width / words.step - 1e-9) : 0.0;
  const double pecks = words.peck > 0.0 ? depth / words.peck : 1.0;
  if (!((columns + 1.0) * (pecks + 1.0) < kMostPecks))
    return c.fail("062", fmt::format("{}: more than {:g} pecks", peckName(plan), kMostPecks));
  for (double n = 0.0; n <= columns; n += 1.0) {
    Vec2 top = start;
    top[b] = n < columns || columns == 0.0 ? start[b] + side * n * words.step : end[b];
    if (!moves.rapid(top)) return false;
    if (!cutColumn(moves, words, end[a], n > 0.0 ? -side * words.relief : 0.0)) return false;
    if (c.watch.workOver(c.calls.place())) return false;
  }
  if (!moves.rapid(start)) return false;
  moves.finish();
  return true;
}

}  // namespace

bool planPecking(IsoContext& c, BlockPlan& plan) {
  if (!turningPlane(c, plan)) return false;
  if (isPeckSetting(c)) return planPeckLine(c, plan);
  PeckWords words;
  AxisPoint end;
  if (!takePeckWords(c, plan, words) || !axisTarget(c, plan, end)) return false;
  const bool deep = plan.motion.named[along_x(plan) ? 0 : 2];
  plan.motion.named.reset();
  if (!deep) return c.alarm(SharedAlarm::kMissingData, along_x(plan) ? "X" : "Z", "the bottom of the pecks");
  if (!c.parameters.given(FanucParam::kG74Return))
    noteSetting(c, FanucParam::kG74Return,
                fmt::format("the pecks return by {:g} mm", c.parameters[FanucParam::kG74Return]));
  plan.motion.target = plan.start;
  plan.perform = performPecking;
  return feedStyle(c, plan, plan.motion.feed);
}

}  // namespace proveout::nc
