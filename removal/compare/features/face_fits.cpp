#include "removal/compare/features/face_fits.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include "core/base/parallel_for.h"

namespace proveout {

Vec3 FaceFit::shift(const CadFace& nominal) const {
  if (nominal.kind == SurfaceKind::kSphere || nominal.kind == SurfaceKind::kTorus)
    return fitted.origin - nominal.origin;
  // Where either axis meets the plane across the model's at the middle.
  const double height = (middle - nominal.origin).dot(nominal.axis);
  const Vec3 at = nominal.origin + height * nominal.axis;
  const double along = fitted.axis.dot(nominal.axis);
  if (std::abs(along) < 1e-6) return Vec3::Zero();
  return fitted.origin + (at - fitted.origin).dot(nominal.axis) / along * fitted.axis - at;
}

namespace face_fit_detail {

/// So many places of a face are measured at most; fewer where there are many faces.
constexpr std::size_t kMostPlaces = 400, kFewestPlaces = 60, kPlacesInAll = 200'000;
/// A round that goes less far round does not say where its axis is; one that is shorter, for its radius, does
/// not say how it is tilted.
constexpr double kLeastTurn = degToRad(60.0), kLeastLength = 0.25;
/// The part's surface looks the face's way to within 60 degrees.
constexpr double kAlike = 0.5;

/// The middle of a sample triangle, on the face.
Vec3 placeOn(const SampleMesh& goal, std::size_t triangle, const CadFace& face) {
  const Vec3 middle = goal.surface.middle(triangle);
  return middle - face.distance(middle) * face.normalAt(middle);
}

/// The places of each face by their sample triangles, thinned.
std::vector<std::vector<std::size_t>> placesOf(const SampleMesh& goal, const CadFaces& faces) {
  std::vector<std::vector<std::size_t>> out(faces.faces.size());
  for (std::size_t t = 0; t < goal.parent.size(); ++t) {
    const std::uint32_t face = faces.of_triangle[goal.parent[t]];
    if (face != kNoFace && faces.faces[face].kind != SurfaceKind::kOther) out[face].push_back(t);
  }
  const std::size_t most =
      std::clamp(kPlacesInAll / std::max<std::size_t>(1, out.size()), kFewestPlaces, kMostPlaces);
  for (std::vector<std::size_t>& list : out) {
    if (list.size() <= most) continue;
    std::vector<std::size_t> some;
    for (std::size_t k = 0; k < most; ++k) some.push_back(list[k * list.size() / most]);
    list = std::move(some);
  }
  return out;
}

/// Where the part's surface lies along a line through `p`: by steps as large as the part allows.
std::optional<Vec3> surfaceAlong(const ExactPart& part, const Vec3& p, const Vec3& direction,
                                 double reach_mm) {
  constexpr int kSteps = 100;
  constexpr double kAtRest = 1e-7;
  double t = 0.0;
  for (int step = 0; step < kSteps; ++step) {
    const Vec3 at = p + t * direction;
    const ExactPart::Sample s = part.at(at, reach_mm);
    const double facing = s.normal.dot(direction);
    if (std::abs(s.value) <= kAtRest) return facing >= kAlike ? std::optional(at) : std::nullopt;
    // Near a surface that looks the same way the step to it is known; else no farther than is surely free.
    t -= facing >= kAlike && step > 0 ? s.value / facing : s.value;
    if (std::abs(t) > reach_mm) return std::nullopt;
  }
  return std::nullopt;
}

/// What of a face can be fitted: some of radius, second radius or angle, place and direction.
class Freedom {
 public:
  Freedom(const CadFace& face, bool placed, bool tilted, const Vec3& middle) {
    const Vec3 u = face.axis.unitOrthogonal(), v = face.axis.cross(u);
    if (face.kind == SurfaceKind::kPlane) {
      moves_.push_back([axis = face.axis](CadFace& f, double by) { f.origin += by * axis; });
    } else if (face.kind == SurfaceKind::kTorus) {
      moves_.push_back([](CadFace& f, double by) { f.tube_radius += by; });
      if (placed) moves_.push_back([](CadFace& f, double by) { f.radius += by; });
    } else {
      moves_.push_back([](CadFace& f, double by) { f.radius += by; });
    }
    if (face.kind == SurfaceKind::kCone)
      moves_.push_back([](CadFace& f, double by) { f.half_angle_rad += by; });
    if (placed) {
      for (const Vec3& way : {u, v}) moves_.push_back([way](CadFace& f, double by) { f.origin += by * way; });
      if (face.kind == SurfaceKind::kSphere || face.kind == SurfaceKind::kTorus)
        moves_.push_back([axis = face.axis](CadFace& f, double by) { f.origin += by * axis; });
    }
    if (tilted || face.kind == SurfaceKind::kPlane) {
      for (const Vec3& about : {u, v}) {
        moves_.push_back([about, middle](CadFace& f, double by) {
          const Eigen::AngleAxisd turn(by, about);
          f.origin = middle + turn * (f.origin - middle);
          f.axis = turn * f.axis;
        });
      }
    }
  }
  Eigen::Index size() const { return static_cast<Eigen::Index>(moves_.size()); }
  void move(CadFace& face, const Eigen::VectorXd& by) const {
    for (Eigen::Index k = 0; k < size(); ++k) moves_[static_cast<std::size_t>(k)](face, by[k]);
  }

