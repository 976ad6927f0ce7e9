#include "tests/unit/tool/drawings.h"

#include <algorithm>
#include <cmath>

namespace proveout::test {

namespace {

constexpr double kFlute = 15.0;

/// Arc about (cr, cz) between two angles in degrees from the r axis.
void addArc(std::vector<Vec2>& to, double cr, double cz, double radius, double from_deg, double to_deg,
            int steps) {
  const int count = std::max(1, static_cast<int>(std::ceil(steps * std::abs(to_deg - from_deg) / 90.0)));
  for (int i = 0; i <= count; ++i) {
    const double a = degToRad(from_deg + (to_deg - from_deg) * i / count);
    to.emplace_back(cr + radius * std::cos(a), cz + radius * std::sin(a));
  }
}

Tool mill(ToolType type, double diameter) {
  Tool tool;
  tool.type = type;
  tool.diameter = diameter;
  if (!hasNeck(type)) tool.flute_length = kFlute;
  return tool;
}

class Maker {
 public:
  explicit Maker(int steps) : steps_(steps) {}

  void endMills() {
    add("flat", mill(ToolType::kFlat, 6), {{3, 0}, {3, kFlute}});
    Drawing& ball = add("ball", mill(ToolType::kBall, 6), {});
    addArc(ball.outline, 0, 3, 3, -90, 0, steps_);
    ball.outline.emplace_back(3, kFlute);
    Drawing& bull = add("bull", mill(ToolType::kBull, 8), {});
    bull.tool.corner_radius = 1.5;
    addArc(bull.outline, 2.5, 1.5, 1.5, -90, 0, steps_);
    bull.outline.emplace_back(4, kFlute);
    Drawing& cone =
        add("cone", mill(ToolType::kCone, 6), {{0.2, 0}, {3, 2.8 / std::tan(degToRad(30))}, {3, kFlute}});
    cone.tool.tip_diameter = 0.4;
    cone.tool.cone_angle_deg = 60;
    Drawing& drill =
        add("drill", mill(ToolType::kDrill, 5), {{0, 0}, {2.5, 2.5 / std::tan(degToRad(59))}, {2.5, kFlute}});
    drill.tool.point_angle_deg = 118;
  }

  void taperBalls() {
    // A ball of radius 1, 10 degrees a side: it touches the flank where its normal leans 10 degrees down.
    const double t = degToRad(10), r = std::cos(t), z = 1 - std::sin(t);
    Drawing& full = add("taper ball", mill(ToolType::kTaperBall, 5), {});
    addArc(full.outline, 0, 1, 1, -90, -10, steps_);
    full.outline.emplace_back(2.5, z + (2.5 - r) / std::tan(t));
    full.outline.emplace_back(2.5, kFlute);
    Drawing& cut_short = add("taper ball, flutes end on the cone", mill(ToolType::kTaperBall, 9), {});
    addArc(cut_short.outline, 0, 1, 1, -90, -10, steps_);
    cut_short.outline.emplace_back(r + (kFlute - z) * std::tan(t), kFlute);
    for (Drawing* d : {&made_[made_.size() - 2], &made_.back()}) {
      d->tool.tip_diameter = 2;
      d->tool.cone_angle_deg = 20;
    }
  }

  void undercuts() {
    const double slope = 1 / std::tan(degToRad(60));
    Drawing& sharp = add("dovetail", mill(ToolType::kDovetail, 10), {{5, 0}, {5 - 4 * slope, 4}});
    // Round corner of 0.5 inside the diameter; the flank's normal leans 30 degrees up.
    Drawing& round = add("dovetail with a round corner", mill(ToolType::kDovetail, 10), {});
    addArc(round.outline, 4.5, 0.5, 0.5, -90, 30, steps_);
    const Vec2 touch = round.outline.back();
    round.outline.emplace_back(touch.x() - (4 - touch.y()) * slope, 4);
    round.tool.corner_radius = 0.5;
    for (Drawing* d : {&sharp, &round}) {
      d->tool.dovetail_angle_deg = 60;
      d->tool.cutter_height = 4;
      d->tool.neck_diameter = 5;
    }
    Drawing& disc = add("T-slot", mill(ToolType::kTSlot, 12), {{6, 0}, {6, 3}});
    Drawing& rounded = add("T-slot with round corners", mill(ToolType::kTSlot, 12), {});
    addArc(rounded.outline, 5, 1, 1, -90, 0, steps_);
    addArc(rounded.outline, 5, 2, 1, 0, 90, steps_);
    rounded.tool.corner_radius = 1;
    for (Drawing* d : {&disc, &rounded}) {
      d->tool.cutter_height = 3;
      d->tool.neck_diameter = 5;
    }
    Drawing& lollipop = add("lollipop", mill(ToolType::kLollipop, 8), {});
    addArc(lollipop.outline, 0, 4, 4, -90, 60, steps_);  // the neck's radius is 4 cos 60
    lollipop.tool.neck_diameter = 4;
  }

