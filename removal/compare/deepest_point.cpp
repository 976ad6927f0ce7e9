#include "removal/compare/deepest_point.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/assert.h"

namespace proveout {

namespace {

/// The search ends with steps of this length, mm: a slope of 1 in 10 then is good to 0.02 micrometres.
constexpr double kLastStep = 2e-4;
constexpr int kDirections = 8, kMostMoves = 400;

/// A point of the part's surface with its deviation.
struct Place {
  SettledPoint at;
  double depth = 0.0;
  Vec3 normal = Vec3::UnitZ();  ///< outward, of the nominal
};

class Search {
 public:
  Search(const ExactPart& part, const NominalModel& nominal, DeviationKind kind, double reach)
      : part_(part), nominal_(nominal), sign_(kind == DeviationKind::kExcess ? 1.0 : -1.0), reach_(reach) {}

  Place measure(const Vec3& p) const {
    Place out;
    out.at = settle(part_, p, reach_);
    if (!out.at.found) return out;
    const SurfaceDistance d = nominal_.distance.at(out.at.p);
    out.depth = sign_ * nominal_.deviation(d, out.at.p);
    out.normal = d.gradient.cast<double>();
    return out;
  }

  /// From a place to the deepest around it.
  Place climb(Place best, double step) const {
    int moves = 0;
    while (step > kLastStep && moves < kMostMoves) {
      const Vec3 u = best.normal.unitOrthogonal(), v = best.normal.cross(u);
      Place next = best;
      for (int i = 0; i < kDirections; ++i) {
        const double angle = 2.0 * kPi * (i + 0.3) / kDirections;
        const Place tried = measure(best.at.p + step * (std::cos(angle) * u + std::sin(angle) * v));
        if (tried.at.found && tried.depth > next.depth) next = tried;
      }
      if (next.depth > best.depth) {
        best = next;
        ++moves;
      } else {
        step *= 0.5;
      }
    }
    return best;
  }

 private:
  const ExactPart& part_;
  const NominalModel& nominal_;
  double sign_, reach_;
};

/// How far a point of the nominal is from the part's surface, and how sure that is.
void measureFromNominal(const ExactPart& part, double chord, FoundPatch& found) {
  DeviationPatch& p = found.patch;
  // Chords of the nominal were taken off already: only what is left of them can be measured anew.
  if (chord > 0.0 && p.depth_mm < 100.0 * chord) return;
  const double reach = 1.05 * p.depth_mm + 1e-3;
  if (p.kind == DeviationKind::kExcess) {
    const ExactPart::Sample s = part.at(p.where, reach);
    if (s.value >= 0.0 || s.value <= -reach) return;
    p.bound_mm = part.accuracy();
    p.depth_mm = -s.value;
    if (s.maker.motion != kNoMotion) p.maker = s.maker;
    return;
  }
  const SettledPoint at = settle(part, found.opposite, std::min(reach, 0.5));
  if (!at.found) return;
  p.depth_mm = (at.p - p.where).norm();
  p.bound_mm = at.residual + part.accuracy();
  if (at.maker.motion != kNoMotion) p.maker = at.maker;
}

}  // namespace

ExactPart::Sample MeshPart::at(const Vec3& p, double reach) const {
  const SurfaceDistance d = surface_.at(p);
  return {std::clamp(d.distance, -reach, reach), d.gradient.cast<double>().normalized(), {}};
}

void findDeepest(const ExactPart& part, const NominalModel& nominal, double step_mm, FoundPatch& found) {
  PROVEOUT_ASSERT(step_mm > 0.0);
  DeviationPatch& p = found.patch;
  if (found.deepest_on_nominal) {
    measureFromNominal(part, nominal.shape.largest(), found);
    if (p.depth_mm >= found.machined.depth_mm) return;
  }
  const Search search(part, nominal, p.kind, 2.0 * step_mm);
  const Place start = search.measure(found.deepest_on_nominal ? found.machined.where : p.where);
  if (!start.at.found || start.depth <= 0.0) return;
  const Place best = search.climb(start, step_mm);
  if (found.deepest_on_nominal && best.depth <= p.depth_mm) return;
  p.where = best.at.p;
  p.depth_mm = best.depth;
  p.normal = best.normal;
  p.bound_mm = best.at.residual + kLastStep;
  if (best.at.maker.motion != kNoMotion) p.maker = best.at.maker;
}

}  // namespace proveout
