#include "core/nc/iso/motion/contour.h"

#include <cmath>

#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/motion/feed.h"
#include "core/nc/iso/perform/perform.h"
#include "core/nc/iso/perform/unused_words.h"

namespace proveout::nc {
namespace {

/// Directions nearer than this to an axis have no slope along the other one.
constexpr double kSteep = 1e-9;

struct PlaneWords {
  int u, v;
  bool has_u, has_v;
};

PlaneWords planeWords(const BlockPlan& plan) {
  const WorkPlane plane = planeOf(plan.next);
  return {plane.u, plane.v, plan.motion.named[static_cast<std::size_t>(plane.u)],
          plan.motion.named[static_cast<std::size_t>(plane.v)]};
}

/// The block's end in the plane as it is written: over-determined blocks know no increments.
void takeAbsolute(IsoContext& c, BlockPlan& plan) {
  const PlaneWords words = planeWords(plan);
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (!axisWord(plan, w, word) || (word.axis != words.u && word.axis != words.v)) continue;
    plan.motion.target[word.axis] = axisValue(c, plan, word, w);
  }
}

PathItem::Meet choiceOf(const IsoContext& c, const BlockPlan& plan) {
  const Word* q = c.ownWord(plan, 'Q');
  return q != nullptr && q->value > 0.0 ? PathItem::Meet::kSecond : PathItem::Meet::kFirst;
}

bool inComp(const IsoContext& c, const BlockPlan& plan) { return c.state.compOn() && plan.next.compOn(); }

}  // namespace

bool refuseChoice(IsoContext& c, const BlockPlan& plan) {
  const Word* q = c.ownWord(plan, 'Q');
  return q == nullptr ||
         c.alarm(SharedAlarm::kIllegalAddress, *q, "Q belongs to the intersection with the block before");
}

bool planDirection(IsoContext& c, BlockPlan& plan) {
  const Word* a = c.ownWord(plan, kCommaDirection);
  if (a == nullptr) return true;
  const PlaneWords words = planeWords(plan);
  if (words.has_u == words.has_v)
    return c.alarm(SharedAlarm::kIllegalAddress, *a, "it needs one coordinate of the plane");
  const double angle = degToRad(std::remainder(a->value, 360.0));
  const double cosine = std::cos(angle), sine = std::sin(angle);
  if (std::abs(words.has_u ? cosine : sine) < kSteep) {
    return c.fail("contour", "a line in this direction never reaches the coordinate", a->columns);
  }
  AxisPoint& target = plan.motion.target;
  if (words.has_u) {
    target[words.v] = plan.start[words.v] + (target[words.u] - plan.start[words.u]) * sine / cosine;
  } else {
    target[words.u] = plan.start[words.u] + (target[words.v] - plan.start[words.v]) * cosine / sine;
  }
  plan.motion.named.set(static_cast<std::size_t>(words.u));
  plan.motion.named.set(static_cast<std::size_t>(words.v));
  return true;
}

bool planJoin(IsoContext& c, BlockPlan& plan) {
  const Word* chamfer = c.ownWord(plan, kCommaChamfer);
  const Word* round = c.ownWord(plan, kCommaRounding);
  if (chamfer == nullptr && round == nullptr) return true;
  if (chamfer != nullptr && round != nullptr) {
    return c.alarm(SharedAlarm::kChamferAndRounding, "", ",C and ,R in one block", round->columns);
  }
  const Word& word = chamfer ? *chamfer : *round;
  const PlaneWords words = planeWords(plan);
  const bool moves = words.has_u || words.has_v || plan.motion.is_arc;
  if (!moves) return c.alarm(SharedAlarm::kCorner, "", "the block does not move in the plane", word.columns);
  if (word.value < 0.0) return c.alarm(SharedAlarm::kOutOfRange, word, "a length from 0");
  if (word.value > 0.0) {
    plan.motion.join = chamfer ? PathItem::Join::kChamfer : PathItem::Join::kRound;
    plan.motion.join_size = lengthOf(plan, word);
  }
  return true;
}