  void threadMills() {
    // Teeth of 60 degrees: a flank rises tan 30 for each mm of depth.
    const double f = 1.5 * std::tan(degToRad(30));
    const auto tooth = [&](std::vector<Vec2>& to, double z, double crest) {
      for (const Vec2& p :
           {Vec2(3.5, z), Vec2(5, z + f), Vec2(5, z + f + crest), Vec2(3.5, z + 2 * f + crest)})
        to.push_back(p);
    };
    Drawing& single = add("thread mill, one tooth", mill(ToolType::kThreadMill, 10), {});
    tooth(single.outline, 0, 0);
    single.tool.pitch = 2;
    Drawing& apart = add("thread mill, teeth apart", mill(ToolType::kThreadMill, 10), {});
    for (int i = 0; i < 3; ++i) tooth(apart.outline, 2.5 * i, 0.25);
    apart.tool.pitch = 2.5;
    apart.tool.teeth = 3;
    apart.tool.crest_flat = 0.25;
    for (Drawing* d : {&single, &apart}) d->tool.root_diameter = 7;
    Drawing& full = add("thread mill, full form", mill(ToolType::kThreadMill, 10), {});
    for (int i = 0; i < 2; ++i) tooth(full.outline, (2 * f + 0.2) * i, 0.2);
    full.tool.pitch = 2 * f + 0.2;
    full.tool.teeth = 2;
    full.tool.crest_flat = 0.2;
  }

  void forms() {
    Drawing& steps = add("form with steps and undercut", mill(ToolType::kForm, 10),
                         {{2, 0}, {3, 1}, {3, 2}, {5, 2}, {5, 3}, {2, 5}, {2, 6}, {4, 7}, {4, 8}});
    for (const Vec2& p : steps.outline) steps.tool.outline.push_back({p.x(), p.y(), 0});
    Drawing& bulge = add("form with a bulge", mill(ToolType::kForm, 8), {{0, 0}, {2, 1}});
    addArc(bulge.outline, 2, 3, 2, -90, 60, steps_);
    bulge.outline.emplace_back(3, 8);
    bulge.tool.outline = {{0, 0}, {2, 1}, {3, 3 + std::sqrt(3.0), 2}, {3, 8}};
    Drawing& hollow = add("corner rounding form", mill(ToolType::kForm, 10), {});
    addArc(hollow.outline, 5, 0, 3, 180, 90, steps_);
    hollow.outline.emplace_back(5, 6);
    hollow.tool.outline = {{2, 0}, {5, 3, -3}, {5, 6}};
    hollow.hollow = kHollowArcToleranceMm;
  }

  std::vector<Drawing> take() {
    for (std::size_t i = 0; i < made_.size(); ++i) made_[i].tool.number = static_cast<int>(i) + 1;
    return std::move(made_);
  }

 private:
  Drawing& add(std::string name, Tool tool, std::vector<Vec2> outline) {
    if (made_.capacity() == 0) made_.reserve(64);  // references stay good
    made_.push_back({std::move(name), std::move(tool), std::move(outline)});
    return made_.back();
  }

  int steps_;
  std::vector<Drawing> made_;
};

double segmentDistance(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 d = b - a;
  const double length2 = d.squaredNorm();
  const double t = length2 > 0 ? std::clamp((p - a).dot(d) / length2, 0.0, 1.0) : 0.0;
  return (p - a - t * d).norm();
}

}  // namespace

double Drawing::radiusAt(double z) const {
  double radius = 0.0;
  for (std::size_t i = 1; i < outline.size(); ++i) {
    const Vec2 &a = outline[i - 1], &b = outline[i];
    if (z < a.y() || z > b.y()) continue;
    const double at =
        b.y() > a.y() ? a.x() + (b.x() - a.x()) * (z - a.y()) / (b.y() - a.y()) : std::max(a.x(), b.x());
    radius = std::max(radius, at);
  }
  return radius;
}

double Drawing::surfaceDistance(double r, double z) const {
  const Vec2 p(r, z);
  double best = std::min(segmentDistance(p, {0, outline.front().y()}, outline.front()),
                         segmentDistance(p, {0, outline.back().y()}, outline.back()));
  for (std::size_t i = 1; i < outline.size(); ++i)
    best = std::min(best, segmentDistance(p, outline[i - 1], outline[i]));
  return best;
}

double Drawing::volume() const {
  double sum = 0.0;
  for (std::size_t i = 1; i < outline.size(); ++i) {
    const double a = outline[i - 1].x(), b = outline[i].x();
    sum += kPi / 3 * (outline[i].y() - outline[i - 1].y()) * (a * a + a * b + b * b);
  }
  return sum;
}

std::vector<Drawing> drawings(int steps) {
  Maker maker(steps);
  maker.endMills();
  maker.taperBalls();
  maker.undercuts();
  maker.threadMills();
  maker.forms();
  return maker.take();
}

}  // namespace proveout::test
