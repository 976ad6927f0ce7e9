// What tools sweep whose axis turns, against dense references: places of the way itself, between which the
// tool's distance can change by no more than a point of it can move.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "removal/sweep/motion_bodies.h"
#include "tests/property/drawn_outline.h"
#include "tests/property/random_moves.h"
#include "tests/property/swept_columns.h"
#include "tests/support/golden_section.h"
#include "tests/support/posed_motions.h"
#include "tests/unit/tool/drawings.h"

namespace proveout {
namespace posed_sweep_test {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
/// Chords that arcs are drawn with a quarter turn: within 2e-6 mm.
constexpr int kSteps = 800;
constexpr double kWrongMm = 1e-4;
/// References of distances are proven to this, mm.
constexpr double kProvenMm = 2e-5;

/// So many times as many motions as usual.
int effort() {
  const char* asked = std::getenv("PROVEOUT_POSED_MOTIONS");
  return asked != nullptr ? std::max(1, std::atoi(asked)) : 1;
}

class Reference {
 public:
  Reference(const test::DrawnOutline& outline, const PosedWay& way) : outline_(outline), way_(way) {
    bounds_ = way.boundsOn(0.0, 1.0);
  }

  double toolDistance(const Vec3& p, double s) const {
    const ToolPose pose = way_.at(s);
    const Vec3 q = p - pose.tip;
    const double z = q.dot(pose.axis);
    return outline_.distance((q - z * pose.axis).norm(), z);
  }
  /// Whether the tool comes to hold the point; what is nearer to its surface than a micrometre may be either.
  bool holds(const Vec3& p) const {
    const double a = toolDistance(p, 0.0), b = toolDistance(p, 1.0);
    return a < 0.0 || b < 0.0 || holdsBetween(p, 0.0, a, 1.0, b);
  }
  /// The least distance, negative inside; above it by kProvenMm at most. `known`: a value that is no lower.
  double distance(const Vec3& p, double known) const {
    double best = known;
    const double a = toolDistance(p, 0.0), b = toolDistance(p, 1.0);
    best = std::min({best, a, b});
    lower(p, 0.0, a, 1.0, b, best);
    return best;
  }

 private:
  /// A point of the tool, or beside it, that far from the tip moves no farther between two shares.
  double mostWay(const Vec3& p, double s0, double s1) const {
    const PosedWay::Bounds b = s1 - s0 < 0.05 ? way_.boundsOn(s0, s1) : bounds_;
    const double far = (p - way_.at(0.5 * (s0 + s1)).tip).norm() + 0.5 * b.tip.velocity * (s1 - s0);
    return (b.tip.velocity + b.axis.velocity * far) * (s1 - s0);
  }
  bool holdsBetween(const Vec3& p, double s0, double d0, double s1, double d1) const {
    const double way = mostWay(p, s0, s1);
    if (d0 + d1 - way >= 0.0 || way < 1e-6) return false;
    const double middle = 0.5 * (s0 + s1), d = toolDistance(p, middle);
    return d < 0.0 || holdsBetween(p, s0, d0, middle, d) || holdsBetween(p, middle, d, s1, d1);
  }
  void lower(const Vec3& p, double s0, double d0, double s1, double d1, double& best) const {
    const double way = mostWay(p, s0, s1);
    if (0.5 * (d0 + d1 - way) >= best - kProvenMm || way < 1e-9) return;
    const double middle = 0.5 * (s0 + s1), d = toolDistance(p, middle);
    best = std::min(best, d);
    const bool first = d0 < d1;
    if (first) lower(p, s0, d0, middle, d, best);
    lower(p, middle, d, s1, d1, best);
    if (!first) lower(p, s0, d0, middle, d, best);
  }

