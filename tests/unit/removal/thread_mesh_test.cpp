// Meshes of random threads from half sections against the exact field of the same part.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "removal/turning/turned_field.h"
#include "tests/unit/removal/turned_parts.h"

namespace proveout {
namespace {

using test::body;
using test::shapeOf;

constexpr double kTolerance = 2e-3;

class RandomThread {
 public:
  explicit RandomThread(int seed) : random_(static_cast<unsigned>(seed)) {
    shape = shapeOf({any(0, 3) == 0 ? tube() : shaft()});
    const int count = any(1, 3);
    for (int k = 0; k < count; ++k) add(k);
  }

  std::shared_ptr<TurnedShape> shape;

 private:
  double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  int any(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  /// Chamfer, cylinder, undercut, shoulder with a fillet.
  SectionBody shaft() {
    inside_ = false;
    radius_ = real(4, 12);
    length_ = real(10, 25);
    const double chamfer = real(0.2, 2.0), root = radius_ - real(1.2, 2.5), gap = real(1.0, 4.0),
                 fillet = real(0.2, 1.0), shoulder = radius_ + fillet + real(0.5, 3);
    std::vector<Vec2> points{{0, -length_ - 6}, {shoulder, -length_ - 6}, {shoulder, -length_}};
    for (int i = 0; i <= 12; ++i) {
      const double angle = 0.5 * kPi * i / 12;
      points.emplace_back(root + fillet * (1 - std::sin(angle)), -length_ + fillet * (1 - std::cos(angle)));
    }
    for (const Vec2& p : {Vec2(root, -length_ + gap), Vec2(radius_, -length_ + gap), Vec2(radius_, -chamfer),
                          Vec2(radius_ - chamfer, 0), Vec2(0, 0)})
      points.push_back(p);
    return body(points);
  }

  SectionBody tube() {
    inside_ = true;
    radius_ = real(4, 10);
    length_ = real(8, 20);
    const double chamfer = real(0.1, 1.0), wall = radius_ + real(3, 6);
    return body(
        {{radius_, -length_}, {wall, -length_}, {wall, 0}, {radius_ + chamfer, 0}, {radius_, -chamfer}});
  }

  std::shared_ptr<ConvexOutline> tooth() {
    const double flat = real(0.03, 0.3), high = real(2.5, 4.0), angle = degToRad(real(10, 40));
    const double top = flat + high * std::tan(angle), sense = inside_ ? -1.0 : 1.0;
    std::vector<Vec2> corners{{0, flat}, {0, -flat}, {sense * high, -top}, {sense * high, top}};
    if (inside_) std::reverse(corners.begin(), corners.end());
    std::vector<OutlineSide> sides(4);
    for (std::size_t i = 0; i < 4; ++i) {
      sides[i].from = corners[i];
      sides[i].to = corners[(i + 1) % 4];
    }
    return std::make_shared<ConvexOutline>(sides);
  }

  void add(int k) {
    if (k == 0 || any(0, 1) == 0) shape->outlines.push_back(tooth());
    ThreadSweep s;
    s.outline = shape->outlines.back().get();
    const double lead = real(0.8, 4.0), depth = real(0.2, 1.2), sense = inside_ ? 1.0 : -1.0;
    const double end_depth = any(0, 2) == 0 ? real(-0.4, 1.2) : depth;
    s.from = {radius_ + sense * depth, real(-2, 6)};
    s.to = {radius_ + sense * end_depth, -real(0.4, 1.1) * length_};
    if (any(0, 3) == 0) std::swap(s.from, s.to);
    s.turns = std::abs(s.to.y() - s.from.y()) / lead * (any(0, 1) == 0 ? 1 : -1);
    s.start_rad = real(-7, 7);
    if (any(0, 3) == 0) s.bend = real(-0.5, 0.5);
    s.motion = 100 + static_cast<MotionId>(k);
    shape->threads.push_back(s);
  }

  std::mt19937 random_;
  bool inside_ = false;
  double radius_ = 0.0, length_ = 0.0;
};

/// Vertices lie on the part; middles of edges and triangles are within the tolerances of facets, of outlines
/// and of what appears between two sections.
TEST(ThreadMesh, RandomThreadsLieOnTheField) {
  int made = 0;
  for (int seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(seed);
    const RandomThread part(seed);
    const auto surface =
        threadedSurface(part.shape->bodies.front(), part.shape->threads, kTolerance, Progress());
    if (!surface) continue;
    ++made;
    EXPECT_LE(surface->deviation_mm, 5 * kTolerance);
    const TriMesh& mesh = surface->mesh;
    EXPECT_TRUE(analyseTopology(mesh).closedManifold());
    const std::vector<std::uint8_t> all(mesh.positions.size(), 1);
    EXPECT_EQ(findIntersections(mesh, all).size(), 0u);
    EXPECT_NEAR(meshVolume(mesh), surface->volume_mm3, 1e-3 * surface->volume_mm3);
    EXPECT_EQ(mesh.motion.size(), mesh.triangles.size());
    const auto field = makeTurnedField(part.shape);
    ASSERT_TRUE(field.ok());
    double vertex = 0.0, middle = 0.0;
    for (const auto& p : mesh.positions)
      vertex = std::max(vertex, std::abs((*field)->value(p.cast<double>())));
    for (const auto& t : mesh.triangles) {
      const Vec3 a = mesh.positions[t[0]].cast<double>(), b = mesh.positions[t[1]].cast<double>(),
                 c = mesh.positions[t[2]].cast<double>();
      for (const Vec3& p :
           {Vec3(0.5 * (a + b)), Vec3(0.5 * (b + c)), Vec3(0.5 * (c + a)), Vec3((a + b + c) / 3)})
        middle = std::max(middle, std::abs((*field)->value(p)));
    }
    EXPECT_LT(vertex, 1.5e-3) << "vertices";
    EXPECT_LT(middle, 4 * kTolerance) << "middles";
  }
  EXPECT_GE(made, 29);
}

}  // namespace
}  // namespace proveout
