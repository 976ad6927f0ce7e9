#include "removal/compare/fit/fit.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"
#include "removal/compare/fit/point_cells.h"
#include "removal/compare/measured_sides.h"

namespace proveout {
namespace fit_detail {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Fewer points, and less than this share of them, near the nominal say nothing.
constexpr std::size_t kFewestPoints = 30;
constexpr double kLeastShare = 0.1;
/// Of scans, which may have millions: a fit does not get better by more.
constexpr std::size_t kMostPoints = 400'000;
/// The way to about the right place is found with so many of them.
constexpr std::size_t kFirstPoints = 10'000;
/// Tukey's constant, in standard deviations: 95 % as efficient as least squares where all errors are normal.
constexpr double kTukey = 4.685, kSigmaOfMedian = 1.4826;
/// Deviations up to about this count as what the part is, mm, however good the rest is.
constexpr double kLeastWidth = 0.02;
/// Directions in which the surface, moved by a unit, moves less than the root of this along its normal.
constexpr double kSettled = 1e-4;
/// Facets of a curved face that turn less against each other than this are one face.
constexpr double kSmoothCos = 0.866;

/// Directions of the nominal's surface. On curved faces they are those of the face, not of its facets: what
/// turns freely would be held by the corners of the facets.
class Directions {
 public:
  Directions(const NominalModel& model, const CadFaces* faces) : model_(model), faces_(faces) {
    const SurfaceMesh& mesh = model.surface;
    normal_.resize(mesh.triangles.size());
    curved_.resize(mesh.triangles.size());
    for (std::uint32_t t = 0; t < normal_.size(); ++t) {
      normal_[t] = mesh.areaVector(t).normalized();
      curved_[t] = model.shape.largest() > 0.0 && model.shape.at(t, mesh.middle(t)) != 0.0;
    }
    if (std::find(curved_.begin(), curved_.end(), true) != curved_.end()) smoothCorners();
  }

  /// At the foot of a point, which is nearest to it.
  Vec3 at(const SurfaceDistance& d, const Vec3& foot) const {
    if (faces_ != nullptr) {
      if (const CadFace* face = faces_->exactAt(d.triangle)) return face->normalAt(foot);
    }
    if (!curved_[d.triangle]) return d.part == kFacePart ? normal_[d.triangle] : d.gradient.cast<double>();
    const std::array<Vec3, 3>& corners = corner_[d.triangle];
    const Vec3 shares = sharesOf(d.triangle, foot);
    return (shares[0] * corners[0] + shares[1] * corners[1] + shares[2] * corners[2]).normalized();
  }

 private:
  Vec3 sharesOf(std::uint32_t t, const Vec3& point) const {
    const auto& v = model_.surface.triangles[t];
    const auto& p = model_.surface.points;
    const Vec3 normal = model_.surface.areaVector(t);
    Vec3 out;
    for (int c = 0; c < 3; ++c) {
      const Vec3 &a = p[v[(c + 1) % 3]], &b = p[v[(c + 2) % 3]];
      out[c] = std::clamp((a - point).cross(b - point).dot(normal) / normal.squaredNorm(), 0.0, 1.0);
    }
    return out;
  }

  double angleAt(std::uint32_t t, std::size_t c) const {
    const auto& v = model_.surface.triangles[t];
    const auto& p = model_.surface.points;
    const Vec3 a = p[v[(c + 1) % 3]] - p[v[c]], b = p[v[(c + 2) % 3]] - p[v[c]];
    return std::atan2(a.cross(b).norm(), a.dot(b));
  }

  /// Of each corner of a curved facet: the mean of the curved facets around it that turn little against it,
  /// weighted by their angles there.
  void smoothCorners() {
    const auto& triangles = model_.surface.triangles;
    std::vector<std::vector<std::pair<std::uint32_t, double>>> around(model_.surface.points.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      if (!curved_[t]) continue;
      for (std::size_t c = 0; c < 3; ++c) around[triangles[t][c]].emplace_back(t, angleAt(t, c));
    }
    corner_.resize(triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      if (!curved_[t]) continue;
      for (std::size_t c = 0; c < 3; ++c) {
        Vec3 sum = Vec3::Zero();
        for (const auto& [other, angle] : around[triangles[t][c]]) {
          if (normal_[other].dot(normal_[t]) >= kSmoothCos) sum += angle * normal_[other];
        }
        corner_[t][c] = sum.normalized();
      }
    }
  }