  const test::DrawnOutline& outline_;
  const PosedWay& way_;
  PosedWay::Bounds bounds_;
};

/// What the engine says of one cutter on one motion.
struct Bodies {
  Bodies(const test::PosedMotion& motion, const std::vector<ConvexProfile>& parts) : path(motion.path()) {
    for (const ConvexProfile& part : parts) solids.push_back(columnSolid(part));
    BodyMaker maker(path, 1.0, 100.0, store);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      for (const MotionBody& made : maker.make(0, {&parts[k], &solids[k], true, true}))
        all.push_back(made.body);
      fields.push_back(motionField(parts[k], wayOf(path, path.motions[0])));
    }
  }
  double distance(const Vec3& p) const {
    double least = kInf;
    for (const SweptField& field : fields) least = std::min(least, field.distance(p, kInf));
    return least;
  }
  SweepSample sample(const Vec3& p) const {
    SweepSample least{kInf, Vec3::Zero(), 0};
    for (const SweptField& field : fields) {
      const SweepSample s = field.sample(p);
      if (s.value < least.value) least = s;
    }
    return least;
  }
  Box3 bounds() const {
    Box3 box;
    for (const SweptField& field : fields) box.extend(field.bounds());
    return box;
  }
  /// The intervals of a column, joined.
  std::vector<std::array<double, 2>> spans(double x, double y) const {
    return test::columnSpans(all, x, y, 1e-9);
  }

  Toolpath path;
  BodyStore store;
  std::vector<ColumnSolid> solids;
  std::vector<SweptBody> all;
  std::vector<SweptField> fields;
};

/// Motions of every law, on machines of every kind.
class PosedSweeps : public ::testing::TestWithParam<std::size_t> {
 protected:
  double random(double low, double high) { return moves_.number(low, high); }
  Vec3 within(double most) { return {random(-most, most), random(-most, most), random(-most, most)}; }
  Vec3 direction() { return within(1.0).normalized(); }
  MachineModel machine(int kind) {
    return kind == 0   ? test::headHead('B', {10, 0, 150}, {0, 25, 60})
           : kind == 1 ? test::trunnion('A')
                       : test::headTable();
  }
  test::PosedMotion axes(int style) {
    const int kind = style % 3;
    // The part lies about the tables, where there are any.
    const Vec3 origin = kind == 0 ? Vec3::Zero() : Vec3(Vec3(400, 300, -460) + within(15.0));
    const double first = random(-90, 90), second = random(-200, 200), length = random(0.0, 120.0);
    const double turn = style % 7 == 6 ? 2400.0 : style % 5 == 1 ? 3.0 : 90.0;
    const Vec3 place = origin + within(15.0);
    const double up = kind == 1 ? length : length + 20.0;
    const AxisPoint a = test::axesAt(place + Vec3(0, 0, up), first, second);
    const AxisPoint b =
        test::axesAt(place + Vec3(0, 0, up) + within(8.0), first + random(-0.5, 0.5) * std::min(turn, 90.0),
                     second + random(-0.5, 0.5) * turn);
    return test::axesMotion(machine(kind), a, b, length, origin);
  }
  test::PosedMotion motion(int i) {
    const int law = i % 5, style = i / 5;
    test::PosedMotion m = axes(style);
    if (law == 0) return m;
    m.motion.from = within(6.0);
    m.motion.to = m.motion.from + random(0.0, style % 3 == 0 ? 1.0 : 20.0) * direction();
    if (law == 1) {
      m.axis.law = PoseLaw::kTip;
    } else if (law == 2 || law == 3) {
      m.axis.from = direction();
      m.axis.to = style % 2 == 0 ? direction() : Vec3((m.axis.from + 0.3 * direction()).normalized());
      m.axis.law = PoseLaw::kVector;
      m.axis.pose = nullptr;
      if (style % 4 == 1) m.motion.to = m.motion.from;
    } else {
      m.axis.law = PoseLaw::kTip;
      auto pose = std::make_shared<PoseSweep>(*m.axis.pose);
      pose->beyond = style % 2 == 0 ? 0.0 : random(-3.0, 3.0);
      m.axis.pose = pose;
    }
    if (law >= 3) {
      m.is_arc = true;
      m.arc.normal = direction();
      m.arc.center = m.motion.from + random(1.0, 12.0) * m.arc.normal.unitOrthogonal();
      m.arc.sweep_rad = random(-5.0, 5.0);
      if (law == 3) m.axis.law = PoseLaw::kCone;
    }
    return m;
  }

