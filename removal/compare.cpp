#include "removal/compare.h"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/info.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <new>

#include "removal/deviation_patches.h"
#include "removal/deviation_statistics.h"
#include "removal/nominal.h"
#include "removal/sample_mesh.h"
#include "removal/signed_distance.h"

namespace proveout {
namespace compare_detail {

/// Samples of one surface, at most: a second or two of work and a few hundred megabytes.
constexpr std::size_t kMaxSampleTriangles = 2'000'000;

Status checkOptions(const CompareOptions& o) {
  const auto bad = [](double v) { return !std::isfinite(v) || v < 0.0; };
  if (bad(o.gouge_mm))
    return inputError(fmt::format("gouge tolerance must be 0 or more, not {} mm", o.gouge_mm));
  if (bad(o.excess_mm))
    return inputError(fmt::format("excess tolerance must be 0 or more, not {} mm", o.excess_mm));
  if (bad(o.uncertainty_mm))
    return inputError(fmt::format("uncertainty must be 0 or more, not {} mm", o.uncertainty_mm));
  if (bad(o.resolution_mm) || o.resolution_mm == 0.0) {
    return inputError(fmt::format("comparison spacing must be above 0, not {} mm", o.resolution_mm));
  }
  return Done{};
}

Status checkClosed(const TriMesh& mesh, const std::string& name) {
  if (auto bad = findBadElements(mesh, name)) return *bad;
  const OpenEdges open = findOpenEdges(mesh);
  if (open.closed()) return Done{};
  return inputError(fmt::format("{} is not closed at X{:.3f} Y{:.3f} Z{:.3f} mm", name, open.first.x(),
                                open.first.y(), open.first.z()));
}

/// Turns distances into the convention of compare.h: on the nominal side, a point inside the machined
/// solid means that material is left.
SampledSide toSide(const SampleMesh& mesh, const std::vector<SurfaceDistance>& distances, bool nominal_side) {
  SampledSide side;
  side.mesh = &mesh;
  const float sign = nominal_side ? -1.0f : 1.0f;
  for (const SurfaceDistance& d : distances) {
    side.deviation.push_back(sign * static_cast<float>(d.distance));
    side.gradient.push_back(d.gradient);
    side.opposite.push_back(d.triangle);
  }
  return side;
}

bool ignored(const std::vector<IgnoredRegion>& regions, const Vec3& p) {
  return std::any_of(regions.begin(), regions.end(), [&](const IgnoredRegion& r) { return r.contains(p); });
}

void leaveOut(const std::vector<IgnoredRegion>& regions, SampledSide& side) {
  if (regions.empty()) return;
  for (std::size_t i = 0; i < side.deviation.size(); ++i) {
    if (ignored(regions, side.mesh->surface.points[i])) side.deviation[i] = 0.0f;
  }
}

/// Area of the triangles in each region, by their middles, mm2; vertices there get no colour.
void tellIgnored(const TriMesh& machined, const std::vector<IgnoredRegion>& regions, Comparison& out) {
  out.ignored_mm2.assign(regions.size(), 0.0);
  if (regions.empty()) return;
  for (const auto& t : machined.triangles) {
    const Vec3 a = machined.positions[t[0]].cast<double>(), b = machined.positions[t[1]].cast<double>(),
               c = machined.positions[t[2]].cast<double>();
    const auto in = [&](const IgnoredRegion& r) { return r.contains((a + b + c) / 3.0); };
    const auto found = std::find_if(regions.begin(), regions.end(), in);
    if (found != regions.end())
      out.ignored_mm2[static_cast<std::size_t>(found - regions.begin())] += 0.5 * (b - a).cross(c - a).norm();
  }
  for (std::size_t i = 0; i < out.vertex_deviation.size(); ++i) {
    if (ignored(regions, machined.positions[i].cast<double>()))
      out.vertex_deviation[i] = std::numeric_limits<float>::quiet_NaN();
  }
}

/// Grid spacing at which the error, which goes with its square, is less than the distance to the tolerance.
double decidingResolution(const CompareOptions& o, double depth, double tolerance) {
  constexpr double kMargin = 0.8;
  constexpr double kPractical = 1.0 / 16.0;
  const double factor = std::sqrt(kMargin * std::abs(depth - tolerance) / o.uncertainty_mm);
  if (factor < kPractical) return 0.0;
  const double wanted = o.resolution_mm * std::min(factor, kMargin);
  const double digit = std::pow(10.0, std::floor(std::log10(wanted)) - 1.0);
  return std::floor(wanted / digit) * digit;
}

/// Deepest sample of a kind anywhere, as a patch without extent.
DeviationPatch deepestAnywhere(const BothSides& sides, DeviationKind kind) {
  DeviationPatch patch;
  patch.kind = kind;
  double best = -1.0;
  for (const SampledSide* side : {&sides.machined, &sides.nominal}) {
    for (std::size_t i = 0; i < side->deviation.size(); ++i) {
      const double depth =
          std::max(0.0f, kind == DeviationKind::kExcess ? side->deviation[i] : -side->deviation[i]);
      if (depth <= best) continue;
      best = depth;
      patch.where = side->mesh->surface.points[i];
      patch.from_nominal_only = side == &sides.nominal;
    }
  }
  patch.depth_mm = best;
  patch.bounds.extend(patch.where);
  return patch;
}

/// Sorts the regions of one kind into certain and undecided ones.
void judgeKind(const BothSides& sides, DeviationKind kind, double tolerance, double noise,
               const CompareOptions& o, Comparison& out) {
  const auto undecided = [&](DeviationPatch patch) {
    patch.deciding_resolution_mm = decidingResolution(o, patch.depth_mm, tolerance);
    out.undecided.push_back(patch);
  };
  const double level = std::max(tolerance, noise);
  bool found = false;
  for (const DeviationPatch& patch : findPatches(sides, kind, level)) {
    found = true;
    if (patch.depth_mm > level + o.uncertainty_mm) {
      out.patches.push_back(patch);
    } else {
      undecided(patch);
    }
  }
  if (o.uncertainty_mm <= 0.0) return;
  if (o.uncertainty_mm >= tolerance) {  // no deviation at all, not even none, can be told from the tolerance
    if (!found) undecided(deepestAnywhere(sides, kind));
    return;
  }
  for (const DeviationPatch& patch :
       findPatches(sides, kind, std::max(tolerance - o.uncertainty_mm, noise))) {
    if (patch.depth_mm <= level) undecided(patch);
  }
}

void sortByDepth(std::vector<DeviationPatch>& patches) {
  std::stable_sort(patches.begin(), patches.end(),
                   [](const DeviationPatch& a, const DeviationPatch& b) { return a.depth_mm > b.depth_mm; });
}

Result<Comparison> compare(const TriMesh& machined, const TriMesh& nominal, const CompareOptions& o,
                           Progress& progress) {
  const Error interrupted{ErrorKind::kInterrupted, "comparison interrupted"};
  // Meshes of a grid have edges up to about 1.5 spacings long: those are sampled by their corners.
  const SampleMesh part = makeSampleMesh(machined, 1.5 * o.resolution_mm, kMaxSampleTriangles);
  const SampleMesh goal = makeSampleMesh(nominal, o.resolution_mm, kMaxSampleTriangles);
  BothSides sides;
  sides.motion = &machined.motion;
  {
    SurfaceMesh coarse;  // distances need the nominal as it is; its samples would make a larger tree
    for (const auto& p : nominal.positions) coarse.points.push_back(p.cast<double>());
    coarse.triangles = nominal.triangles;
    const SignedDistance to_nominal(coarse);
    sides.machined = toSide(part, to_nominal.at(part.surface.points, progress, 0.1, 0.5), false);
    leaveOut(o.ignored, sides.machined);
  }
  if (progress.cancelled()) return interrupted;
  {
    const SignedDistance to_machined(part.surface);
    sides.nominal = toSide(goal, to_machined.at(goal.surface.points, progress, 0.6, 0.95), true);
    leaveOut(o.ignored, sides.nominal);
  }
  if (progress.cancelled()) return interrupted;
  Comparison out;
  out.gouge_tolerance_mm = o.gouge_mm;
  out.excess_tolerance_mm = o.excess_mm;
  out.uncertainty_mm = o.uncertainty_mm;
  Box3 box = meshBounds(machined);
  box.extend(meshBounds(nominal));
  // Coordinates come as float: what is within four units in the last place is no deviation.
  const double noise = 4.0 * 1.2e-7 * std::max(box.min.cwiseAbs().maxCoeff(), box.max.cwiseAbs().maxCoeff());
  judgeKind(sides, DeviationKind::kGouge, o.gouge_mm, noise, o, out);
  judgeKind(sides, DeviationKind::kExcess, o.excess_mm, noise, o, out);
  sortByDepth(out.patches);
  sortByDepth(out.undecided);
  fillStatistics(sides, out);
  out.vertex_deviation.assign(
      sides.machined.deviation.begin(),
      sides.machined.deviation.begin() + static_cast<std::ptrdiff_t>(machined.positions.size()));
  tellIgnored(machined, o.ignored, out);
  out.nominal_tessellation_mm = estimateTessellation(nominal);
  out.machined_spacing_mm = part.spacing_mm;
  out.nominal_spacing_mm = goal.spacing_mm;
  out.machined_samples = part.surface.points.size();
  out.nominal_samples = goal.surface.points.size();
  progress.report("comparing", 1.0);
  return out;
}

}  // namespace compare_detail

Result<Comparison> compareToNominal(const TriMesh& machined, const TriMesh& nominal,
                                    const CompareOptions& options, Progress& progress) {
  for (const Status& status :
       {compare_detail::checkOptions(options), compare_detail::checkClosed(machined, "the machined mesh"),
        compare_detail::checkClosed(nominal, "the nominal mesh")}) {
    if (!status) return status.error();
  }
  try {
    const int threads = options.threads > 0 ? options.threads : std::max(1, tbb::info::default_concurrency());
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    return compare_detail::compare(machined, nominal, options, progress);
  } catch (const std::bad_alloc&) {
    return Error{ErrorKind::kResourceLimit, "not enough memory to compare; use a coarser grid"};
  } catch (const std::exception& e) {
    return Error{ErrorKind::kInternal, std::string("comparison failed: ") + e.what()};
  }
}

}  // namespace proveout
