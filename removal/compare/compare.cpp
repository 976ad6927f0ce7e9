#include "removal/compare/compare.h"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/info.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <new>
#include <optional>

#include "core/base/assert.h"
#include "core/base/memory.h"
#include "core/base/parallel_for.h"
#include "core/geometry/place_text.h"
#include "removal/compare/deepest_point.h"
#include "removal/compare/deviation_patches.h"
#include "removal/compare/deviation_statistics.h"
#include "removal/compare/difference_volume.h"
#include "removal/compare/features/face_fits.h"
#include "removal/compare/features/face_network.h"
#include "removal/compare/features/found_features.h"
#include "removal/compare/features/measured_features.h"
#include "removal/compare/features/recognition.h"
#include "removal/compare/local_tolerance.h"
#include "removal/compare/measured_sides.h"
#include "removal/compare/nominal.h"
#include "removal/compare/point_deviation.h"
#include "removal/compare/sample_mesh.h"
#include "removal/compare/spots.h"

namespace proveout {
namespace compare_detail {

/// Samples of one surface, at most: a second or two of work and a few hundred megabytes.
constexpr std::size_t kMaxSampleTriangles = 2'000'000;
/// The same where the meshes cannot be of one part: seen from far off all of a surface is about equally near,
/// so that a sample costs what the whole mesh does, and more of them tell nothing new.
constexpr std::size_t kMaxOddSampleTriangles = 20'000;

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

/// Whether one could be the other, well or badly made: sizes and places are alike.
bool alike(const Box3& a, const Box3& b) {
  constexpr double kLargestRatio = 8.0;
  const double small = std::min(a.size().norm(), b.size().norm()),
               large = std::max(a.size().norm(), b.size().norm());
  const Vec3 gap = (a.min - b.max).cwiseMax(b.min - a.max).cwiseMax(Vec3::Zero());
  return large <= kLargestRatio * small && gap.norm() <= large;
}

Status checkClosed(const TriMesh& mesh, const std::string& name) {
  if (auto bad = findBadElements(mesh, name)) return *bad;
  const OpenEdges open = findOpenEdges(mesh);
  if (open.closed()) return Done{};
  return inputError(fmt::format("{} is not closed at {} mm", name, placeText(open.first)));
}

bool ignored(const std::vector<IgnoredRegion>& regions, const Vec3& p) {
  return std::any_of(regions.begin(), regions.end(), [&](const IgnoredRegion& r) { return r.contains(p); });
}

/// Area of the samples' triangles in each region, by their middles, mm2.
void tellIgnored(const SurfaceMesh& samples, const std::vector<IgnoredRegion>& regions, Comparison& out) {
  out.ignored_mm2.assign(regions.size(), 0.0);
  if (regions.empty()) return;
  for (std::size_t t = 0; t < samples.triangles.size(); ++t) {
    const Vec3 middle = samples.middle(t);
    const auto in = [&](const IgnoredRegion& r) { return r.contains(middle); };
    const auto found = std::find_if(regions.begin(), regions.end(), in);
    if (found != regions.end())
      out.ignored_mm2[static_cast<std::size_t>(found - regions.begin())] +=
          0.5 * samples.areaVector(t).norm();
  }
}

/// Grid spacing at which the error, which goes with its square, is less than the distance to the tolerance.
/// 0: none is, as where the nominal's own facets leave it open.
double decidingResolution(const CompareOptions& o, const DeviationPatch& patch, double tolerance) {
  if (patch.chord_mm >= std::abs(patch.depth_mm - tolerance)) return 0.0;
  constexpr double kMargin = 0.8;
  constexpr double kPractical = 1.0 / 16.0;
  const double factor = std::sqrt(kMargin * std::abs(patch.depth_mm - tolerance) / patch.bound_mm);
  if (!(factor >= kPractical)) return 0.0;
  const double wanted = o.resolution_mm * std::min(factor, kMargin);
  const double digit = std::pow(10.0, std::floor(std::log10(wanted)) - 1.0);
  return std::floor(wanted / digit) * digit;
}

/// What is asked about patches once they are found.
class Asked {
 public:
  Asked(const TriMesh& machined, const NominalModel& goal, const CompareOptions& options, double noise_mm)
      : nominal(goal), noise(noise_mm), machined_(machined), options_(options) {}
  const NominalModel& nominal;
  const double noise;

