// Milled clampings.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/soak/second/makers.h"

namespace proveout::soak::second {
namespace {

using Kind = Step::Kind;

/// Points of a circle of 25 units that whole units can say.
constexpr std::array<std::array<int, 2>, 20> kRim = {{{25, 0},  {24, 7},   {20, 15},   {15, 20},   {7, 24},
                                                      {0, 25},  {-7, 24},  {-15, 20},  {-20, 15},  {-24, 7},
                                                      {-25, 0}, {-24, -7}, {-20, -15}, {-15, -20}, {-7, -24},
                                                      {0, -25}, {7, -24},  {15, -20},  {20, -15},  {24, -7}}};

class MillHand {
 public:
  MillHand(Dice& dice, const Box& region, double grid, Control control)
      : dice_(dice), box_(region), grid_(grid) {
    work_.control = control;
  }

  Clamping work() {
    const int tools = 1 + dice_.below(3);
    for (number_ = 1; number_ <= tools; ++number_) {
      const double sides = std::min(box_.sizes().x(), box_.sizes().y());
      diameter_ = std::max(dice_.of({2.1, 3.3, 0.9}) * grid_, dice_.mm(0.1 * sides, 0.6 * sides));
      diameter_ = std::round(500 * diameter_) / 500;
      work_.tools += toolOf();
      Step tool;
      tool.kind = Kind::kTool;
      tool.number = number_;
      work_.steps.push_back(tool);
      rapid(high(spot()));
      for (int cuts = 1 + dice_.below(4); cuts > 0; --cuts) cut();
    }
    return std::move(work_);
  }

 private:
  std::string toolOf() {
    if (number_ != 1 || !dice_.oneIn(2)) return milledTool(dice_, number_, diameter_);
    work_.radii[1] = 0.5 * diameter_;
    has_side_ = true;
    return fmt::format("[[@tool]]\nnumber = 1\ntype = \"flat\"\ndiameter = {:.3f}\n", diameter_);
  }
  double x(double out = 0.15) { return inside(0, out); }
  double inside(int axis, double out) {
    const double beyond = out * box_.sizes()[axis];
    return dice_.mm(box_.min()[axis] - beyond, box_.max()[axis] + beyond);
  }
  Spot spot() { return {inside(0, 0.1), inside(1, 0.1), depth()}; }
  double depth() {
    const double top = box_.max().z(), height = box_.sizes().z();
    if (dice_.oneIn(12)) return box_.min().z();
    return dice_.mm(top - 0.8 * height, top - 0.02 * height);
  }
  double safe() const { return std::ceil(box_.max().z() + 3); }
  Spot high(Spot p) const { return {p.x(), p.y(), safe()}; }
  void add(Kind kind, const Spot& to) {
    Step s;
    s.kind = kind;
    s.to = at_ = to;
    work_.steps.push_back(s);
  }
  void rapid(const Spot& to) { add(Kind::kRapid, to); }
  void line(const Spot& to) { add(Kind::kLine, to); }
  /// Above a place, then down to it.
  void goTo(const Spot& p) {
    rapid(high(at_));
    rapid(high(p));
    line(p);
  }