bool planLineContour(IsoContext& c, BlockPlan& plan) {
  const Word* a = c.ownWord(plan, kCommaDirection);
  const PlaneWords words = planeWords(plan);
  if (a == nullptr || words.has_u != words.has_v) {
    return refuseChoice(c, plan) && planDirection(c, plan) && planJoin(c, plan);
  }
  if (!inComp(c, plan) && !c.dialect.rules.directions_meet) {
    return c.alarm(SharedAlarm::kIllegalAddress, *a,
                   "the calculation of intersections needs G41 or G42 (with D0: no offset)");
  }
  plan.motion.angle = degToRad(std::remainder(a->value, 360.0));
  if (words.has_u) {
    takeAbsolute(c, plan);
    plan.motion.meet = choiceOf(c, plan);
  } else {
    if (!refuseChoice(c, plan)) return false;
    plan.motion.meet = PathItem::Meet::kOpen;
    plan.motion.named.set(static_cast<std::size_t>(words.u));
    plan.motion.named.set(static_cast<std::size_t>(words.v));
  }
  return planJoin(c, plan);
}

bool overdeterminedArc(const IsoContext& c, const BlockPlan& plan) {
  const PlaneWords words = planeWords(plan);
  if (!words.has_u || !words.has_v || !inComp(c, plan)) return false;
  const PlaneFrame letters(plan.next.plane());
  return c.ownWord(plan, "IJK"[letters.u()]) && c.ownWord(plan, "IJK"[letters.v()]) && c.ownWord(plan, 'R');
}

bool planOverdeterminedArc(IsoContext& c, BlockPlan& plan) {
  const PlaneFrame letters(plan.next.plane());
  const Word* r = c.ownWord(plan, 'R');
  if (!(r->value > 0.0)) return c.alarm(SharedAlarm::kOutOfRange, *r, "a radius above 0");
  if (const Word* l = c.ownWord(plan, 'L'))
    return c.alarm(SharedAlarm::kIllegalAddress, *l, "no turns where the corner is calculated");
  takeAbsolute(c, plan);
  PlannedMotion& motion = plan.motion;
  motion.is_arc = true;
  motion.meet = choiceOf(c, plan);
  motion.radius = lengthOf(plan, *r);
  const WorkPlane plane = planeOf(plan.next);
  motion.arc.start = plane.of(plan.start);
  motion.arc.center = {lengthOf(plan, *c.ownWord(plan, "IJK"[letters.u()])),
                       lengthOf(plan, *c.ownWord(plan, "IJK"[letters.v()]))};
  motion.arc.sweep_rad =
      plan.next.active[kGroupMotion] == gcode::kArcCounterClockwise ? 1.0 : -1.0;  // the stage knows how much
  return true;
}

bool planCornerArc(IsoContext& c, BlockPlan& plan) {
  plan.motion.target = plan.start;
  if (plan.by_group[kGroupRadiusComp] != nullptr || !inComp(c, plan)) {
    return c.fail("cutter-comp", "G38 and G39 need G41 or G42");
  }
  const PlaneFrame letters(plan.next.plane());
  Vec3 vector = Vec3::Zero();
  bool given = false;
  for (int axis = 0; axis < 3; ++axis) {
    const Word* w = c.ownWord(plan, "IJK"[axis]);
    if (w == nullptr) continue;
    if (axis == letters.w()) {
      tellUnused(c, *w, "G39", "it stands across the plane");
      continue;
    }
    vector[axis] = lengthOf(plan, *w);
    given = true;
  }
  if (given) {
    plan.motion.direction = Vec2(vector[letters.u()], vector[letters.v()]);
    if (plan.motion.direction->norm() == 0.0)
      return c.fail(SharedAlarm::kOutOfRange, "I, J, K data out of range: a direction");
  }
  plan.perform = [](IsoContext& context, BlockPlan& planned) {
    return pushMotion(context, planned, PathItem::Kind::kCornerArc);
  };
  return feedStyle(c, plan, plan.motion.feed);
}

}  // namespace proveout::nc
