#include "core/mesh/faces/tidy_faces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/mesh/faces/round_fit.h"

namespace proveout {

double residualOf(const CadFace& face, const std::vector<Vec3>& points) {
  double most = 0.0;
  for (const Vec3& p : points) most = std::max(most, std::abs(face.distance(p)));
  return most;
}

namespace tidy_detail {

/// Farther off, mm or rad, two faces are not looked at together.
constexpr double kNearby = 0.02;
constexpr std::size_t kMostDirections = 64;

bool hasAxis(const CadFace& face) { return face.kind != SurfaceKind::kSphere; }
bool isRound(const CadFace& face) { return face.kind != SurfaceKind::kPlane; }

class Tidier {
 public:
  Tidier(double near_mm, std::vector<FittedFace>& faces) : near_(near_mm), faces_(faces) {}

  void run() {
    std::vector<std::uint32_t> order(faces_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return faces_[a].weight > faces_[b].weight; });
    for (const std::uint32_t f : order) {
      FittedFace& face = faces_[f];
      if (hasAxis(face.face)) direct(face);
      if (isRound(face.face)) line(face);
      roundPlace(face);
      roundSizes(face);
    }
  }

 private:
  bool take(const CadFace& candidate, FittedFace& into) const {
    if (residualOf(candidate, into.points) > near_) return false;
    into.face = candidate;
    return true;
  }

  bool turnTo(const Vec3& direction, FittedFace& f) const {
    CadFace candidate = f.face;
    candidate.axis = f.face.axis.dot(direction) < 0.0 ? Vec3(-direction) : direction;
    if ((candidate.axis - f.face.axis).norm() > kNearby) return false;
    if (candidate.axis == f.face.axis) return true;
    if (candidate.kind == SurfaceKind::kPlane) {
      double sum = 0.0;
      for (const Vec3& p : f.points) sum += candidate.distance(p) / static_cast<double>(f.points.size());
      candidate.origin += sum * candidate.axis;
    } else if (!fitRound(f.points, false, candidate)) {
      return false;
    }
    return take(candidate, f);
  }

  void direct(FittedFace& f) {
    for (int k = 0; k < 3; ++k)
      if (turnTo(Vec3::Unit(k), f)) return;
    for (const Vec3& direction : directions_)
      if (turnTo(direction, f)) return;
    if (directions_.size() < kMostDirections) directions_.push_back(f.face.axis);
  }

  /// Puts it on the axis of another one, if it is nearly there.
  void line(FittedFace& f) {
    const bool sphere = f.face.kind == SurfaceKind::kSphere;
    for (const CadFace& other : lines_) {
      if (!sphere && f.face.axis.cross(other.axis).norm() > 1e-12) continue;
      const Vec3 from = f.face.origin - other.origin;
      const Vec3 off = from - from.dot(other.axis) * other.axis;
      if (off.norm() > kNearby) continue;
      CadFace candidate = f.face;
      candidate.origin -= off;
      if (take(candidate, f)) return;
    }
    if (!sphere) lines_.push_back(f.face);
  }

  static double rounded(double value, double step) { return step * std::round(value / step); }

  /// Coordinates one by one: of planes that along the normal, of lines those across.
  void roundPlace(FittedFace& f) const {
    for (int k = 0; k < 3; ++k) {
      const bool plane = f.face.kind == SurfaceKind::kPlane;
      const double along = hasAxis(f.face) ? std::abs(f.face.axis[k]) : 0.0;
      if (plane ? along < 1.0 : along == 1.0 && f.face.kind != SurfaceKind::kTorus) continue;
      for (const double step : {0.01, 0.001}) {
        CadFace candidate = f.face;
        candidate.origin[k] = rounded(f.face.origin[k], step);
        if (take(candidate, f)) break;
      }
    }
  }

  /// Angles before radii: a cone's radius is told where its points are.
  void roundSizes(FittedFace& f) const {
    if (f.face.kind == SurfaceKind::kCone) {
      for (const double step : {0.5, 0.05}) {
        CadFace candidate = f.face;
        candidate.half_angle_rad = degToRad(rounded(radToDeg(f.face.half_angle_rad), step));
        double sum = 0.0;
        for (const Vec3& p : f.points) sum += candidate.distance(p) / static_cast<double>(f.points.size());
        candidate.radius += (candidate.hollow ? -sum : sum) / std::cos(candidate.half_angle_rad);
        if (take(candidate, f)) break;
      }
      return;
    }
    if (f.face.kind == SurfaceKind::kPlane) return;
    for (double CadFace::*size : {&CadFace::radius, &CadFace::tube_radius}) {
      if (size == &CadFace::tube_radius && f.face.kind != SurfaceKind::kTorus) continue;
      for (const double step : {0.005, 0.0005}) {
        CadFace candidate = f.face;
        candidate.*size = rounded(f.face.*size, step);
        if (candidate.*size > 0.0 && take(candidate, f)) break;
      }
    }
  }

  const double near_;
  std::vector<FittedFace>& faces_;
  std::vector<Vec3> directions_;
  std::vector<CadFace> lines_;
};

}  // namespace tidy_detail

void tidyFaces(double near_mm, std::vector<FittedFace>& faces) { tidy_detail::Tidier(near_mm, faces).run(); }

}  // namespace proveout