  void cut() {
    switch (dice_.below(9)) {
      case 0:
        return weave();
      case 1:
        return holes();
      case 2:
        return turnsDown();
      case 3:
        return rim();
      case 4:
        if (has_side_ && number_ == 1) return contour();
        return walk();
      case 5:
        if (dice_.oneIn(2)) return hasty();
        return walk();
      default:
        return walk();
    }
  }
  void walk() {
    goTo(spot());
    for (int k = 1 + dice_.below(4); k > 0; --k) {
      Spot to = spot();
      if (!dice_.oneIn(3)) to.z() = at_.z();
      const int kept = dice_.below(6);
      if (kept < 2) to[kept] = at_[kept];
      line(to);
    }
    rapid(high(at_));
  }
  void weave() {
    const int n = 2 + dice_.below(4), along = dice_.below(2), across = 1 - along;
    Spot from = spot(), to = from, stride = Spot::Zero();
    from[along] = box_.min()[along] - dice_.mm(0, 2);
    to[along] = box_.max()[along] + dice_.mm(0, 2);
    stride[across] = dice_.mm(0.3, 1.1) * std::max(1.0, std::round(diameter_ / 2));
    stride[across] = std::round(stride[across] * 500) / 500;
    if (dice_.oneIn(3)) stride.z() = -dice_.mm(0.02, 0.2);
    from = said(from);
    to = said(to);
    goTo(from);
    Step s;
    s.kind = Kind::kWeave;
    s.number = n;
    s.to = to;
    s.center = from;
    s.stride = stride;
    work_.steps.push_back(s);
    at_ = from + (n - 1) * stride;
    rapid(high(at_));
  }
  void holes() {
    rapid(high(at_));
    for (int k = 1 + dice_.below(3); k > 0; --k) {
      Step s;
      s.kind = Kind::kHole;
      s.number = dice_.of({81, 83, 73, 85});
      s.to = spot();
      s.level = std::ceil(box_.max().z() + 0.5);
      s.peck = dice_.mm(0.6, 3);
      work_.steps.push_back(s);
      at_ = high(s.to);
    }
  }
  void arcTo(const Spot& center, const Spot& to, int sense) {
    Step s;
    s.kind = Kind::kArc;
    s.to = at_ = to;
    s.center = center;
    s.sense = sense;
    work_.steps.push_back(s);
  }
  double unit() {
    const double most = 0.4 * std::min(box_.sizes().x(), box_.sizes().y());
    return dice_.mm(0.002, std::max(0.004, most / 25));
  }
  Spot onRim(const Spot& center, double unit, int place) const {
    const auto& [a, b] = kRim[static_cast<std::size_t>(place % 20)];
    return center + unit * Spot(a, b, 0);
  }
  void rim() {
    const Spot center = spot();
    const double one = unit();
    int place = dice_.below(20);
    goTo(onRim(center, one, place));
    for (int k = 1 + dice_.below(2); k > 0; --k) {
      const int next = dice_.oneIn(3) ? place : dice_.below(20);
      arcTo(center, onRim(center, one, next), dice_.oneIn(2) ? 1 : -1);
      place = next;
    }
    rapid(high(at_));
  }
  void turnsDown() {
    Spot center = spot();
    const double low = center.z(), one = unit();
    const int n = 1 + dice_.below(3), place = dice_.below(20), sense = dice_.oneIn(2) ? 1 : -1;
    center.z() = box_.max().z() + dice_.mm(0, 0.4);
    const double fall = std::round((center.z() - low) / n * 500) / 500;
    goTo(onRim(center, one, place));
    for (int k = 1; k <= n; ++k) arcTo(center, onRim(center - k * fall * Spot::UnitZ(), one, place), sense);
    arcTo(center, at_, sense);
    rapid(high(at_));
  }
  void side(int number) {
    Step s;
    s.kind = Kind::kSide;
    s.number = number;
    work_.steps.push_back(s);
  }
  /// Clockwise round a rectangle with rounded corners, the tool outside of it.
  void contour() {
    const double w = dice_.mm(0.3, 0.8) * std::floor(box_.sizes().x()),
                 h = dice_.mm(0.3, 0.8) * std::floor(box_.sizes().y());
    const Spot low = said({x(0) - 0.5 * w, inside(1, 0) - 0.5 * h, depth()}), size = said({w, h, 0});
    const double r = std::min(25 * unit(), 0.4 * std::min(size.x(), size.y())), out = diameter_ + 1;
    const double round = std::round(r * 500) / 500, z = low.z();
    const Spot far = low + size, start(low.x() - out, low.y() - out, z);
    goTo(start);
    side(41);
    line({low.x(), low.y() - 0.5 * out, z});
    line({low.x(), far.y() - round, z});
    arcTo({low.x() + round, far.y() - round, z}, {low.x() + round, far.y(), z}, -1);
    line({far.x() - round, far.y(), z});
    arcTo({far.x() - round, far.y() - round, z}, {far.x(), far.y() - round, z}, -1);
    line({far.x(), low.y(), z});
    line({low.x() - 0.5 * out, low.y(), z});
    side(40);
    line(start);
    rapid(high(at_));
  }
  static Spot said(const Spot& p) { return (500 * p).array().round().matrix() / 500; }
  /// A rapid where material is: along a side that it overlaps by parts of a cell, or straight through.
  void hasty() {
    const int along = dice_.below(2), across = 1 - along;
    Spot from = spot(), to;
    if (dice_.below(3) < 2) {
      const double over = dice_.mm(0.02, 0.7 * grid_), r = 0.5 * diameter_;
      from[across] = dice_.oneIn(2) ? box_.min()[across] - r + over : box_.max()[across] + r - over;
    }
    from[along] = box_.min()[along] - diameter_ - 2;
    from = said(from);
    to = from;
    to[along] = std::ceil(box_.max()[along] + diameter_ + 2);
    goTo(from);
    rapid(to);
    rapid(high(at_));
  }

