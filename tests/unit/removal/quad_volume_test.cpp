// Volume under the piece of surface around one crossing.
#include "removal/surface/quad_volume.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

namespace proveout {
namespace {

const Vec3 kApex(0.4, 0.5, -2.0);

double cone(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (a - kApex).dot((b - kApex).cross(c - kApex)) / 6.0;
}

/// A crease from corner 0 to corner 2, beyond which the surface falls.
TEST(QuadVolume, IsExactWhereACreaseJoinsOppositeCorners) {
  const Vec3 crossing(0.6, 0.3, 0.0);
  for (const double fall : {0.15, 0.4, 0.9, 3.0}) {
    const std::array<Vec3, 4> corners = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, -fall)};
    const double exact = cone(corners[0], corners[1], corners[2]) + cone(corners[0], corners[2], corners[3]);
    EXPECT_NEAR(quadVolume(corners, crossing, Vec3::UnitZ(), kApex, 0xA).volume, exact, 1e-12) << fall;
  }
}

/// The same with a face on this side that bends: a cylinder along the crease.
TEST(QuadVolume, KeepsTheBulgeOnThisSideOfACrease) {
  constexpr double kRadius = 10.0;
  const Vec3 along = Vec3(1, 1, 0).normalized(), across = Vec3(1, -1, 0).normalized();
  const double width = across.x();  // of the part on this side: a right triangle on the crease
  const auto drop = [&](double v) { return kRadius - std::sqrt(kRadius * kRadius - v * v); };
  const Vec3 own = Vec3(0.5, 0.5, 0) + width * across - Vec3(0, 0, drop(width));
  const std::array<Vec3, 4> corners = {Vec3(0, 0, 0), own, Vec3(1, 1, 0), Vec3(0, 1, -0.5)};
  const Vec3 crossing = 0.7 * along;  // on the crease, where the face is level
  // Between the facet and the cylinder: the length of the triangle at v times the height there.
  double bulge = 0.0;
  constexpr int kSteps = 2000;
  for (int i = 0; i < kSteps; ++i) {
    const double v = width * (i + 0.5) / kSteps;
    bulge += std::sqrt(2.0) * (1.0 - v / width) * (drop(width) * v / width - drop(v)) * width / kSteps;
  }
  const double facets = cone(corners[0], own, corners[2]) + cone(corners[0], corners[2], corners[3]);
  EXPECT_NEAR(quadVolume(corners, crossing, Vec3::UnitZ(), kApex, 0xA).volume, facets + bulge, 0.02 * bulge);
}

/// Corners that are not smooth, on one round face: rims of it at both ends.
TEST(QuadVolume, TakesARoundFaceForNoBreak) {
  constexpr double kRadius = 8.0;
  std::array<Vec3, 4> corners = {Vec3(-0.5, -0.5, 0), Vec3(0.5, -0.5, 0), Vec3(0.5, 0.5, 0),
                                 Vec3(-0.5, 0.5, 0)};
  for (Vec3& c : corners) c.z() = std::sqrt(kRadius * kRadius - c.x() * c.x()) - kRadius;
  const double smooth = quadVolume(corners, Vec3::Zero(), Vec3::UnitZ(), kApex, 0xF).volume;
  for (const unsigned bits : {0x0u, 0x5u, 0xAu, 0x2u})
    EXPECT_EQ(quadVolume(corners, Vec3::Zero(), Vec3::UnitZ(), kApex, bits).volume, smooth) << bits;
}

/// What the surface of heights `z` bulges out of the triangle of the origin, a and b, by samples.
template <typename Heights>
double bulgeOut(const Heights& z, const Vec3& a, const Vec3& b) {
  constexpr int kSteps = 300;
  double sum = 0.0;
  int count = 0;
  const auto sample = [&](double i, double k) {
    const double part = i / kSteps, other = k / kSteps;
    const Vec3 p = part * a + other * b;
    sum += z(p.x(), p.y()) - p.z();
    ++count;
  };
  for (int i = 0; i < kSteps; ++i) {
    for (int k = 0; i + k < kSteps; ++k) {
      sample(i + 1.0 / 3.0, k + 1.0 / 3.0);
      if (i + k + 2 <= kSteps) sample(i + 2.0 / 3.0, k + 2.0 / 3.0);
    }
  }
  return 0.5 * (a.x() * b.y() - a.y() * b.x()) * sum / count;
}

/// Faces that turn by up to half a radian from the crossing to a corner: what is left goes with the fourth
/// power of that.
TEST(QuadVolume, FollowsFacesThatTurnMuch) {
  for (const double radius : {2.0, 3.0, 6.0}) {
    const auto sphere = [&](double x, double y) {
      return std::sqrt(radius * radius - x * x - y * y) - radius;
    };
    const auto cylinder = [&](double x, double y) {
      const double across = 0.8 * x + 0.6 * y;
      return std::sqrt(radius * radius - across * across) - radius;
    };
    const auto hold = [&](const auto& z, const char* name) {
      std::array<Vec3, 4> corners = {Vec3(-0.6, -0.4, 0), Vec3(0.5, -0.7, 0), Vec3(0.7, 0.5, 0),
                                     Vec3(-0.4, 0.6, 0)};
      for (Vec3& c : corners) c.z() = z(c.x(), c.y());
      double facets = 0.0, bulge = 0.0;
      for (int i = 0; i < 4; ++i) {
        const Vec3 &a = corners[static_cast<std::size_t>(i)],
                   &b = corners[static_cast<std::size_t>((i + 1) % 4)];
        facets += cone(Vec3::Zero(), a, b);
        bulge += bulgeOut(z, a, b);
      }
      const double turn2 = 1.0 / (radius * radius);  // of which the quadratic misses a tenth
      EXPECT_NEAR(quadVolume(corners, Vec3::Zero(), Vec3::UnitZ(), kApex).volume, facets + bulge,
                  (0.2 * turn2 * turn2 + 3e-4) * bulge)
          << name << " " << radius;
    };
    hold(sphere, "sphere");
    hold(cylinder, "cylinder");
  }
}

}  // namespace
}  // namespace proveout