  test::RandomMoves moves_{77};
};

TEST_P(PosedSweeps, NoPointIsOnTheWrongSide) {
  const test::Drawing drawing = test::drawings(kSteps)[GetParam()];
  const test::DrawnOutline outline(drawing);
  const ToolSolid solid = makeToolSolid(drawing.tool);
  const double slack = drawing.hollow + kWrongMm;
  double wrong = 0.0, off_ends = 0.0, off_distance = 0.0, aside = 0.0, beyond = 0.0;
  int inside = 0, samples = 0, columns = 0;
  const int motions = 15 * effort();
  for (int i = 0; i < motions; ++i) {
    const test::PosedMotion m = motion(i);
    const PosedWay way = m.way();
    const Bodies bodies(m, solid.cutter);
    const Reference reference(outline, way);
    const Box3 box = bodies.bounds().inflated(1e-9);
    for (int c = 0; c < 6; ++c) {
      // A column through a point near the tool at some pose.
      const ToolPose pose = way.at(random(0, 1));
      const double r = drawing.tool.diameter * random(-0.6, 0.6), up = random(-1.0, outline.reach());
      const Vec3 at = pose.tip + up * pose.axis + r * pose.axis.cross(direction()).normalized();
      const auto covered = bodies.spans(at.x(), at.y());
      ++columns;
      std::vector<double> heights{at.z()};
      for (int k = 0; k < 3; ++k) heights.push_back(at.z() + random(-8.0, 8.0));
      for (const auto& s : covered) {
        for (const double z : s) {
          off_ends = std::max(off_ends, std::abs(reference.distance({at.x(), at.y(), z}, kInf)));
          ASSERT_LE(off_ends, slack) << drawing.name << ", motion " << i << ", column " << at.transpose()
                                     << ", end " << z << " engine " << bodies.distance({at.x(), at.y(), z});
          heights.push_back(z + random(-0.02, 0.02));
        }
      }
      for (const double z : heights) {
        const Vec3 p(at.x(), at.y(), z);
        const bool in =
            std::any_of(covered.begin(), covered.end(), [&](const auto& s) { return s[0] < z && z < s[1]; });
        ++samples;
        inside += in ? 1 : 0;
        const double said = bodies.distance(p), least = reference.distance(p, said + 1.0);
        if (reference.holds(p) != in) wrong = std::max(wrong, std::abs(least));
        ASSERT_LE(wrong, slack) << drawing.name << ", motion " << i << " at " << p.transpose() << " engine "
                                << said;
        // Parts are asked one by one: where they meet the depth of all together is more.
        if (said > 0.0 || solid.cutter.size() == 1)
          off_distance = std::max(off_distance, std::abs(said - least));
        ASSERT_LE(off_distance, slack + kProvenMm)
            << drawing.name << ", motion " << i << " at " << p.transpose();
        if (in) beyond = std::max({beyond, (box.min - p).maxCoeff(), (p - box.max).maxCoeff()});
        // The gradient leads to the surface.
        if (said > 0.01 && said < 5.0) {
          const SweepSample s = bodies.sample(p);
          ASSERT_NEAR(s.gradient.norm(), 1.0, 1e-9);
          aside = std::max(aside, std::abs(bodies.distance(p - s.value * s.gradient)));
        }
      }
    }
  }
  EXPECT_GT(inside, samples / 50);
  EXPECT_LE(beyond, 0.0);
  EXPECT_LE(aside, slack);
  std::printf(
      "%s: %d columns, %d samples, %d inside; largest error %.3g mm, of ends of columns %.3g mm, of "
      "distances "
      "%.3g mm, of feet %.3g mm\n",
      drawing.name.c_str(), columns, samples, inside, wrong, off_ends, off_distance, aside);
}

INSTANTIATE_TEST_SUITE_P(Tools, PosedSweeps, ::testing::Range(std::size_t{0}, test::drawings(1).size()));

}  // namespace
}  // namespace posed_sweep_test
}  // namespace proveout