 private:
  std::vector<std::function<void(CadFace&, double)>> moves_;
};

/// Distances of points from a face and how they go with what is free; the surface's own: material outside of
/// the face counts positive.
void linearize(const CadFace& face, const Freedom& freedom, const std::vector<Vec3>& points,
               Eigen::MatrixXd& a, Eigen::VectorXd& b) {
  constexpr double kStep = 1e-4;
  const auto count = static_cast<Eigen::Index>(points.size());
  a.resize(count, freedom.size());
  b.resize(count);
  for (Eigen::Index k = 0; k < count; ++k) b[k] = face.distance(points[static_cast<std::size_t>(k)]);
  for (Eigen::Index j = 0; j < freedom.size(); ++j) {
    Eigen::VectorXd by = Eigen::VectorXd::Zero(freedom.size());
    by[j] = kStep;
    CadFace more = face, less = face;
    freedom.move(more, by);
    freedom.move(less, -by);
    for (Eigen::Index k = 0; k < count; ++k) {
      const Vec3& p = points[static_cast<std::size_t>(k)];
      a(k, j) = (less.distance(p) - more.distance(p)) / (2.0 * kStep);
    }
  }
}

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Gauss and Newton over the points that belong: those no farther off the fit than several times what half of
/// them are.
void fit(const CadFace& nominal, const std::vector<Vec3>& points, double other_face_mm, FaceFit& out) {
  constexpr int kSteps = 12;
  constexpr double kSpread = 3.0, kAtRest = 1e-9;
  const Freedom freedom(nominal, out.placed, out.tilted, out.middle);
  std::vector<Vec3> taken = points;
  out.fitted = nominal;
  Eigen::MatrixXd a;
  Eigen::VectorXd b;
  for (int step = 0; step < kSteps; ++step) {
    if (static_cast<Eigen::Index>(taken.size()) < freedom.size()) break;
    linearize(out.fitted, freedom, taken, a, b);
    const Eigen::VectorXd x = a.colPivHouseholderQr().solve(b);
    freedom.move(out.fitted, x);
    std::vector<double> off;
    for (const Vec3& p : points) off.push_back(std::abs(out.fitted.distance(p)));
    const double limit = std::max(other_face_mm, kSpread * medianOf(off));
    taken.clear();
    for (std::size_t k = 0; k < points.size(); ++k)
      if (off[k] <= limit) taken.push_back(points[k]);
    if (x.cwiseAbs().maxCoeff() <= kAtRest) break;
  }
  double least = 0.0, most = 0.0, sum = 0.0;
  std::size_t count = 0;
  for (const Vec3& p : points) {
    const double left = out.fitted.distance(p), off = nominal.distance(p);
    if (std::abs(left) > other_face_mm) continue;
    least = count == 0 ? left : std::min(least, left);
    most = count == 0 ? left : std::max(most, left);
    out.least_mm = count == 0 ? off : std::min(out.least_mm, off);
    out.most_mm = count == 0 ? off : std::max(out.most_mm, off);
    sum += off;
    ++count;
  }
  out.missed += points.size() - count;
  out.points = count;
  if (count > 0) out.mean_mm = sum / static_cast<double>(count);
  out.form_mm = most - least;
}

/// How far the places go along the face's axis.
double lengthOf(const std::vector<Vec3>& places, const CadFace& face) {
  double low = 1e300, high = -1e300;
  for (const Vec3& p : places) {
    const double along = (p - face.origin).dot(face.axis);
    low = std::min(low, along);
    high = std::max(high, along);
  }
  return std::max(0.0, high - low);
}

/// How far off a face its like is looked for, mm: a hole of another size, a floor at another height.
double reachOf(const CadFace& face) {
  constexpr double kLeast = 3.0, kMost = 10.0, kShare = 0.75;
  if (face.kind == SurfaceKind::kPlane) return kMost;
  const double radius = face.kind == SurfaceKind::kTorus ? face.tube_radius : face.radius;
  return std::clamp(kShare * radius, kLeast, kMost);
}

FaceFit fitOf(const SampleMesh& goal, const CadFace& face, const std::vector<std::size_t>& triangles,
              const ExactPart& part) {
  /// A point that is so far off the fit of the others is of another face, mm.
  constexpr double kOtherFace = 0.5;
  FaceFit out;
  out.fitted = face;
  const double reach_mm = reachOf(face);
  std::vector<Vec3> places, points;
  for (const std::size_t triangle : triangles) {
    const Vec3 place = placeOn(goal, triangle, face);
    const auto found = surfaceAlong(part, place, face.normalAt(place), reach_mm);
    if (!found) {
      ++out.missed;
      continue;
    }
    places.push_back(place);
    points.push_back(*found);
    out.middle += place;
  }
  if (points.empty()) return out;
  out.middle /= static_cast<double>(points.size());
  const bool round = face.kind == SurfaceKind::kCylinder || face.kind == SurfaceKind::kCone;
  out.placed = face.kind == SurfaceKind::kSphere || face.kind == SurfaceKind::kTorus ||
               (round && face.turn_rad >= kLeastTurn);
  out.tilted = face.kind == SurfaceKind::kPlane ||
               (face.isWholeCylinder() && lengthOf(places, face) >= kLeastLength * face.radius);
  fit(face, points, kOtherFace, out);
  out.maker = part.at(points[points.size() / 2], reach_mm).maker;
  return out;
}

}  // namespace face_fit_detail

std::vector<FaceFit> fitFaces(const SampleMesh& goal, const CadFaces& faces, const ExactPart& part) {
  const std::vector<std::vector<std::size_t>> places = face_fit_detail::placesOf(goal, faces);
  std::vector<FaceFit> all(places.size());
  parallelFor(std::size_t{0}, places.size(), [&](std::size_t k) {
    if (!places[k].empty()) all[k] = face_fit_detail::fitOf(goal, faces.faces[k], places[k], part);
    all[k].face = static_cast<std::uint32_t>(k);
  });
  std::erase_if(all, [&](const FaceFit& f) { return places[f.face].empty(); });
  return all;
}

}  // namespace proveout
