#include "removal/surface/measure/exact_quad.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace proveout {

namespace {

/// A point found farther from where it was looked for (in cells), or facing elsewhere (cosine), is of another
/// part of the body.
constexpr double kFarthest = 0.6, kSameFacing = 0.3;
/// A corner's normal is the same from all quads around it once it was seen so often from so near (in cells).
constexpr int kRounds = 4;
constexpr double kNear = 0.02;
/// A corner farther than this from the body (in cells) is on another one.
constexpr double kOnBody = 0.01;
/// Heights of corners over the tangent plane of a plane, a sphere or a round cylinder: so many times what its
/// largest bend makes of the square of their distance, and this more, in cells.
constexpr double kOfBend = 0.75, kFlat = 1e-3;
/// Part of the last gain of refining by which the volume may be off.
constexpr double kOfGain = 0.25;

/// Whether all corners may be on a face that bends no more than this.
bool areOnFace(const Quad& quad, double bend) {
  return std::ranges::all_of(quad.p, [&](const Vec3& p) {
    const Vec3 from = p - quad.middle;
    return std::abs(quad.normal.dot(from)) <= kOfBend * bend * from.squaredNorm() + kFlat;
  });
}

}  // namespace

ExactQuad::ExactQuad(const Stock::Impl& impl, const Coord& origin) : exact_(impl, origin) {
  exact_.setCell(impl.position(origin));
}

/// Brings a point onto the body, seen from the material along its normal.
bool ExactQuad::snap(Point& point, double depth) {
  const ExactFaces::Foot foot = exact_.foot(body_, point.p - depth * point.n);
  const bool same =
      foot.normal.dot(point.n) > kSameFacing && (foot.p - point.p).squaredNorm() < kFarthest * kFarthest;
  point = {foot.p, foot.normal};
  return same;
}

/// The points between two of the surface.
bool ExactQuad::between(const Point& from, const Point& to, Row& row) {
  row.front() = from;
  row.back() = to;
  for (int k = 1; k < kParts; ++k) {
    const double part = static_cast<double>(k) / kParts;
    row[k] = {from.p + part * (to.p - from.p), (from.n + part * (to.n - from.n)).normalized()};
    if (!snap(row[k])) return false;
  }
  return true;
}

/// From corner i to the next: on the body, the same for both quads there; on a feature edge along that.
bool ExactQuad::side(const Quad& quad, int i, const std::array<Point, 4>& corners,
                     const std::array<Vec3, 4>& feature_edges, Row& row) {
  const int k = (i + 1) % 4;
  const unsigned both = 1u << i | 1u << k;
  if ((quad.smooth_corners & both) != 0) return between(corners[i], corners[k], row);
  const Vec3 sagitta = featureEdgeSagitta(corners[k].p - corners[i].p, feature_edges[i], feature_edges[k]);
  for (int j = 0; j <= kParts; ++j) {
    const double part = static_cast<double>(j) / kParts;
    row[j].p = corners[i].p + part * (corners[k].p - corners[i].p) + 4.0 * part * (1.0 - part) * sagitta;
  }
  return true;
}

bool ExactQuad::readPiece(const Quad& quad, const std::array<Vec3, 4>& feature_edges) {
  const Point middle{quad.middle, quad.normal};
  std::array<Point, 4> corners;
  for (int i = 0; i < 4; ++i) {
    Point seen{quad.p[i], quad.normal};
    for (int round = 0; round < kRounds; ++round) {
      seen.p = quad.p[i];
      if (!snap(seen, kNear)) return false;
    }
    if ((seen.p - quad.p[i]).squaredNorm() > kOnBody * kOnBody) return false;
    corners[i] = {quad.p[i], seen.n};
  }
  for (int i = 0; i < 4; ++i) {
    if (!between(middle, corners[i], spokes_[i]) || !side(quad, i, corners, feature_edges, sides_[i]))
      return false;
  }
  constexpr std::array<std::array<int, 2>, 3> kInner = {{{1, 1}, {1, 2}, {2, 1}}};
  for (int i = 0; i < 4; ++i) {
    const Point &a = corners[i], &b = corners[(i + 1) % 4];
    for (std::size_t j = 0; j < kInner.size(); ++j) {
      const double u = static_cast<double>(kInner[j][0]) / kParts,
                   v = static_cast<double>(kInner[j][1]) / kParts;
      Point& point = inner_[i][j];
      point.p = middle.p + u * (a.p - middle.p) + v * (b.p - middle.p);
      point.n = (middle.n + u * (a.n - middle.n) + v * (b.n - middle.n)).normalized();
      if (!snap(point)) return false;
    }
  }
  return true;
}

/// What lies between the triangles over every `step`-th point and those over the corners alone. Seen from the
/// crossing, which is a corner of all of the latter, and closed by walls over the chords: where points of
/// neighbouring quads slide along the surface, it matters little so.
double ExactQuad::bulge(int step) const {
  const Vec3 apex = spokes_[0][0].p;
  double sum = 0.0;
  const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    sum += (a - apex).dot((b - a).cross(c - a)) / 6.0;
  };
  for (int i = 0; i < 4; ++i) {
    const Row &first = spokes_[i], &second = spokes_[(i + 1) % 4], &along = sides_[i];
    const auto at = [&](int u, int v) -> Vec3 {
      if (v == 0) return first[u].p;
      if (u == 0) return second[v].p;
      if (u + v == kParts) return along[v].p;
      return inner_[i][u == 1 ? v - 1 : 2].p;
    };
    for (int u = 0; u < kParts; u += step) {
      for (int v = 0; u + v < kParts; v += step) {
        add(at(u, v), at(u + step, v), at(u, v + step));
        if (u + v + step < kParts) add(at(u + step, v), at(u + step, v + step), at(u, v + step));
      }
    }
    for (int k = step; k < kParts; k += step) add(along[0].p, along[k + step].p, along[k].p);
  }
  return sum;
}

std::optional<QuadVolume> ExactQuad::volume(const Quad& quad, const Crossing& c, const Vec3& apex,
                                            const std::array<Vec3, 4>& feature_edges) {
  const ExactFaces::Source source = exact_.source(c.face());
  if (source.body < 0 || exact_.ofBlank() || (source.simple && areOnFace(quad, source.bend)))
    return std::nullopt;
  body_ = source.body;
  if (!readPiece(quad, feature_edges)) return std::nullopt;
  const Vec3 area = (quad.p[2] - quad.p[0]).cross(quad.p[3] - quad.p[1]);
  const double cones = (quad.middle - apex).dot(area) / 6.0, half = bulge(2), fine = bulge(1);
  // Triangles are off by the square of their size, and what is left by its fourth power.
  const double once = half + half / 3.0, twice = fine + (fine - half) / 3.0;
  return QuadVolume{cones + twice, kOfGain * std::abs(twice - once), 0.0, 0.0};
}

}  // namespace proveout
