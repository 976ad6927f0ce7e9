// Plans by seed: one process, or a chain of two.
#include "tests/soak/second/plan.h"

#include <algorithm>

#include "tests/soak/second/makers.h"

namespace proveout::soak::second {
namespace {

Control anyMill(Dice& dice) { return dice.below(3) < 2 ? Control::kNct : Control::kWl4Mill; }
Control anyLathe(Dice& dice) { return dice.oneIn(2) ? Control::kFlexnc : Control::kWl4Lathe; }
double anyTaper(Dice& dice) { return dice.multiple(0.2, 4, 0.05); }

/// On its side, over, or turned; by quarters mostly.
Move anyMove(Dice& dice) {
  Move move =
      turnedBy(dice.of({0.0, 0.0, 90.0, 180.0, -90.0}), dice.of({0.0, 90.0, 180.0, 270.0, 33.7, -147.2}));
  for (int axis = 0; axis < 3; ++axis) move.shift[axis] = dice.mm(-6, 6);
  return move;
}

void fix(Dice& dice, double grid, const Box& region, Clamping& c) {
  Solid clamp;
  const double wide = std::max(3 * grid, 0.3 * region.sizes().x()), high = dice.mm(0, 1.5);
  const double x = region.min().x() - wide - (dice.oneIn(2) ? 0 : dice.mm(0, 1));
  if (dice.oneIn(2)) {
    clamp.min = {x, region.min().y(), region.min().z()};
    clamp.max = {x + wide, region.max().y(), region.max().z() + high};
  } else {
    clamp.shape = Solid::Shape::kRound;
    clamp.radius = 0.5 * wide;
    clamp.base = {x + clamp.radius, region.center().y(), region.min().z()};
    clamp.length = std::max(region.sizes().z() + high, 3 * grid);
  }
  c.fixtures = {clamp};
}

void milled(Dice& dice, Plan& plan, Control control) {
  plan.blank = milledBlank(dice, plan.grid);
  plan.clampings = {milledWork(dice, plan.blank.bounds(), plan.grid, control)};
  if (dice.oneIn(5)) fix(dice, plan.grid, plan.blank.bounds(), plan.clampings[0]);
}

void turned(Dice& dice, Plan& plan, Control control) {
  plan.blank = barBlank(dice, plan.grid);
  plan.clampings = {turnedWork(dice, plan.blank, control)};
}

void wired(Dice& dice, Plan& plan, double taper_deg) {
  plan.blank = uprightBlank(dice, plan.grid);
  plan.clampings = {wireWork(dice, plan.blank.bounds(), taper_deg)};
  const Step& first = plan.clampings[0].steps.front();
  const Box box = plan.blank.bounds();
  const double room =
      std::min((first.to - box.min()).head<2>().minCoeff(), (box.max() - first.to).head<2>().minCoeff());
  if (plan.blank.shape == Solid::Shape::kBox && room > 0.6 && dice.oneIn(2))
    plan.start_holes = {{first.to, 1.0}};
}

/// Another clamping behind.
void goOn(Dice& dice, Plan& plan, Control control) {
  const Move move = anyMove(dice);
  const Box region = movedBounds(plan.blank.bounds(), move);
  Clamping next = control == Control::kWedm ? wireWork(dice, region, dice.oneIn(4) ? anyTaper(dice) : 0)
                                            : milledWork(dice, region, plan.grid, control);
  next.move = move;
  plan.clampings.push_back(next);
}

/// The bar turned over, or drawn out.
void goOnTurning(Dice& dice, Plan& plan, Control control) {
  Move move = turnedBy(dice.of({0.0, 180.0}), dice.of({0.0, 0.0, 90.0, 33.7}));
  move.shift.z() = dice.mm(-4, 4);
  Solid bar = plan.blank;
  bar.base = movedBounds(bar.bounds(), move).center() - 0.5 * bar.length * Spot::UnitZ();
  bar.base.head<2>().setZero();
  Clamping next = turnedWork(dice, bar, control);
  next.move = move;
  plan.clampings.push_back(next);
}

/// A process or a chain, and how many of sixteen plans have it.
struct Row {
  const char* process;
  int share;
  void (*make)(Dice&, Plan&);
};

constexpr Row kRows[] = {
    {"nct mill", 2, [](Dice& dice, Plan& plan) { milled(dice, plan, Control::kNct); }},
    {"wl4 mill", 1, [](Dice& dice, Plan& plan) { milled(dice, plan, Control::kWl4Mill); }},
    {"wl4 lathe", 1, [](Dice& dice, Plan& plan) { turned(dice, plan, Control::kWl4Lathe); }},
    {"flexnc lathe", 1, [](Dice& dice, Plan& plan) { turned(dice, plan, Control::kFlexnc); }},
    {"wire", 2, [](Dice& dice, Plan& plan) { wired(dice, plan, 0); }},
    {"tapered wire", 1, [](Dice& dice, Plan& plan) { wired(dice, plan, anyTaper(dice)); }},
    {"mill > mill", 2,
     [](Dice& dice, Plan& plan) {
       milled(dice, plan, anyMill(dice));
       goOn(dice, plan, anyMill(dice));
     }},
    {"lathe > mill", 2,
     [](Dice& dice, Plan& plan) {
       turned(dice, plan, anyLathe(dice));
       goOn(dice, plan, anyMill(dice));
     }},
    {"lathe > lathe", 1,
     [](Dice& dice, Plan& plan) {
       turned(dice, plan, anyLathe(dice));
       goOnTurning(dice, plan, anyLathe(dice));
     }},
    {"wire > mill", 1,
     [](Dice& dice, Plan& plan) {
       wired(dice, plan, dice.oneIn(4) ? anyTaper(dice) : 0);
       goOn(dice, plan, anyMill(dice));
     }},
    {"mill > wire", 1,
     [](Dice& dice, Plan& plan) {
       milled(dice, plan, anyMill(dice));
       goOn(dice, plan, Control::kWedm);
     }},
    {"lathe > wire", 1,
     [](Dice& dice, Plan& plan) {
       turned(dice, plan, anyLathe(dice));
       goOn(dice, plan, Control::kWedm);
     }},
};

void fill(Dice& dice, Plan& plan) {
  int number = dice.below(16);
  const Row* row = kRows;
  while (number >= row->share) number -= (row++)->share;
  plan.process = row->process;
  row->make(dice, plan);
}

}  // namespace

Plan makePlan(std::uint64_t seed) {
  Dice dice(seed, 51);
  Plan plan;
  plan.grid = dice.of({0.3, 0.4, 0.5, 0.7, 0.8});
  plan.profile = dice.of({0.01, 0.02, 0.05});
  fill(dice, plan);
  plan.plain = plan.clampings.size() == 1 && dice.oneIn(2);
  return plan;
}

}  // namespace proveout::soak::second
