// Volume under the piece of surface around one crossing.
#include "removal/surface/measure/quad_volume.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>

namespace proveout {
namespace {

const Vec3 kApex(0.4, 0.5, -2.0);

double cone(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (a - kApex).dot((b - kApex).cross(c - kApex)) / 6.0;
}

/// A feature edge from corner 0 to corner 2, beyond which the surface falls.
TEST(QuadVolume, IsExactWhereAFeatureEdgeJoinsOppositeCorners) {
  const Vec3 crossing(0.6, 0.3, 0.0);
  for (const double fall : {0.15, 0.4, 0.9, 3.0}) {
    const std::array<Vec3, 4> corners = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, -fall)};
    const double exact = cone(corners[0], corners[1], corners[2]) + cone(corners[0], corners[2], corners[3]);
    EXPECT_NEAR(quadVolume(corners, crossing, Vec3::UnitZ(), kApex, 0xA).volume, exact, 1e-12) << fall;
  }
}

/// The same with a face on this side that bends: a cylinder along the feature edge.
TEST(QuadVolume, KeepsTheBulgeOnThisSideOfAFeatureEdge) {
  constexpr double kRadius = 10.0;
  const Vec3 along = Vec3(1, 1, 0).normalized(), across = Vec3(1, -1, 0).normalized();
  const double width = across.x();  // of the part on this side: a right triangle on the feature edge
  const auto drop = [&](double v) { return kRadius - std::sqrt(kRadius * kRadius - v * v); };
  const Vec3 own = Vec3(0.5, 0.5, 0) + width * across - Vec3(0, 0, drop(width));
  const std::array<Vec3, 4> corners = {Vec3(0, 0, 0), own, Vec3(1, 1, 0), Vec3(0, 1, -0.5)};
  const Vec3 crossing = 0.7 * along;  // on the feature edge, where the face is level
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

/// A sphere around, or a cylinder along, what `fromAxis` measures from.
struct Round {
  double radius;
  int dimension;  ///< 3: sphere, 2: cylinder
  Vec3 along;     ///< of the cylinder's axis; 0 for a sphere

  Vec3 fromAxis(const Vec3& p) const {
    const Vec3 q = p + Vec3(0, 0, radius);
    return q - along.dot(q) * along;
  }
  /// Puts a point that is seen from above on it.
  Vec3 above(double x, double y) const {
    const Vec3 level = fromAxis(Vec3(x, y, -radius));
    return {x, y, std::sqrt(radius * radius - level.squaredNorm()) - radius};
  }
};

/// What lies between the triangle of the origin, a and b and the round face, within walls along the face's
/// normals, by samples.
double bulgeOut(const Round& face, const Vec3& a, const Vec3& b) {
  constexpr int kSteps = 300;
  double sum = 0.0;
  int count = 0;
  const Vec3 area = 0.5 * a.cross(b);
  const auto sample = [&](double i, double k) {
    const Vec3 out = face.fromAxis(i / kSteps * a + k / kSteps * b);
    const double distance = out.norm(), below = std::pow(distance, face.dimension - 1);
    const double room = std::pow(face.radius, face.dimension) - below * distance;
    sum += room / (face.dimension * below) * area.dot(out) / distance;
    ++count;
  };
  for (int i = 0; i < kSteps; ++i) {
    for (int k = 0; i + k < kSteps; ++k) {
      sample(i + 1.0 / 3.0, k + 1.0 / 3.0);
      if (i + k + 2 <= kSteps) sample(i + 2.0 / 3.0, k + 2.0 / 3.0);
    }
  }
  return sum / count;
}

/// Faces that turn by up to half a radian from the crossing to a corner: what is left goes with the fourth
/// power of that.
TEST(QuadVolume, FollowsFacesThatTurnMuch) {
  for (const double radius : {2.0, 3.0, 6.0}) {
    for (const Round& face : {Round{radius, 3, Vec3::Zero()}, Round{radius, 2, Vec3(0.6, -0.8, 0)}}) {
      const std::array<Vec3, 4> corners = {face.above(-0.6, -0.4), face.above(0.5, -0.7),
                                           face.above(0.7, 0.5), face.above(-0.4, 0.6)};
      double facets = 0.0, bulge = 0.0;
      for (std::size_t i = 0; i < 4; ++i) {
        const Vec3 &a = corners[i], &b = corners[(i + 1) % 4];
        facets += cone(Vec3::Zero(), a, b);
        bulge += bulgeOut(face, a, b);
      }
      const double turn2 = 1.0 / (radius * radius);  // of which the quadratic misses a tenth
      EXPECT_NEAR(quadVolume(corners, Vec3::Zero(), Vec3::UnitZ(), kApex).volume, facets + bulge,
                  (0.21 * turn2 * turn2 + 3e-5) * bulge)
          << face.dimension << " " << radius;
    }
  }
}

/// A corner of a face whose edge lies in the plane m * p = d: where the edge is at this x, and which way it
/// runs.
struct EdgePoint {
  Vec3 p, along;
};
EdgePoint edgeAt(const Round& face, const Vec3& m, double d, double x) {
  double low = -0.5, high = 1.5;  // of y: the plane rises
  for (int i = 0; i < 60; ++i) {
    const double y = 0.5 * (low + high);
    (m.dot(face.above(x, y)) < d ? low : high) = y;
  }
  const Vec3 p = face.above(x, low);
  return {p, m.cross(face.fromAxis(p)).normalized()};
}

/// Where the edge of a face bends, the piece ends at it: between the wall on its chord and the edge is a
/// strip.
TEST(QuadVolume, EndsAtFeatureEdgesThatBend) {
  const Round face{5.0, 3, Vec3::Zero()};
  for (const Vec3& m : {Vec3(0, 0.8, 0.6), Vec3(0, 0.6, -0.8), Vec3(0.1, 0.7, 0.7)}) {
    const double d = 0.3;
    const EdgePoint left = edgeAt(face, m, d, -0.55), right = edgeAt(face, m, d, 0.45);
    const std::array<Vec3, 4> corners = {face.above(-0.5, -0.4), face.above(0.6, -0.5), right.p, left.p};
    const std::array<Vec3, 4> feature_edges = {Vec3::Zero(), Vec3::Zero(), right.along, -left.along};
    // Strips across the chord: triangles of a place on it, the face over that, and the edge.
    constexpr int kSteps = 400;
    const Vec3 edge = left.p - right.p, outward = edge.cross(Vec3::UnitZ()).normalized();
    double strip = 0.0;
    for (int i = 0; i < kSteps; ++i) {
      const Vec3 at = right.p + (i + 0.5) / kSteps * edge;
      const double over = face.above(at.x(), at.y()).z() - at.z();
      const Vec3 off = edgeAt(face, m, d, at.x()).p - at;
      strip += 0.5 * over * outward.dot(off) * edge.head<2>().norm() / kSteps;
    }
    const auto volume = [&](const std::array<Vec3, 4>& ways) {
      return quadVolume(corners, Vec3::Zero(), Vec3::UnitZ(), kApex, 0x3, ways).volume;
    };
    EXPECT_GT(std::abs(strip), 1e-5);
    EXPECT_NEAR(volume(feature_edges) - volume(kNoFeatureEdges), strip, 0.05 * std::abs(strip))
        << m.transpose();
  }
}

// Ways that lean from the chord, or bend to both sides of it, are not those of its ends.
TEST(QuadVolume, LeavesFeatureEdgesOfOtherCornersAlone) {
  const Round face{5.0, 3, Vec3::Zero()};
  const std::array<Vec3, 4> corners = {face.above(-0.5, -0.4), face.above(0.6, -0.5), face.above(0.5, 0.4),
                                       face.above(-0.4, 0.5)};
  const double whole = quadVolume(corners, Vec3::Zero(), Vec3::UnitZ(), kApex, 0x3).volume;
  for (const Vec3& way : {Vec3(0, 1, 0), Vec3(0.4, 0.9, 0).normalized(), Vec3(0.9, 0.3, 0.1).normalized()}) {
    const std::array<Vec3, 4> feature_edges = {Vec3::Zero(), Vec3::Zero(), way, way};
    EXPECT_EQ(quadVolume(corners, Vec3::Zero(), Vec3::UnitZ(), kApex, 0x3, feature_edges).volume, whole);
  }
}

/// A whole sphere on a grid: each crossing of an edge with a quad between the means of the crossings around
/// its four cells, pushed onto the sphere.
class GriddedSphere {
 public:
  explicit GriddedSphere(double radius) : radius_(radius), reach_(static_cast<int>(radius) + 2) {
    forEachCrossing([&](const Cell& at, int axis, const Vec3& p) {
      for (const Cell& cell : cellsAround(at, axis)) {
        Sum& sum = sums_[cell];
        sum.p += p;
        ++sum.count;
      }
    });
  }

  double volume() const {
    double sum = 0.0;
    forEachCrossing([&](const Cell& at, int axis, const Vec3& p) {
      std::array<Vec3, 4> corners;
      const auto cells = cellsAround(at, axis);
      const bool rising = (p - kCenter)[axis] > 0.0;
      for (std::size_t i = 0; i < 4; ++i) corners[i] = vertex(cells[rising ? i : 3 - i]);
      sum += quadVolume(corners, p, (p - kCenter).normalized(), Vec3::Zero()).volume;
    });
    return sum;
  }

 private:
  using Cell = std::array<int, 3>;
  struct Sum {
    Vec3 p = Vec3::Zero();
    int count = 0;
  };
  static inline const Vec3 kCenter{0.31, 0.17, 0.43};

  /// CCW as seen from where the axis leads to.
  static std::array<Cell, 4> cellsAround(const Cell& at, int axis) {
    std::array<Cell, 4> out;
    constexpr int kBack[4][2] = {{1, 1}, {0, 1}, {0, 0}, {1, 0}};
    for (std::size_t i = 0; i < 4; ++i) {
      out[i] = at;
      out[i][static_cast<std::size_t>((axis + 1) % 3)] -= kBack[i][0];
      out[i][static_cast<std::size_t>((axis + 2) % 3)] -= kBack[i][1];
    }
    return out;
  }
  Vec3 vertex(const Cell& cell) const {
    const Sum& sum = sums_.at(cell);
    return kCenter + radius_ * (sum.p / sum.count - kCenter).normalized();
  }
  template <typename Use>
  void forEachCrossing(const Use& use) const {
    for (int axis = 0; axis < 3; ++axis) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      for (int i = -reach_; i <= reach_; ++i) {
        for (int k = -reach_; k <= reach_; ++k) {
          const double a = i - kCenter[u], b = k - kCenter[v], half2 = radius_ * radius_ - a * a - b * b;
          if (half2 <= 0.0) continue;
          for (const double side : {-1.0, 1.0}) {
            Vec3 p;
            p[u] = i;
            p[v] = k;
            p[axis] = kCenter[axis] + side * std::sqrt(half2);
            Cell at;
            for (int n = 0; n < 3; ++n) at[static_cast<std::size_t>(n)] = static_cast<int>(std::floor(p[n]));
            use(at, axis, p);
          }
        }
      }
    }
  }

  double radius_;
  int reach_;
  std::map<Cell, Sum> sums_;
};

/// Without wedges 0.009 to 0.018 are left, whatever the radius. Quads whose corners are nearly a
/// parallelogram have none still.
TEST(QuadVolume, ClosesAroundASphere) {
  for (const double radius : {5.0, 7.0, 10.0, 14.0, 20.0}) {
    const double exact = 4.0 / 3.0 * kPi * radius * radius * radius;
    EXPECT_NEAR(GriddedSphere(radius).volume(), exact, 8e-4 + 0.02 / (radius * radius)) << radius;
  }
}

}  // namespace
}  // namespace proveout
