#include "app/session/findings/provenance.h"

#include <cmath>

#include "core/geometry/triangle.h"

namespace proveout {
namespace {

struct Nearest {
  double distance = 0.0;
  MotionId motion = kNoMotion;
};

std::optional<Nearest> nearestTriangle(const TriMesh& mesh, const Vec3& p, double within) {
  double best = within * within;
  std::optional<Nearest> nearest;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto corner = [&](int i) { return mesh.positions[mesh.triangles[t][i]].cast<double>().eval(); };
    const double squared = squaredDistance(p, {corner(0), corner(1), corner(2)});
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
