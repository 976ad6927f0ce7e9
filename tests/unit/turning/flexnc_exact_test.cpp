// Pairs of a roughing block and its contour block with random letters, as FlexNC programs that are run and
// turned: what stands between the finished profile and what is left.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/geometry/plane.h"
#include "core/nc/registry/interpreter.h"
#include "core/nc/services/contour/contour_elements.h"
#include "core/nc/services/contour/contour_offset.h"
#include "tests/unit/nc/flexnc_random.h"
#include "tests/unit/turning/turning_fixture.h"

namespace proveout {
namespace {

using test::contourOf;

constexpr double kExact = 1e-3;  ///< mm: one micrometre

/// One pair: tool 1 roughs with its corrector's shifts, tool 2 cuts the contour under compensation.
struct Pair {
  nc::CycleCall call;             ///< of the roughing block; both have its V, 0
  PlaneContour profile;           ///< (z, r)
  double side = 1.0;              ///< 1 a shaft, -1 a hole
  Vec2 allowance = Vec2::Zero();  ///< (z, r), off the material
  double rough_nose = 0.0, nose = 0.0;

  double start() const { return profile.front().from.y(); }
  double stock() const { return profile.back().to.y(); }
  std::string rough() const { return test::flexncBlock(call.code, call.arguments); }
  std::string contour() const {
    nc::CycleArguments arguments = test::without(call.arguments, "PB");
    arguments.set('P', 0.0);
    arguments.set('K', 1.0);
    return test::flexncBlock(call.code, arguments);
  }

  CylinderShape blank() const {
    CylinderShape shape;
    shape.radius = side > 0.0 ? stock() : start() + 10.0;
    shape.inner_radius = side > 0.0 ? 0.0 : stock();
    shape.base = Vec3(0.0, 0.0, profile.back().to.x() - 10.0);
    shape.length = -shape.base.z();
    return shape;
  }

  /// The border of the finished part in (z, r), from where the face ends to where the stock's surface does.
  PlaneContour finished() const {
    const double along = side > 0.0 ? 0.0 : start() + 10.0;
    PlaneContour all{lineElement({0.0, along}, {0.0, start()})};
    if (profile.front().from.x() < -1e-9) all.push_back(lineElement(all.back().to, profile.front().from));
    all.insert(all.end(), profile.begin(), profile.end());
    all.push_back(lineElement(profile.back().to, {blank().base.z(), stock()}));
    return all;
  }
};

/// An insert that goes into the bore and is longer than a pass is deep.
Insert insertOf(const Pair& pair, double nose) {
  Insert insert = turningInsert(nose, pair.side > 0.0 ? 3 : 2);
  if (pair.side < 0.0) insert.edge_length = std::min(insert.edge_length, 0.9 * pair.stock());
  return insert;
}

std::string programOf(const Pair& pair, bool finish) {
  // Off a shaft, straight out of a bore.
  const double away = pair.side > 0.0 ? 2.0 * pair.stock() + 50.0 : 2.0 * pair.stock() - 0.2;
  const std::string leave = "G81X" + std::to_string(away) + "Z100\n";
  std::string text = "T1M06D1\nS300M03\nG98F100\n" + pair.rough() + "\n" + leave;
  if (finish) {
    const std::string approach =
        pair.side > 0.0 ? "G81.1X0Z5\n" : "G81.2X" + std::to_string(2.0 * pair.start() + 2.0) + "Z5\n";
    text += "T2M06D2\nS300M03\n" + approach + pair.contour() + "\n" + leave;
  }
  return text + "M02\n";
}

/// The border of what is left after roughing, and after the contour too if `finish`: (z, r), closed.
std::vector<Vec2> leftOf(const Pair& pair, bool finish) {
  ControlSettings settings;
  settings.start = Vec3(150, 0, 100);
  settings.parameters = {{"DXW.1", pair.allowance.y()}, {"DZW.1", pair.allowance.x()},
                         {"RT.1", pair.rough_nose},     {"TIP.1", pair.side > 0.0 ? 3.0 : 2.0},
                         {"RT.2", pair.nose},           {"TIP.2", pair.side > 0.0 ? 3.0 : 2.0}};
  if (pair.call.arc_view == nc::ArcView::kXUp) settings.parameters["arc_view"] = 1.0;
  Toolpath path;
  ToolpathBuilder builder(path);
  interpret(ControlId::kFlexNc, MemoryProgramSource("main.nc", programOf(pair, finish)), settings, builder);
  for (const Diagnostic& d : path.diagnostics.all()) ADD_FAILURE() << formatDiagnostic(d);
  Result<TurnedStock> stock = TurnedStock::create(pair.blank());
  EXPECT_TRUE(stock);
  Progress progress;
  const std::vector<Tool> tools = {insertTool(1, insertOf(pair, pair.rough_nose)),
                                   insertTool(2, insertOf(pair, pair.nose))};
  const auto summary = stock->remove(path, tools, progress);
  EXPECT_TRUE(summary);
  for (const Contact& contact : summary->contacts) EXPECT_LT(contact.depth_mm, kExact) << contact.motion;
  const TurnedShape shape = stock->shape();
  EXPECT_EQ(shape.bodies.size(), 1U);
  std::vector<Vec2> left;
  for (const Vec2& p : shape.bodies.front().loops.front().points) left.emplace_back(p.y(), p.x());
  return left;
}

double distanceTo(const std::vector<Vec2>& border, const Vec2& p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < border.size(); ++i)
    least = std::min(least, distanceToSegment(p, border[i], border[(i + 1) % border.size()]));
  return least;
}

/// Whether a point is in the finished part, by how deep, mm; 0 outside.
double depthIn(const Pair& pair, const PlaneContour& finished, const Vec2& p) {
  if (p.x() > 0.0 || pair.side * (p.y() - test::radiusAt(pair.profile, p.x())) > 0.0) return 0.0;
  return test::distanceFrom(finished, p);
}

bool onBlank(const Pair& pair, const Vec2& p) {
  const CylinderShape blank = pair.blank();
  return p.x() < blank.base.z() + 1e-6 || p.y() < 1e-6 || (pair.side < 0.0 && p.y() > blank.radius - 1e-6);
}

/// Whether the nose touches every element; without look-ahead the control cuts into what is behind others.
bool noseFits(const Pair& pair) {
  bool fits = true;
  return offsetContour(pair.finished(), -pair.side * pair.nose, fits).ok() && fits;
}

class FlexncExact : public testing::TestWithParam<test::FlexncTemplate> {
 protected:
  static constexpr int kPairs = 12;
  static constexpr unsigned kSeed = 20260021;

