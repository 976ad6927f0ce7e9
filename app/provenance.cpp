#include "app/provenance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace proveout {
namespace {

/// Squared distance of a point to a triangle (Ericson, Real-Time Collision Detection, 5.1.5).
double squaredDistance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp),
               d6 = ac.dot(cp);
  if (d1 <= 0 && d2 <= 0) return ap.squaredNorm();
  if (d3 >= 0 && d4 <= d3) return bp.squaredNorm();
  if (d6 >= 0 && d5 <= d6) return cp.squaredNorm();
  const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return (ap - d1 / (d1 - d3) * ab).squaredNorm();
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return (ap - d2 / (d2 - d6) * ac).squaredNorm();
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    return (bp - (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b)).squaredNorm();
  const double scale = 1.0 / (va + vb + vc);
  return (ap - vb * scale * ab - vc * scale * ac).squaredNorm();
}

struct Nearest {
  double distance = 0.0;
  MotionId motion = kNoMotion;
};

std::optional<Nearest> nearestTriangle(const TriMesh& mesh, const Vec3& p, double within) {
  double best = within * within;
  std::optional<Nearest> nearest;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto corner = [&](int i) { return mesh.positions[mesh.triangles[t][i]].cast<double>().eval(); };
    const double squared = squaredDistance(p, corner(0), corner(1), corner(2));
    if (squared > best || (nearest && squared == best)) continue;
    best = squared;
    nearest = Nearest{std::sqrt(squared), t < mesh.motion.size() ? mesh.motion[t] : kNoMotion};
  }
  return nearest;
}

}  // namespace

std::optional<MadeBy> madeEarlier(const RunResult& run, const Vec3& where, double within_mm) {
  Vec3 place = where;
  for (std::size_t k = run.setups.size() - 1; k-- > 0;) {
    place = run.setups[k + 1].from_previous.inverse()(place);
    const auto nearest = nearestTriangle(run.setups[k].surface.mesh, place, within_mm);
    if (!nearest) return std::nullopt;
    if (nearest->motion != kNoMotion) return MadeBy{k, nearest->motion};
  }
  return std::nullopt;
}

Vec3 inLastFrame(const RunResult& run, std::size_t from, const Vec3& where) {
  Vec3 place = where;
  for (std::size_t k = from + 1; k < run.setups.size(); ++k) place = run.setups[k].from_previous(place);
  return place;
}

}  // namespace proveout
