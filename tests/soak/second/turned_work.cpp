// Turned clampings: the motions of both lathes, and templates of the FlexNC one.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/soak/second/makers.h"

namespace proveout::soak::second {
namespace {

using Kind = Step::Kind;

enum Tool { kCorner = 1, kGroove, kRound, kDrill, kBar };

class LatheHand {
 public:
  LatheHand(Dice& dice, const Solid& bar, Control control)
      : dice_(dice),
        radius_(bar.radius),
        inner_(bar.inner),
        low_(bar.base.z()),
        face_(bar.base.z() + bar.length) {
    work_.control = control;
    work_.tools = tools();
  }
  Clamping work() {
    for (int cuts = 1 + dice_.below(4); cuts > 0; --cuts) cut();
    return std::move(work_);
  }

 private:
  std::string tools() {
    const std::string corner =
        "[[@tool]]\nnumber = {}\ntype = \"insert\"\nnose_radius = {}\norientation = {}\ninsert_angle = 55\n"
        "lead_angle = 93\nedge_length = {:.3f}\n";
    std::string text = fmt::format(fmt::runtime(corner), 1, dice_.of({0.0, 0.2, 0.4, 0.8}), 3, 6 + radius_);
    text += fmt::format(
        "[[@tool]]\nnumber = 2\ntype = \"insert\"\nshape = \"groove\"\nwidth = {:.3f}\nnose_radius = {}\n"
        "orientation = 3\nedge_length = {:.3f}\nside_relief = 1\n",
        dice_.mm(0.6, 2.4), dice_.of({0.0, 0.1, 0.2}), radius_ + 3);
    text += fmt::format(
        "[[@tool]]\nnumber = 3\ntype = \"insert\"\nshape = \"round\"\nnose_radius = {:.3f}\norientation = 9\n"
        "points_to = {}\n",
        dice_.mm(0.4, 1.6), dice_.of({3, 8}));
    text += fmt::format("[[@tool]]\nnumber = 4\ntype = \"drill\"\ndiameter = {:.3f}\npoint_angle = 118\n",
                        dice_.mm(0.4, 1.2) * std::max(1.0, std::floor(0.7 * radius_)));
    return text + fmt::format(fmt::runtime(corner), 5, 0.2, 2, 2.5);
  }
  double height() { return dice_.mm(low_ + 0.1 * (face_ - low_), face_); }
  double inward() { return dice_.mm(std::max(0.4 * radius_, inner_ * 0.8), radius_ * 1.02); }
  void add(Kind kind, double x, double z) {
    Step s;
    s.kind = kind;
    s.to = at_ = {x, 0, z};
    work_.steps.push_back(s);
  }
  void rapid(double x, double z) { add(Kind::kRapid, x, z); }
  void line(double x, double z) { add(Kind::kLine, x, z); }
  void words(const std::string& text) {
    Step s;
    s.kind = Kind::kWords;
    s.words = text;
    work_.steps.push_back(s);
  }
  double out() const { return std::ceil(radius_ + 3); }
  double before() const { return std::ceil(face_ + 3); }
  void take(int tool) {
    Step s;
    s.kind = Kind::kTool;
    s.number = tool;
    work_.steps.push_back(s);
    rapid(out(), before());
  }
  void goBack() {
    rapid(out(), at_.z());
    rapid(out(), before());
  }
  void cut() {
    const bool flex = work_.control == Control::kFlexnc;
    switch (dice_.below(flex ? 9 : 7)) {
      case 0:
        return facing();
      case 1:
        return passes();
      case 2:
        return groove();
      case 3:
        return drill();
      case 4:
        return inner_ > 1.5 ? bore() : profile();
      case 5:
      case 6:
        return profile();
      default:
        return cycle();
    }
  }
  void facing() {
    take(kCorner);
    rapid(out(), dice_.mm(face_ - 1, face_));
    line(dice_.oneIn(3) ? inward() : inner_ - (inner_ > 0 ? 0.2 : 0.0), at_.z());
    line(at_.x(), at_.z() + 1);
    rapid(at_.x(), before());
  }
  void passes() {
    take(kCorner);
    double x = radius_;
    const double end = height();
    for (int k = 1 + dice_.below(3); k > 0; --k) {
      x = std::max(0.3 * radius_, x - dice_.mm(0.1, 1.2));
      x = std::round(500 * x) / 500;
      rapid(x, before());
      line(x, end);
      line(x + 0.4, end + 0.4);
      rapid(out(), at_.z());
      rapid(out(), before());
    }
  }
  void groove() {
    take(kGroove);
    const bool off = dice_.oneIn(5);
    rapid(out(), off ? dice_.mm(low_ + 0.4 * (face_ - low_), face_ - 1) : height());
    line(off ? inner_ - (inner_ > 0 ? 0.3 : 0.0) : inward(), at_.z());
    if (!off && dice_.oneIn(3)) line(at_.x(), at_.z() + dice_.mm(-1, 1));
    goBack();
  }
  void drill() {
    take(kDrill);
    rapid(0, before());
    for (int k = 1 + dice_.below(2); k > 0; --k) {
      line(0, dice_.mm(low_ - (dice_.oneIn(4) ? 3 : 0), face_ - 0.5));
      rapid(0, before());
    }
  }
  void bore() {
    take(kBar);
    rapid(inner_ - 0.4, before());
    line(inner_ + dice_.mm(0.1, 0.6) * std::floor(radius_ - inner_), before());
    line(at_.x(), dice_.mm(face_ - 0.5 * (face_ - low_), face_));
    line(inner_ - 0.4, at_.z());
    rapid(at_.x(), before());
  }
  /// Lines and arcs along the bar, towards the chuck.
  void profile() {
    take(dice_.oneIn(2) ? kCorner : kRound);
    double z = face_ + 1;
    rapid(inward(), z);
    for (int k = 2 + dice_.below(4); k > 0; --k) {
      z = at_.z() - dice_.mm(0.1, 0.3) * std::ceil(face_ - low_);
      z = std::round(500 * z) / 500;
      if (dice_.oneIn(3)) {
        arc();
      } else {
        line(dice_.oneIn(3) ? at_.x() : inward(), z);
      }
    }
    goBack();
  }
  /// An arc of whole units, down the bar and outwards or inwards.
  void arc() {
    const double one = dice_.mm(0.002, std::max(0.004, 0.3 * radius_ / 25));
    const auto [a, b, c, d] = dice_.of<std::array<int, 4>>(
        {{0, 25, 25, 0}, {7, 24, 24, 7}, {15, 20, 24, 7}, {7, 24, 20, 15}, {0, 25, 7, 24}});
    Step s;
    s.kind = Kind::kArc;
    s.sense = dice_.oneIn(2) ? 1 : -1;
    // Convex, with its middle inside of the bar, or hollow.
    const double from_x = s.sense < 0 ? a : -b, from_z = s.sense < 0 ? b : -a;
    const double to_x = s.sense < 0 ? c : -d, to_z = s.sense < 0 ? d : -c;
    s.center = at_ - one * Spot(from_x, 0, from_z);
    s.to = at_ = s.center + one * Spot(to_x, 0, to_z);
    work_.steps.push_back(s);
  }
  /// A template of the control, zero at Z0.
  void cycle() {
    const bool drills = dice_.oneIn(4);
    take(drills ? kDrill : kCorner);
    words(drills ? drilling() : shape());
    words("G81X60Z60");
    at_ = {60, 0, 60};
    rapid(out(), before());
  }
  double cycleLength() { return std::max(1.0, std::round(dice_.mm(0.1, 0.6) * (face_ - low_))); }
  std::string drilling() { return fmt::format("G5P{:.1f}Y1Z{:.3f}B3V0", dice_.mm(1, 4), cycleLength()); }
  std::string shape() {
    const double d = std::floor(20 * radius_) / 10, thin = std::round(10 * dice_.mm(0.4, 0.8) * d) / 10;
    const double length = cycleLength(), small = std::min(length, 0.25 * d);
    const int from = dice_.below(2);
    switch (dice_.below(4)) {
      case 0:
        return fmt::format("G77X{:.3f}A{:.3f}Y{:.3f}Z{}P0.8C1B2V0", d, thin, length, from);
      case 1:
        return fmt::format("G12X{:.3f}R{:.3f}Z{}P0.7C1B2V0", d, small, from);
      case 2:
        return fmt::format("G13X{:.3f}R{:.3f}Z{}P0.7C1B2V0", d, small, from);
      default:
        return fmt::format("G79X{:.3f}Y{:.3f}Z{:.3f}P0.5C1B2", d + 1, inner_ > 0 ? 2 * inner_ - 0.4 : 0.0,
                           dice_.mm(0.2, 1.4));
    }
  }

  Dice& dice_;
  double radius_, inner_, low_, face_;
  Clamping work_;
  Spot at_ = Spot::Zero();
};

}  // namespace

Clamping turnedWork(Dice& dice, const Solid& bar, Control control) {
  return LatheHand(dice, bar, control).work();
}

}  // namespace proveout::soak::second
