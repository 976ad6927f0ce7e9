// Pockets: G12, G13, G150 of Haas mills.
#include <fmt/core.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/nc/fanuc/haas/haas.h"
#include "core/nc/fanuc/haas/outline_reader.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/cycles/path_steps.h"
#include "core/nc/iso/motion/feed.h"
#include "core/nc/iso/perform/unused_words.h"
#include "core/nc/services/circular_pocket.h"
#include "core/nc/services/outline_pocket.h"

namespace proveout::nc {
namespace {

constexpr int kClockwisePocket = 120;
constexpr std::int64_t kMostPasses = 10000;
constexpr std::size_t kMostSteps = 2000000;

/// The plane, compensation and radius that a pocket needs.
bool pocketState(IsoContext& c, const BlockPlan& plan, const std::string& code) {
  if (plan.next.plane() != Plane::kXY) return c.alarm(SharedAlarm::kPlane, "", code + " mills in G17");
  if (c.state.compOn())
    return c.fail("pocket-in-comp", code + " runs in G40: it knows the tool by its own D");
  if (plan.next.inCycle())
    return c.fail("pocket-in-cycle", code + " cannot run in a drilling cycle: program G80");
  return !(plan.next.d_radius < 0.0) ||
         c.fail("pocket-tool", fmt::format("{}: the radius of D{} is negative", code, plan.next.d));
}

class StepWriter {
 public:
  StepWriter(std::vector<PathStep>& steps, const Vec3& at) : steps_(steps), at_(at) { steps_.clear(); }

  void to(PathStep::Kind kind, const Vec3& p) {
    if (p != at_) steps_.push_back({kind, p, Vec2::Zero(), 0.0, 1.0});
    at_ = p;
  }
  void rapid(const Vec2& p, double w) { to(PathStep::Kind::kRapid, Vec3(p.x(), p.y(), w)); }
  void feed(const Vec2& p, double w) { to(PathStep::Kind::kFeed, Vec3(p.x(), p.y(), w)); }
  void arc(const Vec2& p, const Vec2& center, double sweep) {
    at_ = Vec3(p.x(), p.y(), at_.z());
    steps_.push_back({PathStep::Kind::kArc, at_, center, sweep, 1.0});
  }
  /// Ways at the level where the tool is; out of the material up to `clear`.
  void ways(const std::vector<PocketMove>& moves, const Vec2& origin, double clear) {
    const double level = at_.z();
    for (const PocketMove& m : moves) {
      const Vec2 p = origin + m.to;
      if (m.kind == PocketMove::Kind::kArc) {
        arc(p, origin + m.center, m.sweep_rad);
        continue;
      }
      if (m.kind == PocketMove::Kind::kOver) {
        rapid(at_.head<2>(), clear);
        rapid(p, clear);
      }
      feed(p, level);
    }
  }
  const Vec3& at() const { return at_; }