  void SetUp() override { RecordProperty("seed", static_cast<int>(kSeed)); }

  template <typename Law>
  void forPairs(bool finish, const Law& law) {
    for (const double side : GetParam().hole ? std::vector{1.0, -1.0} : std::vector{1.0}) {
      for (int k = 0; k < kPairs; ++k) {
        const auto pair = anyPair(side);
        ASSERT_TRUE(pair) << "calls that are taken are too rare";
        SCOPED_TRACE(testing::Message()
                     << programOf(*pair, finish) << "allowance " << pair->allowance.transpose() << " noses "
                     << pair->rough_nose << " " << pair->nose << " arcs up "
                     << (pair->call.arc_view == nc::ArcView::kXUp) << " seed " << kSeed);
        law(*pair, leftOf(*pair, finish));
        if (HasFailure()) return;
      }
    }
  }

 private:
  std::optional<Pair> anyPair(double side) {
    constexpr double kNarrow = 6.0;  // of a bore, mm: the insert and its way back go in
    for (int tries = 0; tries < 1000; ++tries) {
      auto good = random_.goodCall(GetParam(), side, false);
      if (!good) return std::nullopt;
      Pair pair{good->call, contourOf(good->answer), side};
      const double depth = good->call.arguments.value('P');
      if (good->call.arguments.value('V') != 0.0 || (side < 0.0 && pair.stock() < kNarrow)) continue;
      if (depth > 0.6 * insertOf(pair, 0.0).edge_length) continue;
      pair.allowance = {random_.number(0.0, 0.5), side * random_.number(0.0, 0.5)};
      pair.rough_nose = std::min(random_.number(0.2, 0.8), depth);
      pair.nose = random_.number(0.1, 0.8);
      if (noseFits(pair)) return pair;
    }
    return std::nullopt;
  }

  test::FlexncRandom random_{kSeed};
};

/// Roughing never enters the finished profile. It leaves no more than its allowance and a layer: what its
/// nose does not reach is less than a layer.
TEST_P(FlexncExact, RoughingLeavesItsAllowanceAndOneLayerAtMost) {
  forPairs(false, [](const Pair& pair, const std::vector<Vec2>& left) {
    const PlaneContour finished = pair.finished();
    const double most = pair.allowance.norm() + pair.call.arguments.value('P') + kExact;
    for (const Vec2& p : left) {
      if (onBlank(pair, p)) continue;
      EXPECT_LT(depthIn(pair, finished, p), kExact) << p.transpose();
      EXPECT_LT(test::distanceFrom(finished, p), most) << p.transpose();
    }
  });
}

/// Where the nose reaches; elsewhere a fillet of its radius stays.
TEST_P(FlexncExact, TheContourLeavesTheProfile) {
  forPairs(true, [](const Pair& pair, const std::vector<Vec2>& left) {
    const PlaneContour finished = pair.finished();
    for (const Vec2& p : left) {
      if (onBlank(pair, p)) continue;
      EXPECT_LT(depthIn(pair, finished, p), kExact) << p.transpose();
    }
    int reached = 0, looked = 0;
    for (std::size_t k = 1; k + 1 < finished.size(); ++k) {
      for (int i = 1; i < 40; ++i) {
        const Vec2 p = pointOn(finished[k], i / 40.0), ahead = pointOn(finished[k], i / 40.0 + 1e-4),
                   way = (ahead - p).normalized();
        const Vec2 center = p + pair.side * pair.nose * Vec2(way.y(), -way.x());
        ++looked;
        if (test::distanceFrom(finished, center) < pair.nose - 1e-6) continue;
        ++reached;
        EXPECT_LT(distanceTo(left, p), kExact) << p.transpose();
      }
    }
    EXPECT_GT(reached, looked / 2);
  });
}

INSTANTIATE_TEST_SUITE_P(All, FlexncExact, testing::ValuesIn(test::flexncTemplates()));

}  // namespace
}  // namespace proveout