  const NominalModel& model_;
  const CadFaces* faces_;
  std::vector<Vec3> normal_;
  std::vector<bool> curved_;
  std::vector<std::array<Vec3, 3>> corner_;  ///< of curved facets; empty: there are none
};

/// A point of the part as it lies to the nominal.
struct Row {
  double off = 0.0;  ///< signed distance, mm
  Vec3 normal;       ///< of the nominal there, unit
};

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

class Fitter {
 public:
  Fitter(const NominalModel& model, const CadFaces* faces, const FitPoints& part, double limit_mm,
         Progress& progress)
      : model_(model),
        faces_(faces),
        directions_(model, faces),
        bulge_share_(part.of_facets ? 0.5 : 1.0),
        gate_(2.0 * limit_mm),
        progress_(progress) {
    takePoints(part.points);
  }

  Result<Alignment> run() {
    double width = gate_;
    if (const Status found = approach(std::max<std::size_t>(1, points_.size() / kFirstPoints), 60, width);
        !found)
      return found.error();
    if (const Status found = approach(1, 20, width); !found) return found.error();
    Alignment out;
    out.kind = AlignKind::kFit;
    out.motion = to_nominal_.inverse();
    out.free_directions = free_;
    double squares = 0.0;
    for (const Row& row : rows_) {
      if (std::abs(row.off) >= width) continue;
      ++out.points;
      squares += row.off * row.off;
    }
    out.left_out = rows_.size() - out.points;
    if (out.points > 0) out.rms_mm = std::sqrt(squares / static_cast<double>(out.points));
    return out;
  }

 private:
  /// In an order in which neighbours follow each other; where many crowd, each has less weight.
  void takePoints(const std::vector<Vec3>& points) {
    constexpr double kInACell = 25.0;
    double area = 0.0;
    for (std::size_t t = 0; t < model_.surface.triangles.size(); ++t)
      area += 0.5 * model_.surface.areaVector(t).norm();
    const double spacing = std::sqrt(area / static_cast<double>(std::max<std::size_t>(1, points.size())));
    const PointCells cells(points, std::sqrt(kInACell) * spacing);
    const std::vector<std::uint32_t> crowds = cells.crowds();
    std::vector<double> sorted(crowds.begin(), crowds.end());
    const double usual = sorted.empty() ? 1.0 : medianOf(std::move(sorted));
    const std::size_t step = 1 + (points.size() - (points.empty() ? 0 : 1)) / kMostPoints;
    for (std::size_t k = 0; k < points.size(); k += step) {
      const std::uint32_t i = cells.order()[k];
      points_.push_back(points[i]);
      weight_.push_back(std::min(1.0, usual / crowds[i]));
    }
  }

  /// Steps until they get nowhere; with every `step`-th point. `width`: beyond it points have no weight.
  Status approach(std::size_t step, int most_steps, double& width) {
    constexpr double kAtRest = 1e-6;  // mm
    for (int k = 0; k < most_steps; ++k) {
      if (const Status done = measure(step); !done) return done;
      std::vector<double> off;
      for (const Row& row : rows_)
        if (std::abs(row.off) <= gate_) off.push_back(std::abs(row.off));
      const double needed =
          std::max(static_cast<double>(kFewestPoints), kLeastShare * static_cast<double>(rows_.size()));
      if (static_cast<double>(off.size()) < needed)
        return inputError(fmt::format("only {} of {} points of the part lie within {:g} mm of the nominal",
                                      off.size(), rows_.size(), gate_));
      const double wanted = std::max(kLeastWidth, kTukey * kSigmaOfMedian * medianOf(std::move(off)));
      const double last = width;
      width = std::min(gate_, std::max(wanted, 0.5 * width));
      const double moved = improve(step, width);
      // The width follows the median, which changes with every step by less and less.
      if (moved <= kAtRest && std::abs(width - last) <= 1e-3 * width) break;
    }
    return Done{};
  }