  TreedSurface machined() { return {&surface(), &distance().tree()}; }
  TreedSurface nominalSurface() const { return {&nominal.surface, &nominal.distance.tree()}; }
  /// What features are measured on: where there is no exact part, and the mesh is taken as exact, faces are
  /// looked for in it, too, if `find` says so.
  const ExactPart& partOfFeatures(bool find) {
    if (options_.part != nullptr || options_.uncertainty_mm > 0.0 || !find) return part();
    if (!faced_part_) faced_part_.emplace(distance(), facesInFacets(machined_).faces);
    return *faced_part_;
  }
  /// The exact part, or the mesh where there is none.
  const ExactPart& part() {
    if (options_.part != nullptr) return *options_.part;
    if (!mesh_part_) mesh_part_.emplace(distance(), options_.uncertainty_mm);
    return *mesh_part_;
  }

 private:
  // Made when the first patch asks: most parts are right.
  const SurfaceMesh& surface() {
    if (!surface_) surface_ = toSurface(machined_);
    return *surface_;
  }
  const SignedDistance& distance() {
    if (!distance_) distance_.emplace(surface(), 0.5 * options_.resolution_mm);
    return *distance_;
  }
  const TriMesh& machined_;
  const CompareOptions& options_;
  std::optional<SurfaceMesh> surface_;
  std::optional<SignedDistance> distance_;
  std::optional<MeshPart> mesh_part_;
  std::optional<FacedPart> faced_part_;
};

/// Depth times area is short at edges, where the surfaces do not run side by side: what lies between them is
/// counted. Not for patches as shallow as their samples' noise, nor for all of a great many.
void fillVolumes(Asked& asked, double level, std::vector<FoundPatch>& found) {
  constexpr double kDeep = 4.0;
  constexpr std::size_t kMostCounted = 24;
  std::vector<FoundPatch*> counted;
  for (FoundPatch& f : found) {
    const auto [machined, nominal] = f.volumes;
    f.patch.volume_mm3 = std::max({machined, nominal, 0.0});
    if (f.patch.depth_mm > kDeep * level) counted.push_back(&f);
  }
  std::stable_sort(counted.begin(), counted.end(), [](const FoundPatch* a, const FoundPatch* b) {
    return a->patch.area_mm2 * a->patch.depth_mm > b->patch.area_mm2 * b->patch.depth_mm;
  });
  counted.resize(std::min(counted.size(), kMostCounted));
  for (FoundPatch* f : counted) {
    const double volume = differenceVolume(asked.machined(), asked.nominalSurface(), f->patch.kind,
                                           f->patch.bounds, f->places, std::max(0.5 * level, asked.noise));
    if (volume > 0.0) f->patch.volume_mm3 = volume;
  }
}

/// Where the nominal's facets stand for a curved face, the face may be off what they are read as.
void addChord(const NominalModel& nominal, const CadFaces* faces, double reach, DeviationPatch& patch) {
  const SurfaceDistance d = nominal.distance.at(patch.where);
  const Vec3 foot = patch.where - d.distance * d.gradient.cast<double>();
  patch.chord_mm = nominal.shape.unsureAt(d.triangle, foot, reach);
  patch.bound_mm += patch.chord_mm;
  if (faces != nullptr) patch.face = faces->of_triangle[d.triangle];
}

/// Bounds of a patch that was found, with what the nominal leaves open. Where its deepest place is not
/// beyond the level by more than its bound, but another one is, that is told.
bool decide(FoundPatch& found, const NominalModel& nominal, double level, const CompareOptions& o) {
  DeviationPatch& p = found.patch;
  addChord(nominal, o.nominal_faces.get(), o.resolution_mm, p);
  if (p.depth_mm - p.bound_mm > level) return true;
  if (!(found.surest.depth_mm - found.surest.bound_mm > level)) return false;
  found.surest.tell(p);
  return true;
}

/// Sorts the regions of one kind into certain and undecided ones.
void judgeKind(const BothSides& sides, DeviationKind kind, double tolerance, Asked& asked,
               const CompareOptions& o, Comparison& out) {
  const double level = tolerance + asked.noise;
  const auto undecided = [&](const FoundPatch& found) {
    out.undecided.push_back(found.patch);
    out.undecided.back().allowed_mm = tolerance;
    out.undecided.back().deciding_resolution_mm = decidingResolution(o, found.patch, tolerance);
  };
  std::vector<FoundPatch> measured =
      joinSpots(findPatches(sides, kind, level, Beyond::kMeasured, o.part.get()), o);
  if (!measured.empty()) {
    const ExactPart& part = asked.part();
    parallelFor(std::size_t{0}, measured.size(),
                [&](std::size_t i) { findDeepest(part, asked.nominal, o.resolution_mm, measured[i]); });
    fillVolumes(asked, level, measured);
  }
  for (FoundPatch& found : measured) {
    if (decide(found, asked.nominal, level, o)) {
      out.patches.push_back(found.patch);
      out.patches.back().allowed_mm = tolerance;
    } else {
      undecided(found);
    }
  }
  for (const FoundPatch& found : findPatches(sides, kind, level, Beyond::kPossible, o.part.get())) {
    if (found.patch.depth_mm <= level) undecided(found);
  }
}

/// Group by group, where some of the surface has tolerances of its own.
void judgeSides(const BothSides& sides, Asked& asked, const CompareOptions& o, Comparison& out) {
  if (o.local.empty()) {
    judgeKind(sides, DeviationKind::kGouge, o.gouge_mm, asked, o, out);
    judgeKind(sides, DeviationKind::kExcess, o.excess_mm, asked, o, out);
    return;
  }
  const ToleranceGroups groups = groupSamples(sides, o);
  for (std::size_t k = 0; k <= o.local.size(); ++k) {
    const BothSides own = onlyGroup(sides, groups, static_cast<std::uint16_t>(k));
    judgeKind(own, DeviationKind::kGouge, k == 0 ? o.gouge_mm : o.local[k - 1].gouge_mm, asked, o, out);
    judgeKind(own, DeviationKind::kExcess, k == 0 ? o.excess_mm : o.local[k - 1].excess_mm, asked, o, out);
  }
}

/// Samples are measured as well as the tightest tolerance asks.
CompareOptions withLeastTolerances(CompareOptions o) {
  for (const LocalTolerance& local : o.local) {
    o.gouge_mm = std::min(o.gouge_mm, local.gouge_mm);
    o.excess_mm = std::min(o.excess_mm, local.excess_mm);
  }
  return o;
}

void sortByDepth(std::vector<DeviationPatch>& patches) {
  std::stable_sort(patches.begin(), patches.end(),
                   [](const DeviationPatch& a, const DeviationPatch& b) { return a.depth_mm > b.depth_mm; });
}

/// Samples of a deep deviation are as rough as the mesh: where it is beyond tolerance the figure is that of
/// the patches, whose deepest points were measured on the part itself.
void tellLargest(DeviationKind kind, double noise, Comparison& out) {
  const bool gouge = kind == DeviationKind::kGouge;
  double& most = gouge ? out.max_gouge_mm : out.max_excess_mm;
  double told = 0.0;
  for (const auto* patches : {&out.patches, &out.undecided}) {
    for (const DeviationPatch& p : *patches) {
      if (p.kind == kind) told = std::max(told, p.depth_mm);
    }
  }
  const double level = noise + (gouge ? out.gouge_tolerance_mm : out.excess_tolerance_mm);
  most = most > level && told > 0.0 ? told : std::max(most, told);
}

/// Deviations of the mesh's own vertices, which come first among the samples.
std::vector<float> deviationOfVertices(const BothSides& sides, std::size_t count) {
  PROVEOUT_ASSERT(count <= sides.machined.deviation.size());
  return {sides.machined.deviation.begin(),
          sides.machined.deviation.begin() + static_cast<std::ptrdiff_t>(count)};
}

/// Of the samples that a tolerance asks for.
double largestBound(const BothSides& sides, double tolerance) {
  double largest = 0.0;
  for (const SampledSide* side : {&sides.machined, &sides.nominal}) {
    for (std::size_t i = 0; i < side->deviation.size(); ++i) {
      if (std::abs(side->deviation[i]) + side->bound[i] > tolerance)
        largest = std::max(largest, static_cast<double>(side->bound[i]));
    }
  }
  return largest;
}

/// The faces of the model, or those found in its facets.
KnownFaces knownFaces(const TriMesh& nominal, const CompareOptions& o) {
  if (o.nominal_faces != nullptr || !o.find_features) return {o.nominal_faces, FaceAccuracy{}, false};
  return facesInFacets(nominal);
}

/// The features of the model, and what the part has in their place.
void tellFeatures(const TriMesh& nominal, const SampleMesh& goal, const KnownFaces& known,
                  const ExactPart& part, Comparison& out) {
  constexpr double kSmooth = degToRad(3.0);
  out.face_fits = fitFaces(goal, *known.faces, part);
  out.features = recognizeFeatures(FaceNetwork(nominal, *known.faces, kSmooth), known.accuracy);
  measureFeatures(*known.faces, out.face_fits, part, out.features);
}

Result<Comparison> compare(const TriMesh& machined, const TriMesh& nominal, const CompareOptions& asked_for,
                           Progress& progress) {
  const Error interrupted{ErrorKind::kInterrupted, "comparison interrupted"};
  const std::size_t samples =
      alike(meshBounds(machined), meshBounds(nominal)) ? kMaxSampleTriangles : kMaxOddSampleTriangles;
  // First what takes most memory while it is made. Deviations are measured to faces that a CAD model tells;
  // those found in facets give names and features alone.
  const auto shared_model = std::make_shared<const NominalModel>(nominal, 0.5 * asked_for.resolution_mm,
                                                                 asked_for.nominal_faces.get());
  const KnownFaces known = knownFaces(nominal, asked_for);
  CompareOptions o = asked_for;
  o.nominal_faces = known.faces;
  // Meshes of a grid have edges up to about 1.5 spacings long: those are sampled by their corners.
  SampleMesh part = makeSampleMesh(machined, 1.5 * o.resolution_mm, samples);
  const SampleMesh goal = makeSampleMesh(nominal, o.resolution_mm, samples);
  const NominalModel& model = *shared_model;
  BothSides sides = measureSides(part, goal, model, withLeastTolerances(o), progress);
  if (progress.cancelled()) return interrupted;
  sides.motion = &machined.motion;
  sides.model = &model;
  sides.reach_mm = o.resolution_mm;
  Comparison out;
  out.gouge_tolerance_mm = o.gouge_mm;
  out.excess_tolerance_mm = o.excess_mm;
  out.nominal_faces = known.faces;
  out.faces_found = known.found;
  fillStatistics(sides, out);
  Box3 box = meshBounds(machined);
  box.extend(meshBounds(nominal));
  // Coordinates come as float: what is within four units in the last place is no deviation.
  const double noise = 4.0 * 1.2e-7 * std::max(box.min.cwiseAbs().maxCoeff(), box.max.cwiseAbs().maxCoeff());
  Asked asked(machined, model, o, noise);
  const CompareOptions least = withLeastTolerances(o);
  out.largest_bound_mm = largestBound(sides, std::min(least.gouge_mm, least.excess_mm));
  judgeSides(sides, asked, o, out);
  if (known.faces != nullptr && o.measure_features)
    tellFeatures(nominal, goal, known, asked.partOfFeatures(o.find_features), out);
  sortByDepth(out.patches);
  sortByDepth(out.undecided);
  for (const DeviationKind kind : {DeviationKind::kGouge, DeviationKind::kExcess})
    tellLargest(kind, noise, out);
  out.vertex_deviation = deviationOfVertices(sides, machined.positions.size());
  out.field = makeDeviationField(shared_model, o);
  tellIgnored(part.surface, o.ignored, out);
  const bool doubt = model.shape.largestDoubt() > model.shape.largestRead();
  out.nominal_chord_in_doubt = doubt;
  out.nominal_chord_mm = doubt ? model.shape.largestDoubt() : model.shape.largestRead();
  out.nominal_chord_at = doubt ? model.shape.largestDoubtAt() : model.shape.largestReadAt();
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
  PROVEOUT_ASSERT(options.nominal_faces == nullptr ||
                  options.nominal_faces->of_triangle.size() == nominal.triangles.size());
  try {
    const int threads = options.threads > 0 ? options.threads : std::max(1, tbb::info::default_concurrency());
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    return compare_detail::compare(machined, nominal, options, progress);
  } catch (const std::bad_alloc&) {
    return outOfMemory("not enough memory to compare", "use a coarser grid");
  } catch (const std::exception& e) {
    return Error{ErrorKind::kInternal, std::string("comparison failed: ") + e.what()};
  }
}

}  // namespace proveout
