// Alignment by a plane and two holes.
#include "removal/compare/fit/datums.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "removal/compare/fit/fit.h"

namespace proveout {
namespace {

using testing::HasSubstr;

/// A plate from Z0 to Z10 with two holes along Z, in closed form.
class Plate final : public ExactPart {
 public:
  explicit Plate(const RigidTransform& at, double second_x = 60.0)
      : to_own_(at.inverse()), second_x_(second_x) {}

  Sample at(const Vec3& p, double reach) const override {
    const Vec3 q = to_own_(p);
    Sample out;
    out.value = -1e9;
    const auto take = [&](double value, const Vec3& normal) {
      if (value <= out.value) return;
      out.value = value;
      out.normal = to_own_.rotation.transpose() * normal;
    };
    take(q.z() - 10.0, Vec3::UnitZ());
    take(-q.z(), -Vec3::UnitZ());
    for (const Vec3& c : {Vec3(15, 20, 0), Vec3(second_x_, 25, 0)}) {
      const Vec3 off(q.x() - c.x(), q.y() - c.y(), 0.0);
      take(4.0 - off.norm(), -off.normalized());
    }
    out.value = std::clamp(out.value, -reach, reach);
    return out;
  }
  double accuracy() const override { return 1e-9; }

 private:
  RigidTransform to_own_;
  double second_x_;
};

/// The faces that the datums are on: the top with places for it, and two walls; and one that is no datum.
struct Model {
  TriMesh mesh;
  CadFaces faces;

  std::uint32_t add(const Vec3& p) {
    mesh.positions.push_back(p.cast<float>());
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
  }
  void quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, std::uint32_t face) {
    const std::uint32_t v[] = {add(a), add(b), add(c), add(d)};
    mesh.triangles.push_back({v[0], v[1], v[2]});
    mesh.triangles.push_back({v[0], v[2], v[3]});
    faces.of_triangle.insert(faces.of_triangle.end(), 2, face);
  }
};

Model model() {
  Model out;
  CadFace top, bottom;
  top.kind = bottom.kind = SurfaceKind::kPlane;
  top.origin = Vec3(0, 0, 10);
  bottom.axis = -Vec3::UnitZ();
  out.faces.faces = {top};
  for (const Vec3& c : {Vec3(15, 20, 5), Vec3(60, 25, 5)}) {
    CadFace hole;
    hole.kind = SurfaceKind::kCylinder;
    hole.origin = c;
    hole.radius = 4.0;
    hole.turn_rad = 2.0 * kPi;
    hole.hollow = true;
    out.faces.faces.push_back(hole);
  }
  out.faces.faces.push_back(bottom);
  out.quad({0, 0, 10}, {80, 0, 10}, {80, 14, 10}, {0, 14, 10}, 0);
  out.quad({0, 30, 10}, {80, 30, 10}, {80, 50, 10}, {0, 50, 10}, 0);
  out.quad({0, 0, 0}, {0, 14, 0}, {80, 14, 0}, {80, 0, 0}, 3);
  constexpr int kSides = 48;
  for (std::uint32_t hole = 1; hole <= 2; ++hole) {
    const Vec3 c = out.faces.faces[hole].origin;
    const auto on = [&](int k, double z) {
      const double a = 2.0 * kPi * k / kSides;
      return Vec3(c.x() + 4.0 * std::cos(a), c.y() + 4.0 * std::sin(a), z);
    };
    for (int k = 0; k < kSides; ++k) out.quad(on(k, 0), on(k, 10), on(k + 1, 10), on(k + 1, 0), hole);
  }
  return out;
}

const std::vector<Vec3> kDatums = {{40, 5, 10}, {19, 20, 5}, {64, 25, 5}};

TEST(Datums, ThePoseComesBack) {
  const Model nominal = model();
  const RigidTransform wanted{rotationXyzDeg({0.2, -0.3, 0.4}), {0.3, -0.2, 0.25}};
  const Result<Alignment> found = alignByDatums(nominal.mesh, nominal.faces, kDatums, Plate(wanted));
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_EQ(found->kind, AlignKind::kDatums);
  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(80, 50, 10), Vec3(40, 5, 10)})
    EXPECT_LT((found->motion(p) - wanted(p)).norm(), 1e-5);
  EXPECT_LT(turnOf(found->motion * wanted.inverse()), 1e-6);
  EXPECT_LT(found->rms_mm, 1e-5);
  EXPECT_GT(found->points, 300u);
  EXPECT_EQ(found->free_directions, 0);
  EXPECT_NEAR(found->moved_mm, farthestMove(wanted, nominal.mesh), 1e-4);
}

/// The first hole holds the place, the second one only the turn: what their distance is off stays with it.
TEST(Datums, TheSecondHoleSettlesTheTurnAlone) {
  const Model nominal = model();
  const Result<Alignment> found = alignByDatums(nominal.mesh, nominal.faces, kDatums, Plate({}, 60.1));
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_LT((found->motion(Vec3(15, 20, 10)) - Vec3(15, 20, 10)).norm(), 1e-6);
  const double made = std::hypot(45.1, 5.0), drawn = std::hypot(45.0, 5.0);
  EXPECT_NEAR(found->rms_mm, made - drawn, 1e-6);
  const Vec3 second = found->motion(Vec3(60, 25, 10));
  EXPECT_NEAR(std::atan2(second.y() - 20, second.x() - 15), std::atan2(5.0, 45.1), 1e-8);
}

TEST(Datums, WrongOnesAreRefused) {
  const Model nominal = model();
  const auto messageOf = [&](const std::vector<Vec3>& datums) {
    const Result<Alignment> out = alignByDatums(nominal.mesh, nominal.faces, datums, Plate({}));
    EXPECT_FALSE(out);
    return out ? std::string() : out.error().message;
  };
  EXPECT_THAT(messageOf({{40, 5, 10}}), HasSubstr("three points"));
  EXPECT_THAT(messageOf({{19, 20, 5}, {19, 20, 5}, {64, 25, 5}}), HasSubstr("has to lie on a plane"));
  EXPECT_THAT(messageOf({{40, 5, 10}, {40, 5, 10}, {64, 25, 5}}), HasSubstr("second datum"));
  EXPECT_THAT(messageOf({{40, 5, 10}, {19, 20, 5}, {19, 20, 5}}), HasSubstr("same axis"));
  EXPECT_THAT(messageOf({{40, 5, 30}, {19, 20, 5}, {64, 25, 5}}), HasSubstr("on no face"));
  const Result<Alignment> lacking = alignByDatums(nominal.mesh, nominal.faces, kDatums, Plate({}, 90.0));
  ASSERT_FALSE(lacking);
  EXPECT_THAT(lacking.error().message, HasSubstr("the part lacks"));
}

}  // namespace
}  // namespace proveout
