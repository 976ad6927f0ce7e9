#include "removal/compare/face_fits.h"

#include <Eigen/Dense>
#include <algorithm>
#include <limits>

#include "core/base/parallel_for.h"

namespace proveout {
namespace {

/// So many places of a face are measured at most.
constexpr std::size_t kMostPlaces = 400;
/// A round that goes less far round does not say where its axis is.
constexpr double kLeastTurn = 0.5 * kPi;

/// The middle of a sample triangle, on the face.
Vec3 placeOn(const SampleMesh& goal, std::size_t triangle, const CadFace& face) {
  const auto& v = goal.surface.triangles[triangle];
  const Vec3 middle =
      (goal.surface.points[v[0]] + goal.surface.points[v[1]] + goal.surface.points[v[2]]) / 3.0;
  return middle - face.distance(middle) * face.normalAt(middle);
}

/// The places of each face by their sample triangles, thinned.
std::vector<std::vector<std::size_t>> placesOf(const SampleMesh& goal, const CadFaces& faces) {
  std::vector<std::vector<std::size_t>> out(faces.faces.size());
  for (std::size_t t = 0; t < goal.parent.size(); ++t) {
    const std::uint32_t face = faces.of_triangle[goal.parent[t]];
    if (face != kNoFace && faces.faces[face].kind != SurfaceKind::kOther) out[face].push_back(t);
  }
  for (std::vector<std::size_t>& list : out) {
    if (list.size() <= kMostPlaces) continue;
    std::vector<std::size_t> some;
    for (std::size_t k = 0; k < kMostPlaces; ++k) some.push_back(list[k * list.size() / kMostPlaces]);
    list = std::move(some);
  }
  return out;
}

/// How a distance off the face goes with what is fitted; the last value is always the offset along the
/// normal.
Eigen::VectorXd rowAt(const CadFace& face, const Vec3& p, bool placed) {
  const Vec3 normal = face.normalAt(p);
  Eigen::VectorXd row;
  if (face.kind == SurfaceKind::kPlane) {
    const Vec3 u = normal.unitOrthogonal(), v = normal.cross(u), from = p - face.origin;
    row.resize(3);
    row << from.dot(u), from.dot(v), 1.0;
  } else if (face.kind == SurfaceKind::kCylinder && placed) {
    const Vec3 u = face.axis.unitOrthogonal(), v = face.axis.cross(u);
    row.resize(3);
    row << normal.dot(u), normal.dot(v), 1.0;
  } else if (face.kind == SurfaceKind::kSphere && placed) {
    row.resize(4);
    row << normal.x(), normal.y(), normal.z(), 1.0;
  } else {
    row = Eigen::VectorXd::Ones(1);
  }
  return row;
}

void takeFit(const CadFace& face, const Eigen::VectorXd& x, FaceFit& out) {
  const double grown = face.hollow ? -x[x.size() - 1] : x[x.size() - 1];
  if (face.kind == SurfaceKind::kCylinder || face.kind == SurfaceKind::kSphere)
    out.radius_mm = face.radius + grown;
  if (!out.placed) return;
  const Vec3 u = face.axis.unitOrthogonal(), v = face.axis.cross(u);
  out.shift = face.kind == SurfaceKind::kSphere ? Vec3(x[0], x[1], x[2]) : Vec3(x[0] * u + x[1] * v);
}

/// Least squares by Gauss and Newton: the face moves to where it fits, and is asked again from there.
void fit(const CadFace& nominal, const std::vector<Vec3>& points, FaceFit& out) {
  constexpr int kSteps = 3;
  CadFace face = nominal;
  out.placed = nominal.kind == SurfaceKind::kSphere ||
               (nominal.kind == SurfaceKind::kCylinder && nominal.turn_rad >= kLeastTurn);
  Eigen::VectorXd sum;
  for (int step = 0; step < kSteps; ++step) {
    const Eigen::Index width = rowAt(face, points[0], out.placed).size();
    if (static_cast<Eigen::Index>(points.size()) < width) return;
    Eigen::MatrixXd a(static_cast<Eigen::Index>(points.size()), width);
    Eigen::VectorXd b(a.rows());
    for (Eigen::Index k = 0; k < a.rows(); ++k) {
      const Vec3& p = points[static_cast<std::size_t>(k)];
      a.row(k) = rowAt(face, p, out.placed);
      b[k] = face.distance(p);
    }
    const Eigen::VectorXd x = a.colPivHouseholderQr().solve(b);
    const Eigen::VectorXd left = b - a * x;
    out.form_mm = left.maxCoeff() - left.minCoeff();
    sum = step == 0 ? x : Eigen::VectorXd(sum + x);
    if (face.kind == SurfaceKind::kPlane || (!out.placed && face.kind != SurfaceKind::kCylinder)) break;
    FaceFit moved = out;
    takeFit(nominal, sum, moved);
    face.radius = moved.radius_mm;
    face.origin = nominal.origin + moved.shift;
  }
  takeFit(nominal, sum, out);
}

FaceFit fitOf(const SampleMesh& goal, const CadFace& face, const std::vector<std::size_t>& places,
              const ExactPart& part, double reach_mm) {
  FaceFit out;
  std::vector<Vec3> points;
  double sum = 0.0;
  out.least_mm = std::numeric_limits<double>::infinity();
  out.most_mm = -out.least_mm;
  for (const std::size_t triangle : places) {
    const SettledPoint at = settle(part, placeOn(goal, triangle, face), reach_mm);
    const double off = face.distance(at.p);
    if (!at.found || std::abs(off) > reach_mm) {
      ++out.missed;
      continue;
    }
    points.push_back(at.p);
    sum += off;
    out.least_mm = std::min(out.least_mm, off);
    out.most_mm = std::max(out.most_mm, off);
  }
  out.points = points.size();
  if (points.empty()) {
    out.least_mm = out.most_mm = 0.0;
    return out;
  }
  out.mean_mm = sum / static_cast<double>(points.size());
  fit(face, points, out);
  return out;
}

}  // namespace

std::vector<FaceFit> fitFaces(const SampleMesh& goal, const CadFaces& faces, const ExactPart& part,
                              double reach_mm) {
  const std::vector<std::vector<std::size_t>> places = placesOf(goal, faces);
  std::vector<FaceFit> all(places.size());
  parallelFor(std::size_t{0}, places.size(), [&](std::size_t k) {
    if (!places[k].empty()) all[k] = fitOf(goal, faces.faces[k], places[k], part, reach_mm);
    all[k].face = static_cast<std::uint32_t>(k);
  });
  std::erase_if(all, [&](const FaceFit& f) { return places[f.face].empty(); });
  return all;
}

}  // namespace proveout