  Status measure(std::size_t step) {
    std::vector<Vec3> at;
    at.reserve(points_.size() / step + 1);
    for (std::size_t i = 0; i < points_.size(); i += step) at.push_back(to_nominal_(points_[i]));
    const std::vector<SurfaceDistance> distances = model_.distance.at(at, progress_, 0.0, 1.0);
    if (progress_.cancelled()) return Error{ErrorKind::kInterrupted, "fit interrupted"};
    rows_.resize(at.size());
    PROVEOUT_ASSERT(distances.size() == at.size());
    parallelFor(std::size_t{0}, at.size(), [&](std::size_t i) { rows_[i] = rowOf(at[i], distances[i]); });
    return Done{};
  }

  Row rowOf(const Vec3& p, const SurfaceDistance& d) const {
    const Vec3 foot = p - d.distance * d.gradient.cast<double>();
    Row row{d.distance, directions_.at(d, foot)};
    const CadFace* const face = faces_ != nullptr ? faces_->exactAt(d.triangle) : nullptr;
    if (face != nullptr && d.part == kFacePart) {
      row.off = face->distance(p);
      return row;
    }
    const Bulge bulge = model_.shape.at(d, p);
    row.off -= bulge_share_ * (bulge.low + bulge.high);
    return row;
  }

  /// One step of Gauss and Newton. Returns how far it moved points, mm, about.
  double improve(std::size_t step, double width) {
    Vec3 middle = Vec3::Zero();
    double sum = 0.0;
    std::vector<double> weights(rows_.size(), 0.0);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const double part = rows_[i].off / width;
      if (std::abs(part) >= 1.0) continue;
      weights[i] = weight_[i * step] * (1.0 - part * part) * (1.0 - part * part);
      sum += weights[i];
      middle += weights[i] * to_nominal_(points_[i * step]);
    }
    if (!(sum > 0.0)) return 0.0;
    middle /= sum;
    double squares = 0.0;
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (weights[i] > 0.0) squares += weights[i] * (to_nominal_(points_[i * step]) - middle).squaredNorm();
    const double lever = std::max(1e-6, std::sqrt(squares / sum));
    Matrix6 normal = Matrix6::Zero();
    Vector6 slope = Vector6::Zero();
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (!(weights[i] > 0.0)) continue;
      Vector6 row;
      row << rows_[i].normal, (to_nominal_(points_[i * step]) - middle).cross(rows_[i].normal) / lever;
      normal.selfadjointView<Eigen::Lower>().rankUpdate(row, weights[i] / sum);
      slope += weights[i] / sum * rows_[i].off * row;
    }
    return take(settledStep(normal.selfadjointView<Eigen::Lower>(), slope), middle, lever);
  }

  /// Without the directions that the surface does not settle.
  Vector6 settledStep(const Matrix6& normal, const Vector6& slope) {
    const Eigen::SelfAdjointEigenSolver<Matrix6> eigen(normal);
    Vector6 out = Vector6::Zero();
    free_ = 0;
    for (int k = 0; k < 6; ++k) {
      const double value = eigen.eigenvalues()[k];
      if (value < kSettled) {
        ++free_;
        continue;
      }
      const Vector6 way = eigen.eigenvectors().col(k);
      out -= way.dot(slope) / value * way;
    }
    return out;
  }

  double take(const Vector6& by, const Vec3& middle, double lever) {
    constexpr double kLargestTurn = 0.5;
    Vec3 turn = by.tail<3>() / lever;
    if (turn.norm() > kLargestTurn) turn *= kLargestTurn / turn.norm();
    const double angle = turn.norm();
    RigidTransform change;
    if (angle > 0.0) change.rotation = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
    change.translation = middle - change.rotation * middle + by.head<3>();
    to_nominal_ = change * to_nominal_;
    // Kept orthogonal over many steps.
    to_nominal_.rotation = Eigen::Quaterniond(to_nominal_.rotation).normalized().toRotationMatrix();
    return by.head<3>().norm() + by.tail<3>().norm();
  }

