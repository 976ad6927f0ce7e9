// The turning examples of the WL4 manual, run on the control and turned: TEST_G77 and TEST_G78.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/nc/registry/interpreter.h"
#include "tests/unit/turning/turning_fixture.h"

namespace proveout {
namespace {

class OneProgram : public ProgramSource {
 public:
  explicit OneProgram(std::string text) : text_(std::move(text)) {}
  Result<ProgramText> mainProgram() const override { return ProgramText{"main.nc", "main.nc", text_}; }
  Result<ProgramText> subprogram(const SubprogramQuery&) const override {
    return inputError("there is none");
  }

 private:
  std::string text_;
};

/// A contour in (r, z) as points at most a few micrometres apart.
class Contour {
 public:
  explicit Contour(Vec2 start) : points_{start} {}
  Contour& line(double r, double z) {
    joints_.push_back(points_.back());
    const Vec2 from = points_.back(), to(r, z);
    for (int i = 1; i <= kSteps; ++i) points_.push_back(from + (to - from) * i / kSteps);
    return *this;
  }
  /// Arc below half a turn; `left`: its centre lies left of the way, r to the right and z up.
  Contour& arc(double r, double z, double radius, bool left) {
    joints_.push_back(points_.back());
    const Vec2 from = points_.back(), to(r, z), chord = to - from;
    const Vec2 side = Vec2(-chord.y(), chord.x()).normalized() * (left ? 1.0 : -1.0);
    const Vec2 center = 0.5 * (from + to) + side * std::sqrt(radius * radius - 0.25 * chord.squaredNorm());
    const double a = std::atan2(from.y() - center.y(), from.x() - center.x());
    const double b = std::atan2(to.y() - center.y(), to.x() - center.x());
    const double sweep = std::remainder(b - a, 2.0 * kPi);
    for (int i = 1; i <= kSteps; ++i) {
      const double angle = a + sweep * i / kSteps;
      points_.push_back(center + radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    return *this;
  }
  double distance(const Vec2& p) const {
    double best = 1e9;
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
      const Vec2 d = points_[i + 1] - points_[i];
      const double t = std::clamp((p - points_[i]).dot(d) / d.squaredNorm(), 0.0, 1.0);
      best = std::min(best, (p - points_[i] - t * d).norm());
    }
    return best;
  }
  double fromJoint(const Vec2& p) const {
    double best = 1e9;
    for (const Vec2& joint : joints_) best = std::min(best, (p - joint).norm());
    return best;
  }
  const std::vector<Vec2>& points() const { return points_; }

 private:
  static constexpr int kSteps = 2000;
  std::vector<Vec2> points_, joints_;
};

/// N120 to N124 of TEST_G77 from X2 Z45, and of TEST_G78 from X10 Z5.
Contour contourG77() {
  return Contour({1, 45})
      .line(1, 35)
      .arc(2.5, 25, 10, false)
      .arc(3.5, 20, 8, true)
      .line(4.25, 18)
      .line(4.25, 5);
}
Contour contourG78() {
  return Contour({5, 5})
      .line(4.25, 5)
      .line(4, 15)
      .arc(3.5, 20, 10, true)
      .arc(2.5, 25, 8, false)
      .line(2.5, 40);
}

struct Example {
  const char* cycle;   ///< word of the contour cycle with its first words
  const char* blocks;  ///< N120 to N124
  Contour contour;
  double low, high;  ///< heights that are looked at
};

Example exampleG77() {
  return {"G77 G41 G0 X2 Z45",
          "N120 G1 Z35\nN121 G2 X5 Z25 R10\nN122 G3 X7 Z20 R8\nN123 G1 X8.5 Z18\nN124 Z5\n", contourG77(),
          5.5, 39.5};
}
// The allowance lies on the side of the stock with G42, the contour being run towards +Z.
Example exampleG78() {
  return {"G78 G42 G0 X10 Z5",
          "N120 G1 X8.5\nN121 G1 X8 Z15\nN122 G3 X7 Z20 R10\nN123 G2 X5 Z25 R8\nN124 G1 Z40\n", contourG78(),
          5.5, 38.5};
}

std::string program(const Example& example, bool finished) {
  const std::string cycle = example.cycle;
  std::string text = "%TEST\nN10 G0 Z100\nN11 T1 M6\nN12 G0 X10 Z40\nN13 " + cycle +
                     " P120 Q124 R0.5 E2 F0.7 G95 S500 M3\nN14 G0 Z100\n";
  if (finished) {
    text += "N15 T2 M6\nN16 G0 X10 Z40\nN11 " + cycle + " P120 Q124 R0.2 F0.3 S800\nN12 " + cycle +
            " P120 Q124 F0.3 S800\n";
  }
  return text + "M2\n" + example.blocks + "%\n";
}

SectionBody machined(const Example& example, double nose, bool finished, std::vector<Contact>& contacts) {
  ControlSettings settings;
  settings.start = Vec3(20, 0, 60);
  for (const char* tool : {"1", "2"}) {
    settings.parameters[std::string("RT.") + tool] = nose;
    settings.parameters[std::string("TIP.") + tool] = 3;
  }
  Toolpath path;
  ToolpathBuilder builder(path);
  const InterpretSummary summary =
      interpret(ControlId::kWl4Lathe, OneProgram(program(example, finished)), settings, builder);
  for (const Diagnostic& d : path.diagnostics.all()) EXPECT_NE(d.severity, Severity::kError) << d.message;
  EXPECT_TRUE(summary.ok());
  for (Motion& motion : path.motions) motion.tool = std::max(motion.tool, 1);  // before the first T
  CylinderShape blank;
  blank.radius = 4.9;
  blank.length = 35.9;
  blank.base = Vec3(0, 0, 4);
  Result<TurnedStock> stock = TurnedStock::create(blank);
  EXPECT_TRUE(stock);
  Progress progress;
  const auto summary_of_cut =
      stock->remove(path, {insertTool(1, turningInsert(nose)), insertTool(2, turningInsert(nose))}, progress);
  EXPECT_TRUE(summary_of_cut);
  contacts = summary_of_cut->contacts;
  const TurnedShape shape = stock->shape();
  EXPECT_FALSE(shape.bodies.empty());
  return shape.bodies.front();
}

/// Points of the border that were cut, between two heights.
std::vector<Vec2> cutPoints(const SectionBody& body, const Example& example) {
  std::vector<Vec2> points;
  const SectionLoop& border = body.loops.front();
  for (std::size_t i = 0; i < border.points.size(); ++i) {
    if (border.motion[i] == kNoMotion) continue;
    const Vec2 &a = border.points[i], &b = border.points[(i + 1) % border.points.size()];
    for (const double t : {0.0, 0.5}) {
      const Vec2 p = a + t * (b - a);
      if (p.y() > example.low && p.y() < example.high) points.push_back(p);
    }
  }
  return points;
}

class Wl4Examples : public testing::TestWithParam<double> {};

void finishes(const Example& example, double nose) {
  std::vector<Contact> contacts;
  const SectionBody body = machined(example, nose, true, contacts);
  const std::vector<Vec2> points = cutPoints(body, example);
  ASSERT_GT(points.size(), 50u);
  // In hollow corners of the contour the nose leaves its radius.
  const double near = nose > 0.0 ? 0.5 : 0.0;
  double worst = 0.0;
  for (const Vec2& p : points) {
    if (example.contour.fromJoint(p) >= near) worst = std::max(worst, example.contour.distance(p));
  }
  EXPECT_LT(worst, 1e-3);
  // With the larger offset of a nose the way to the first block of G78 runs inside the bar: the control goes
  // there at rapid. Else nothing but the leading edge is touched on the way out: it leans by 3 degrees, which
  // on the 0.3 mm out of the last level is 0.0157 mm.
  const double lean = 0.3 * std::tan(degToRad(3.0)) + 1e-3;
  for (const Contact& c : contacts) EXPECT_TRUE(nose > 0.0 || c.depth_mm < lean) << c.motion;
}

void leavesTheAllowance(const Example& example, double nose) {
  std::vector<Contact> contacts;
  const SectionBody body = machined(example, nose, false, contacts);
  const std::vector<Vec2> points = cutPoints(body, example);
  ASSERT_GT(points.size(), 50u);
  for (const Vec2& p : points) {
    const double off = example.contour.distance(p);
    EXPECT_GT(off, 0.5 - 1e-3) << p.transpose();
    if (example.contour.fromJoint(p) > 1.0) {
      EXPECT_LT(off, 0.5 + 1e-3) << p.transpose();
    }
  }
}

TEST_P(Wl4Examples, G77FinishesTheContour) { finishes(exampleG77(), GetParam()); }
TEST_P(Wl4Examples, G78FinishesTheContour) { finishes(exampleG78(), GetParam()); }
TEST_P(Wl4Examples, G77LeavesTheAllowance) { leavesTheAllowance(exampleG77(), GetParam()); }
TEST_P(Wl4Examples, G78LeavesTheAllowance) { leavesTheAllowance(exampleG78(), GetParam()); }

INSTANTIATE_TEST_SUITE_P(Noses, Wl4Examples, testing::Values(0.0, 0.4));

}  // namespace
}  // namespace proveout