 private:
  std::vector<PathStep>& steps_;
  Vec3 at_;
};

const char* reasonOf(CircularPocketError error) {
  switch (error) {
    case CircularPocketError::kTooSmall:
      return "the first circle (I) is not larger than the radius of the tool";
    case CircularPocketError::kBackwards:
      return "the last circle (K) is smaller than the first one (I)";
    case CircularPocketError::kNoStep:
      return "K needs Q, the step from circle to circle, above 0";
    case CircularPocketError::kTooMany:
      return "Q is too small for so many circles";
    case CircularPocketError::kNotFinite:
    case CircularPocketError::kNone:
      break;
  }
  return "the data are out of range";
}

bool readRoundPocket(IsoContext& c, const BlockPlan& plan, const std::string& code, CircularPocket& out) {
  const Word* i = c.word('I');
  const Word* k = c.word('K');
  const Word* q = c.word('Q');
  if (q != nullptr && k == nullptr) tellUnused(c, *q, code, "there is one circle without K");
  if (i == nullptr)
    return c.alarm(SharedAlarm::kMissingData, "I", code + " needs the radius of the (first) circle");
  out.first = lengthOf(plan, *i);
  if (k != nullptr) {
    out.last = lengthOf(plan, *k);
    if (!(out.last > 0.0)) return c.alarm(SharedAlarm::kOutOfRange, *k, "a radius above 0");
  }
  if (k != nullptr && q != nullptr) out.step = lengthOf(plan, *q);
  out.tool_radius = plan.next.d_radius;
  out.counter_clockwise = plan.governor->code10 != kClockwisePocket;
  return true;
}

/// How often the pocket is milled, each time deeper by Z.
bool readPasses(IsoContext& c, const BlockPlan& plan, std::int64_t& passes) {
  passes = 1;
  const Word* l = c.word('L');
  if (l == nullptr) return true;
  if (!integerWord(c, *l, 1, kMostPasses, passes)) return false;
  if (passes > 1 && !plan.next.incremental()) {
    c.warn("pocket-repeat", "L repeats the pocket at one depth: it counts with G91, where Z is a step",
           l->columns, Severity::kNote);
    passes = 1;
  }
  return true;
}

}  // namespace

bool planHaasRoundPocket(IsoContext& c, BlockPlan& plan) {
  const std::string code = gName(plan.governor->code10);
  CircularPocket pocket;
  std::int64_t passes = 1;
  if (!pocketState(c, plan, code) || !axisTarget(c, plan, plan.motion.target) ||
      !readRoundPocket(c, plan, code, pocket) || !readPasses(c, plan, passes) ||
      !feedStyle(c, plan, plan.motion.feed))
    return false;
  std::vector<PocketMove> moves;
  const CircularPocketError error = circularPocket(pocket, moves);
  if (error != CircularPocketError::kNone) return c.fail("pocket-size", code + ": " + reasonOf(error));
  if (moves.size() * static_cast<std::size_t>(passes) > kMostSteps)
    return c.fail("pocket-size", code + ": too many circles");
  const WorkPlane plane = planeOf(plan.next);
  const Vec3 start = plane.of(plan.start);
  const Vec2 center = start.head<2>();
  const double step = plane.of(plan.motion.target).z() - start.z();
  StepWriter writer(c.path_steps, start);
  for (std::int64_t k = 1; k <= passes; ++k) {
    writer.feed(center, start.z() + step * static_cast<double>(k));
    writer.ways(moves, center, start.z());
  }
  plan.motion.target = plan.start;
  plan.motion.target[plane.w] = writer.at().z();
  if (pocket.last > 0.0)
    noteHaasPath(c, code, "how the control joins the circles is the maker's; what is cut is the same");
  plan.perform = performSteps;
  return true;
}

namespace {

struct OutlineWords {
  double r = 0.0, bottom = 0.0, depth = 0.0, finish = 0.0;
};

bool readOutlineWords(IsoContext& c, const BlockPlan& plan, OutlinePocket& pocket, OutlineWords& out) {
  const WorkPlane plane = planeOf(plan.next);
  const auto needed = [&](Address a, const char* what) {
    const Word* w = c.word(a);
    if (w == nullptr) c.alarm(SharedAlarm::kMissingData, addressText(a), fmt::format("G150 needs {}", what));
    return w;
  };
  const Word* r = needed('R', "the level R");
  const Word* q = r != nullptr ? needed('Q', "the depth of a cut") : nullptr;
  if (q == nullptr) return false;
  if (!plan.motion.named[static_cast<std::size_t>(plane.w)])
    return c.alarm(SharedAlarm::kMissingData, "Z", "G150 needs the depth of the pocket");
  const bool steps = plan.next.incremental();
  out.r = (steps ? plane.of(plan.start).z() : 0.0) + lengthOf(plan, *r);
  out.bottom = plane.of(plan.motion.target).z();
  if (steps) out.bottom += out.r - plane.of(plan.start).z();
  out.depth = lengthOf(plan, *q);
  if (!(out.depth > 0.0)) return c.alarm(SharedAlarm::kOutOfRange, *q, "a depth above 0");
  if (!(out.bottom < out.r)) return c.fail("pocket-size", "G150: Z does not lie below R");
  if ((out.r - out.bottom) / out.depth > 10000.0)
    return c.alarm(SharedAlarm::kOutOfRange, *q, "it is too small");
  const Word* i = c.word('I');
  const Word* j = c.word('J');
  if ((i == nullptr) == (j == nullptr))
    return c.fail("pocket-size", "G150 takes I (step of lanes along X) or J (along Y), one of them");
  pocket.along_v = j != nullptr;
  pocket.step = std::abs(lengthOf(plan, i != nullptr ? *i : *j));
  if (const Word* k = c.word('K')) pocket.allowance = std::abs(lengthOf(plan, *k));
  pocket.start = plane.of(plan.motion.target).head<2>();
  pocket.tool_radius = plan.next.d_radius;
  return true;
}

/// G41 mills inside of an outline that turns left, G42 of one that turns right.
bool outlineSide(IsoContext& c, const BlockPlan& plan, const PlaneContour& outline) {
  const GCode* side = plan.by_group[kGroupRadiusComp];
  if (side == nullptr || side->code10 == gcode::kCompOff)
    return c.fail("pocket-side", "G150 needs G41 or G42 in its block");
  const bool left = side->code10 == gcode::kCompLeft;
  return left == turnsLeft(outline) ||
         c.fail("pocket-side", left ? "G41 lies outside of this outline: it turns to the right, program G42"
                                    : "G42 lies outside of this outline: it turns to the left, program G41");
}

void writeOutline(const OutlineWords& words, const OutlinePocket& pocket, const OutlinePocketWays& ways,
                  StepWriter& writer) {
  writer.rapid(pocket.start, writer.at().z());
  writer.rapid(pocket.start, words.r);
  const double cuts = std::ceil((words.r - words.bottom) / words.depth - 1e-9);
  for (int k = 1; k <= static_cast<int>(cuts); ++k) {
    const double level = std::max(words.bottom, words.r - k * words.depth);
    writer.rapid(pocket.start, writer.at().z());
    writer.feed(pocket.start, level);
    writer.ways(ways.rough, Vec2::Zero(), words.r);
    if (level <= words.bottom) writer.ways(ways.finish, Vec2::Zero(), words.r);
    writer.rapid(writer.at().head<2>(), words.r);
  }
}

}  // namespace

bool planHaasOutlinePocket(IsoContext& c, BlockPlan& plan) {
  OutlinePocket pocket;
  OutlineWords words;
  if (!pocketState(c, plan, "G150") || !axisTarget(c, plan, plan.motion.target) ||
      !readOutlineWords(c, plan, pocket, words) || !feedStyle(c, plan, plan.motion.feed) ||
      !readOutline(c, plan, pocket.start, pocket.outline) || !outlineSide(c, plan, pocket.outline))
    return false;
  const Result<OutlinePocketWays> ways = outlinePocketWays(pocket);
  if (!ways.ok()) return c.fail("pocket-outline", "G150: " + ways.error().message);
  const double cuts = std::ceil((words.r - words.bottom) / words.depth);
  if (static_cast<double>(ways.value().rough.size()) * cuts > static_cast<double>(kMostSteps))
    return c.fail("pocket-size", "G150: too many motions, the steps are too small");
  if (!ways.value().all_reached) {
    c.warn("pocket-rest", "G150: the tool is too large for a corner of the outline, material stays there");
  }
  const WorkPlane plane = planeOf(plan.next);
  StepWriter writer(c.path_steps, plane.of(plan.start));
  writeOutline(words, pocket, ways.value(), writer);
  plan.motion.target[plane.u] = writer.at().x();
  plan.motion.target[plane.v] = writer.at().y();
  plan.motion.target[plane.w] = writer.at().z();
  plan.next.active[kGroupRadiusComp] = gcode::kCompOff;
  noteHaasPath(c, "G150", "the order of the lanes is the maker's; what is cut is the same");
  plan.perform = performSteps;
  return true;
}

}  // namespace proveout::nc