  Dice& dice_;
  Box box_;
  double grid_, diameter_ = 0;
  Clamping work_;
  Spot at_ = Spot::Zero();
  int number_ = 1;
  bool has_side_ = false;
};

/// Where it ends above and what holds it.
std::string aboveTool(Dice& dice, double d) {
  if (!dice.oneIn(3)) return "";
  const double flutes = std::max(1.2 * d, dice.mm(2, 8)), all = flutes + dice.mm(2, 8);
  std::string text = fmt::format("flute_length = {:.3f}\noverall_length = {:.3f}\n", flutes, all);
  if (dice.oneIn(2)) text += fmt::format("shank_diameter = {:.3f}\n", d * dice.of({0.8, 1.0, 1.3}));
  if (dice.oneIn(2)) text += fmt::format("holder = [[0, {0:.3f}], [10, {0:.3f}]]\n", 0.8 * d + 1);
  return text;
}

std::string endMill(Dice& dice, int kind, double d) {
  if (kind == 4) return fmt::format("\"drill\"\npoint_angle = {}\n", dice.of({90, 118, 140}));
  if (kind < 2) return "\"ball\"\n" + aboveTool(dice, d);
  if (kind == 12) return "\"flat\"\n" + aboveTool(dice, d);
  return fmt::format("\"bull\"\ncorner_radius = {:.3f}\n", d * dice.of({0.1, 0.25, 0.4})) +
         aboveTool(dice, d);
}

std::string shapedTool(Dice& dice, int kind, double d) {
  switch (kind) {
    case 5:
      return fmt::format("\"cone\"\ncone_angle = {}\ntip_diameter = {:.3f}\n", dice.of({60, 90, 100}),
                         d * dice.of({0.0, 0.2, 0.5}));
    case 6:
      return fmt::format("\"taper\"\ntaper_angle = {}\n{} = {:.3f}\n", dice.of({3, 8, 15}),
                         dice.oneIn(2) ? "tip_diameter" : "ball_diameter", 0.5 * d);
    case 7:
      return fmt::format("\"dovetail\"\ndovetail_angle = 60\nheight = {:.3f}\nneck_diameter = {:.3f}\n",
                         0.35 * d, 0.45 * d);
    case 8:
      return fmt::format("\"tslot\"\nthickness = {0:.3f}\nneck_diameter = {0:.3f}\ncorner_radius = {1:.3f}\n",
                         0.4 * d, dice.of({0.0, 0.08}) * d);
    case 9:
      return fmt::format("\"lollipop\"\nneck_diameter = {:.3f}\n", 0.5 * d);
    default:
      return fmt::format("\"thread-mill\"\npitch = {:.3f}\nteeth = {}\n", 0.3 * d, 1 + dice.below(3));
  }
}

/// A hollow or bulging side below a straight one.
std::string formTool(Dice& dice, double d) {
  return fmt::format("\"form\"\nprofile = [[{0:.3f}, 0], [{1:.3f}, {2:.3f}, {3:.3f}], [{1:.3f}, {4:.3f}]]\n",
                     0.25 * d, 0.5 * d, 0.25 * d, dice.of({0.25, 0.4, -0.4}) * d, 0.6 * d);
}

}  // namespace

std::string milledTool(Dice& dice, int number, double d) {
  const int kind = dice.below(13);
  const std::string table = fmt::format("[[@tool]]\nnumber = {}\ntype = ", number);
  if (kind == 11) return table + formTool(dice, d);
  const std::string words = kind < 5 || kind == 12 ? endMill(dice, kind, d) : shapedTool(dice, kind, d);
  return table + words + fmt::format("diameter = {:.3f}\n", d);
}

Clamping milledWork(Dice& dice, const Box& region, double grid, Control control) {
  return MillHand(dice, region, grid, control).work();
}

}  // namespace proveout::soak::second
