// G73, G70: the contour as a whole, in passes and finished (section 16).
#include <fmt/core.h>

#include <cmath>

#include "core/nc/fanuc/lathe/contour_blocks.h"
#include "core/nc/fanuc/lathe/lathe_data.h"
#include "core/nc/fanuc/lathe/lathe_hooks.h"
#include "core/nc/fanuc/lathe/lathe_moves.h"
#include "core/nc/fanuc/lathe/lathe_plans.h"
#include "core/nc/fanuc/lathe/lathe_words.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/motion/feed.h"
#include "core/nc/iso/perform/unused_words.h"
#include "core/nc/services/contour/contour_offset.h"

namespace proveout::nc {
namespace {

constexpr std::int64_t kMostPatternPasses = 5000;

std::string patternName(const BlockPlan& plan) { return gName(plan.governor->number10()); }

struct PatternWords {
  ContourLines lines;
  Vec2 allowance = Vec2::Zero(), stock = Vec2::Zero();  ///< (z, x), X as radii, mm
  std::int64_t passes = 1;
};

/// The number of passes of a word. False: reported.
bool takePasses(IsoContext& c, const BlockPlan& plan, const Word& w, std::int64_t& passes) {
  const double value = std::round(w.value);
  if (!(value >= 1.0 && value <= static_cast<double>(kMostPatternPasses)) || std::abs(value - w.value) > 1e-9)
    return c.failWord("062",
                      fmt::format("{}: the number of passes is a whole number from 1 to {}",
                                  patternName(plan), kMostPatternPasses),
                      w);
  passes = static_cast<std::int64_t>(value);
  return true;
}

/// R counts in units, or in least increments where `decimal` says so: a number of passes is the digits.
double asDigits(const IsoContext& c, const Word& w, double value) {
  return countsIncrements(c, w) ? std::round(value / 0.001) : value;
}

bool planPatternLine(IsoContext& c, BlockPlan& plan) {
  std::int64_t passes = 0;
  if (const Word* r = c.ownWord(plan, 'R')) {
    Word digits = *r;
    digits.value = asDigits(c, *r, r->value);
    if (!takePasses(c, plan, digits, passes)) return false;
  }
  plan.motion.target = plan.start;
  plan.perform = [](IsoContext& context, BlockPlan& planned) {
    IsoParameters& p = context.parameters;
    if (context.ownWord(planned, 'U') != nullptr) p.put(FanucParam::kG73X, lengthWord(context, planned, 'U'));
    if (context.ownWord(planned, 'W') != nullptr) p.put(FanucParam::kG73Z, lengthWord(context, planned, 'W'));
    if (const Word* r = context.ownWord(planned, 'R'))
      p.put(FanucParam::kG73Passes, std::round(asDigits(context, *r, r->value)));
    return true;
  };
  return true;
}

bool takePatternWords(IsoContext& c, BlockPlan& plan, PatternWords& words) {
  if (!findContour(c, plan, patternName(plan), words.lines)) return false;
  words.allowance = {lengthWord(c, plan, 'W'), 0.5 * lengthWord(c, plan, 'U')};
  if (const Word* d = c.ownWord(plan, 'D')) {
    words.stock = {lengthWord(c, plan, 'K'), lengthWord(c, plan, 'I')};
    return takePasses(c, plan, *d, words.passes);
  }
  words.stock = {c.parameters[FanucParam::kG73Z], c.parameters[FanucParam::kG73X]};
  words.passes = std::max<std::int64_t>(1, std::llround(c.parameters[FanucParam::kG73Passes]));
  return true;
}

bool cutPatternPass(LatheMoves& moves, const BlockContour& contour, const Vec2& start, const Vec2& shift) {
  PlaneContour pass = contour.elements;
  shiftContour(pass, shift);
  if (!moves.rapid(start + shift)) return false;
  for (const ContourElement& e : pass) {
    const auto k = static_cast<std::size_t>(e.source);
    const bool to_contour = &e == &pass.front();
    if (!(to_contour && contour.rapids[k] ? moves.rapid(e.to) : moves.feed(e, &contour.sources[k])))
      return false;
  }
  return true;
}

bool performPattern(IsoContext& c, BlockPlan& plan) {
  PatternWords words;
  BlockContour contour;
  if (!takePatternWords(c, plan, words)) return false;
  LatheMoves moves(c, plan);
  const Vec2 start = moves.at();
  if (!readContour(c, plan, words.lines, contour)) return false;
  const auto n = static_cast<double>(words.passes);
  for (std::int64_t k = 1; k <= words.passes; ++k) {
    const double share = words.passes > 1 ? (n - static_cast<double>(k)) / (n - 1.0) : 0.0;
    if (!cutPatternPass(moves, contour, start, words.allowance + share * words.stock)) return false;
    if (c.watch.workOver(c.calls.place())) return false;
  }
  if (!moves.rapid(start)) return false;
  moves.finish();
  if (words.lines.first > c.calls.lineIndex()) plan.go_on = words.lines.last + 1;
  return true;
}

bool beginFinishing(IsoContext& c, BlockPlan& plan) {
  latheData(c).finishing.push_back({c.position, c.state.compOn()});
  ContourLines lines;
  if (!findContour(c, plan, patternName(plan), lines)) return false;
  plan.lines = LineRange{lines.first, lines.last + 1};
  return true;
}

}  // namespace

bool planPattern(IsoContext& c, BlockPlan& plan) {
  if (!turningPlane(c, plan)) return false;
  const AddressSet& present = c.block.present;
  if (!present.has('P') && !present.has('Q') && !present.has('D')) return planPatternLine(c, plan);
  PatternWords words;
  if (!takePatternWords(c, plan, words)) return false;
  plan.motion.target = plan.start;
  plan.perform = performPattern;
  return feedStyle(c, plan, plan.motion.feed);
}

bool planFinishing(IsoContext& c, BlockPlan& plan) {
  ContourLines lines;
  if (!turningPlane(c, plan) || !findContour(c, plan, patternName(plan), lines)) return false;
  for (const Address a : {'U', 'W'}) {
    if (const Word* w = c.ownWord(plan, a))
      tellUnused(c, *w, patternName(plan), "the finish leaves no allowance: G71 to G73 have it");
  }
  plan.motion.target = plan.start;
  plan.perform = beginFinishing;
  return true;
}

bool endLatheLines(IsoContext& c) {
  std::vector<FinishStart>& finishing = latheData(c).finishing;
  if (finishing.empty()) return true;
  const FinishStart start = finishing.back();
  finishing.pop_back();
  BlockPlan plan(c.state);
  if (!start.comp_on) plan.next.active[kGroupRadiusComp] = gcode::kCompOff;
  LatheMoves moves(c, plan, true);
  if (!moves.rapid(moves.pointOf(start.at))) return false;
  moves.finish();
  c.state.active[kGroupRadiusComp] = plan.next.active[kGroupRadiusComp];
  return true;
}

}  // namespace proveout::nc
