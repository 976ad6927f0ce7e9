// Clampings that a wire cuts.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/soak/second/makers.h"

namespace proveout::soak::second {
namespace {

using Kind = Step::Kind;

Spot said(const Spot& p) { return (500 * p).array().round().matrix() / 500; }

class WireHand {
 public:
  WireHand(Dice& dice, const Box& region, double taper_deg)
      : dice_(dice), box_(region), taper_deg_(taper_deg) {
    work_.control = Control::kWedm;
    work_.bottom = region.min().z();
    work_.height = region.sizes().z();
    const double diameter = dice.of({0.1, 0.2, 0.25}), gap = dice.of({0.0, 0.01, 0.015});
    kerf_ = 0.5 * diameter + gap;
    work_.tools = fmt::format(
        "[[@tool]]\nnumber = 1\ntype = \"wire\"\ndiameter = {:.3f}\nspark_gap = {:.3f}\n", diameter, gap);
    work_.radii = {{1, kerf_}, {2, kerf_ + 0.05}};
  }
  Clamping work() {
    for (int contours = 1 + dice_.below(3); contours > 0; --contours) contour();
    return std::move(work_);
  }

 private:
  void add(Kind kind, const Spot& to) {
    Step s;
    s.kind = kind;
    s.to = at_ = to;
    work_.steps.push_back(s);
  }
  void code(Kind kind, int number, double value = 0) {
    Step s;
    s.kind = kind;
    s.number = number;
    (kind == Kind::kSide ? s.level : s.angle) = value;
    work_.steps.push_back(s);
  }
  void arcTo(const Spot& center, const Spot& to, int sense) {
    Step s;
    s.kind = Kind::kArc;
    s.to = at_ = to;
    s.center = center;
    s.sense = sense;
    work_.steps.push_back(s);
  }
  void comeTo(const Spot& p) { add(work_.steps.empty() ? Kind::kRapid : Kind::kCut, p); }
  Spot middle() {
    const Spot size = box_.sizes();
    return said({dice_.mm(box_.min().x() + 0.2 * size.x(), box_.max().x() - 0.2 * size.x()),
                 dice_.mm(box_.min().y() + 0.2 * size.y(), box_.max().y() - 0.2 * size.y()), 0});
  }
  double most() const { return 0.5 * std::min(box_.sizes().x(), box_.sizes().y()); }

  void contour() {
    switch (dice_.below(5)) {
      case 0:
        return slit();
      case 1:
        return disc();
      case 2:
        return slot();
      default:
        return polygon();
    }
  }
  /// From beside the blank, across it or to somewhere in it, without an offset.
  void slit() {
    const int along = dice_.below(2);
    Spot from = middle(), to = middle();
    from[along] = box_.min()[along] - 1;
    to[along] = dice_.oneIn(2) ? box_.max()[along] + 1 : to[along];
    from = said(from);
    comeTo(from);
    if (dice_.oneIn(2)) add(Kind::kLine, middle());
    add(Kind::kLine, said(to));
  }
  void offsets(bool left) {
    code(Kind::kSide, left ? 41 : 42, dice_.oneIn(3) ? 2 : 1);
    if (taper_deg_ > 0) code(Kind::kLean, dice_.of({51, 52}), taper_deg_);
  }
  void noOffsets() {
    code(Kind::kSide, 40);
    if (taper_deg_ > 0) code(Kind::kLean, 50);
  }
  void disc() {
    const Spot center = middle();
    const double one = std::max(0.002 * std::round(500 * dice_.mm(0.2, 0.7) * most() / 25), 0.02);
    const bool inside = dice_.oneIn(2);
    const int sense = dice_.oneIn(2) ? 1 : -1;
    const Spot start = center + one * Spot(25, 0, 0), beside = inside ? center : start + Spot(2, 0, 0);
    comeTo(beside);
    offsets((sense > 0) == inside);
    add(Kind::kLine, start);
    if (taper_deg_ > 0 || dice_.oneIn(2)) {
      for (const auto& [a, b] :
           {std::array{0, 25}, std::array{-25, 0}, std::array{0, -25}, std::array{25, 0}})
        arcTo(center, center + one * Spot(a, sense * b, 0), sense);
    } else {
      arcTo(center, center - one * Spot(25, 0, 0), sense);
      arcTo(center, start, sense);
    }
    noOffsets();
    add(Kind::kLine, beside);
  }
  /// A slot with round ends.
  void slot() {
    const Spot center = middle();
    const double r = 0.002 * std::round(500 * std::max(0.5, 0.25 * most())),
                 half = 0.002 * std::round(500 * 0.3 * most());
    comeTo(center);
    const Spot up(0, r, 0), side(half, 0, 0);
    offsets(true);
    add(Kind::kLine, center - up);
    add(Kind::kLine, center - up + side);
    arcTo(center + side, center + up + side, 1);
    add(Kind::kLine, center + up - side);
    arcTo(center - side, center - up - side, 1);
    add(Kind::kLine, center - up);
    noOffsets();
    add(Kind::kLine, center);
  }
  /// Its points are each at an angle of its own about the middle, counter-clockwise.
  void polygon() {
    const Spot center = middle();
    const int n = 3 + dice_.below(5);
    const double size = dice_.mm(0.3, 0.9) * most();
    std::vector<Spot> points;
    for (int k = 0; k < n; ++k) {
      const double w = 2 * 3.14159265358979 * (k + 0.4 * dice_.multiple(0, 1, 0.01)) / n;
      points.push_back(
          said(center + size * dice_.multiple(0.6, 1, 0.01) * Spot(std::cos(w), std::sin(w), 0)));
    }
    const bool inside = dice_.oneIn(2);
    const Spot start = said(0.5 * (points[0] + points[1]));
    const Spot beside =
        inside ? center : said(center + (start - center) * (1 + 1.6 / (start - center).norm()));
    comeTo(beside);
    for (int pass = dice_.oneIn(3) ? 2 : 1; pass > 0; --pass) {
      code(Kind::kSide, inside ? 41 : 42, pass);
      if (taper_deg_ > 0) code(Kind::kLean, dice_.of({51, 52}), taper_deg_);
      add(Kind::kLine, start);
      for (int k = 1; k <= n; ++k) {
        add(Kind::kLine, points[static_cast<std::size_t>(k % n)]);
        if (dice_.oneIn(3)) work_.steps.back().round = std::max(0.002 * std::round(40 * size), 0.3);
      }
      add(Kind::kLine, start);
      noOffsets();
      add(Kind::kLine, beside);
    }
  }

  Dice& dice_;
  Box box_;
  double taper_deg_, kerf_ = 0;
  Clamping work_;
  Spot at_ = Spot::Zero();
};

}  // namespace

Clamping wireWork(Dice& dice, const Box& region, double taper_deg) {
  return WireHand(dice, region, taper_deg).work();
}

}  // namespace proveout::soak::second