  const NominalModel& model_;
  const CadFaces* faces_;
  Directions directions_;
  double bulge_share_, gate_;
  Progress& progress_;
  std::vector<Vec3> points_;
  std::vector<double> weight_;
  std::vector<Row> rows_;      ///< of every so-manieth of the points
  RigidTransform to_nominal_;  ///< the part onto the nominal
  int free_ = 0;
};

/// A sequence that fills the unit square evenly (generalized golden ratio; M. Roberts, "The unreasonable
/// effectiveness of quasirandom sequences", 2018).
Vec2 spread(std::size_t k) {
  constexpr double kGolden = 1.32471795724474602596;
  const double i = static_cast<double>(k) + 0.5;
  const Vec2 out(i / kGolden, i / (kGolden * kGolden));
  return out - out.array().floor().matrix();
}

/// A point for each share of the area.
std::vector<Vec3> spreadPoints(const TriMesh& mesh, std::size_t count) {
  const SurfaceMesh surface = toSurface(mesh);
  std::vector<Vec3> out;
  double sum = 0.0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) sum += 0.5 * surface.areaVector(t).norm();
  if (!(sum > 0.0)) return out;
  const double share = sum / static_cast<double>(count);
  double due = 0.5 * share;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& v = surface.triangles[t];
    due += 0.5 * surface.areaVector(t).norm();
    for (; due >= share; due -= share) {
      Vec2 uv = spread(out.size());
      if (uv.sum() > 1.0) uv = Vec2(1.0, 1.0) - uv;
      const Vec3 &a = surface.points[v[0]], &b = surface.points[v[1]], &c = surface.points[v[2]];
      out.push_back(a + uv.x() * (b - a) + uv.y() * (c - a));
    }
  }
  return out;
}

}  // namespace fit_detail

FitPoints fitPointsOf(const TriMesh& machined, const ExactPart* part, double reach_mm,
                      const std::vector<IgnoredRegion>& ignored, std::size_t most) {
  FitPoints out;
  out.of_facets = part == nullptr;
  out.points = fit_detail::spreadPoints(machined, std::max<std::size_t>(1, most));
  std::erase_if(out.points, [&](const Vec3& p) {
    return std::any_of(ignored.begin(), ignored.end(), [&](const IgnoredRegion& r) { return r.contains(p); });
  });
  if (part == nullptr) return out;
  parallelFor(std::size_t{0}, out.points.size(), [&](std::size_t i) {
    const SettledPoint at = settle(*part, out.points[i], reach_mm);
    if (at.found) out.points[i] = at.p;
  });
  return out;
}

Result<Alignment> fitNominal(const TriMesh& nominal, const CadFaces* faces, const FitPoints& part,
                             double limit_mm, Progress& progress) {
  PROVEOUT_ASSERT(limit_mm > 0.0);
  const NominalModel model(nominal, limit_mm, faces);
  Result<Alignment> found = fit_detail::Fitter(model, faces, part, limit_mm, progress).run();
  if (!found) return found;
  found->moved_mm = farthestMove(found->motion, nominal);
  found->turned_rad = turnOf(found->motion);
  return found;
}

double farthestMove(const RigidTransform& motion, const TriMesh& mesh) {
  double most = 0.0;
  for (const auto& position : mesh.positions) {
    const Vec3 p = position.cast<double>();
    most = std::max(most, (motion(p) - p).norm());
  }
  return most;
}

double turnOf(const RigidTransform& motion) {
  return Eigen::AngleAxisd(Eigen::Quaterniond(motion.rotation)).angle();
}

MeshPlacement placementOf(const RigidTransform& motion) {
  return {1.0, xyzDegOf(motion.rotation), motion.translation};
}

}  // namespace proveout
