#include "removal/compare/fit/scan.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"
#include "core/geometry/place_text.h"
#include "removal/compare/deviation_patches.h"
#include "removal/compare/deviation_statistics.h"
#include "removal/compare/fit/point_cells.h"
#include "removal/compare/measured_sides.h"
#include "removal/compare/nominal.h"
#include "removal/compare/sample_mesh.h"
#include "removal/compare/spots.h"

namespace proveout {
namespace scan_detail {

constexpr std::size_t kMostSampleTriangles = 2'000'000;
constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
/// A point shows places whose normals are within 75 degrees of that at its foot: not the other side of a thin
/// wall.
constexpr double kAlike = 0.25;

bool ignored(const std::vector<IgnoredRegion>& regions, const Vec3& p) {
  return std::any_of(regions.begin(), regions.end(), [&](const IgnoredRegion& r) { return r.contains(p); });
}

/// The points of a scan that are of the part, measured.
struct Measured {
  std::vector<Vec3> feet;        ///< nearest places of the nominal
  std::vector<Vec3> normals;     ///< outward there, unit
  std::vector<float> deviation;  ///< mm
  std::vector<Vec3> points;
  std::size_t off = 0;
};

/// What the points near a place of the nominal say.
struct Shown {
  float mean = kNone;   ///< of those within reach
  float worst = kNone;  ///< the largest against its tolerance
  bool any() const { return !std::isnan(mean); }
};

/// Points of a scan with the places that they show. Thread-safe.
class ScanSurface {
 public:
  /// `asked_mm`: how far off points are asked for, besides.
  ScanSurface(Measured measured, double reach_mm, double asked_mm, const CompareOptions& options)
      : measured_(std::move(measured)),
        cells_(measured_.feet, std::max({reach_mm, asked_mm, 1e-6})),
        reach_(reach_mm),
        gouge_(std::max(options.gouge_mm, 1e-9)),
        excess_(std::max(options.excess_mm, 1e-9)) {}

  const Measured& measured() const { return measured_; }

  /// `near_mm`: no point farther off, but for the nearest, is asked for the worst.
  Shown at(const Vec3& place, const Vec3& normal, double near_mm) const {
    double sum = 0.0, worst = -1.0, nearest = std::numeric_limits<double>::infinity();
    std::size_t count = 0;
    Shown out;
    cells_.forEachNear(place, std::max(reach_, near_mm), [&](std::uint32_t i, double squared) {
      if (measured_.normals[i].dot(normal) < kAlike) return;
      const float d = measured_.deviation[i];
      if (squared <= reach_ * reach_) {
        sum += d;
        ++count;
      }
      const bool near = squared <= near_mm * near_mm;
      if (worst < 0.0 && !near && squared < nearest) {
        nearest = squared;
        out.worst = d;
      }
      const double share = d > 0.0f ? d / excess_ : -d / gouge_;
      if (!near || share <= worst) return;
      worst = share;
      out.worst = d;
    });
    if (count > 0) {
      out.mean = static_cast<float>(sum / static_cast<double>(count));
    } else {
      out.worst = kNone;
    }
    return out;
  }

  /// The point of the scan near a place that has about that deviation; the place itself where none has.
  Vec3 pointNear(const Vec3& place, double deviation, double near_mm) const {
    constexpr double kSame = 1e-6;
    Vec3 out = place;
    double nearest = std::numeric_limits<double>::infinity();
    cells_.forEachNear(place, near_mm, [&](std::uint32_t i, double squared) {
      if (std::abs(measured_.deviation[i] - deviation) > kSame || squared >= nearest) return;
      nearest = squared;
      out = measured_.points[i];
    });
    return out;
  }

  /// The area that each point stands for, as parts of `area_mm2`: less where many crowd.
  DeviationPieces pieces(double area_mm2) const {
    const std::vector<std::uint32_t> crowds = cells_.crowds();
    double sum = 0.0;
    for (const std::uint32_t crowd : crowds) sum += 1.0 / crowd;
    DeviationPieces out;
    out.reserve(crowds.size());
    for (std::size_t i = 0; i < crowds.size(); ++i) {
      const float d = measured_.deviation[i];
      out.push_back({area_mm2 / (sum * crowds[i]), {d, d, d}});
    }
    return out;
  }

 private:
  Measured measured_;
  PointCells cells_;
  double reach_, gouge_, excess_;
};

/// Deviations between the vertices of the nominal, for pictures.
class ScanField final : public DeviationField {
 public:
  ScanField(std::shared_ptr<const NominalModel> model, std::shared_ptr<const ScanSurface> scan,
            const CompareOptions& options)
      : model_(std::move(model)),
        scan_(std::move(scan)),
        faces_(options.nominal_faces),
        ignored_(options.ignored) {}

  float at(const Vec3& p) const override {
    if (ignored(ignored_, p)) return kNone;
    return scan_->at(p, footOf(p).normal, 0.0).mean;
  }
  NominalFoot footOf(const Vec3& p) const override {
    const SurfaceDistance d = model_->distance.at(p);
    NominalFoot foot;
    foot.normal = d.gradient.cast<double>();
    if (faces_ != nullptr) foot.face = faces_->of_triangle[d.triangle];
    return foot;
  }

 private:
  std::shared_ptr<const NominalModel> model_;
  std::shared_ptr<const ScanSurface> scan_;
  std::shared_ptr<const CadFaces> faces_;
  std::vector<IgnoredRegion> ignored_;
};

/// Measures the points in an order in which neighbours follow each other. None where it was cancelled.
std::optional<Measured> measure(const std::vector<Vec3>& points, double spacing, const NominalModel& model,
                                const CompareOptions& o, Progress& progress) {
  const PointCells cells(points, std::max(spacing, 1e-6));
  std::vector<Vec3> sorted;
  sorted.reserve(points.size());
  for (const std::uint32_t i : cells.order()) {
    if (!ignored(o.ignored, points[i])) sorted.push_back(points[i]);
  }
  const std::vector<SurfaceDistance> distances = model.distance.at(sorted, progress, 0.05, 0.6);
  if (progress.cancelled()) return std::nullopt;
  PROVEOUT_ASSERT(distances.size() == sorted.size());
  Measured out;
  const double limit = scanOffLimit(o);
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const SurfaceDistance& d = distances[i];
    const double deviation = model.deviation(d, sorted[i]);
    if (std::abs(deviation) > limit) {
      ++out.off;
      continue;
    }
    const Vec3 normal = d.gradient.cast<double>();
    out.points.push_back(sorted[i]);
    out.normals.push_back(normal);
    out.feet.push_back(sorted[i] - d.distance * normal);
    out.deviation.push_back(static_cast<float>(deviation));
  }
  return out;
}

/// Outward, weighted by area.
std::vector<Vec3> normalsOf(const SurfaceMesh& mesh) {
  std::vector<Vec3> out(mesh.points.size(), Vec3::Zero());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const auto v : mesh.triangles[t]) out[v] += mesh.areaVector(t);
  }
  for (Vec3& n : out) n.normalize();
  return out;
}

/// A side that says nothing: a triangle whose corners are left out.
SampleMesh nothing() {
  SampleMesh out;
  out.surface.points.assign(3, Vec3::Zero());
  out.surface.triangles.push_back({0, 1, 2});
  out.parent.push_back(0);
  return out;
}

void start(SampledSide& side, const SampleMesh& mesh) {
  const std::size_t count = mesh.surface.points.size();
  side.mesh = &mesh;
  side.deviation.assign(count, kNone);
  side.bound.assign(count, 0.0f);
  side.gradient.assign(count, Eigen::Vector3f::UnitZ());
  side.opposite.assign(count, 0);
}

class ScanComparer {
 public:
  ScanComparer(const TriMesh& nominal, const ScanOptions& options, Progress& progress)
      : nominal_(nominal), options_(options), o_(options_.compare), progress_(progress) {}

  Result<ScanComparison> run(const std::vector<Vec3>& points) {
    model_ = std::make_shared<const NominalModel>(nominal_, 0.5 * o_.resolution_mm, o_.nominal_faces.get());
    out_.spacing_mm = pointSpacing(points, meshArea(nominal_));
    std::optional<Measured> measured = measure(points, out_.spacing_mm, *model_, o_, progress_);
    if (!measured) return Error{ErrorKind::kInterrupted, "comparison interrupted"};
    out_.off = measured->off;
    out_.points = measured->points.size();
    out_.reach_mm = reachOf(out_.spacing_mm);
    // About as many as points: each stands for little more than the points near it say.
    samples_ =
        makeSampleMesh(nominal_, std::min(o_.resolution_mm, 0.5 * out_.reach_mm), kMostSampleTriangles);
    scan_ = std::make_shared<const ScanSurface>(std::move(*measured), out_.reach_mm, samples_.spacing_mm, o_);
    lookAtSamples();
    if (progress_.cancelled()) return Error{ErrorKind::kInterrupted, "comparison interrupted"};
    tellFigures();
    judge();
    finish();
    progress_.report("comparing", 1.0);
    return std::move(out_);
  }

 private:
  Comparison& comparison() { return out_.comparison; }

  double reachOf(double spacing) const {
    constexpr double kSpacings = 2.0;  // of points without order four places in a million have none so near
    constexpr double kLeast = 1e-3;
    if (options_.reach_mm > 0.0) return options_.reach_mm;
    return spacing > 0.0 ? std::max(kSpacings * spacing, kLeast) : o_.resolution_mm;
  }

  void lookAtSamples() {
    const SurfaceMesh& surface = samples_.surface;
    start(sides_.machined, nothing_);
    start(sides_.nominal, samples_);
    const std::vector<Vec3> normals = normalsOf(surface);
    shown_.resize(surface.points.size());
    left_out_.assign(surface.points.size(), 0);
    parallelFor(std::size_t{0}, surface.points.size(), [&](std::size_t i) {
      if (progress_.cancelled()) return;
      sides_.nominal.gradient[i] = normals[i].cast<float>();
      left_out_[i] = ignored(o_.ignored, surface.points[i]) ? 1 : 0;
      if (left_out_[i] != 0) return;
      shown_[i] = scan_->at(surface.points[i], normals[i], samples_.spacing_mm);
      sides_.nominal.deviation[i] = shown_[i].worst;
    });
    sides_.motion = &no_motions_;
    sides_.model = model_.get();
    sides_.reach_mm = o_.resolution_mm;
  }

  void tellFigures() {
    double covered = 0.0, all = 0.0;
    const SurfaceMesh& surface = samples_.surface;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      const double third = surface.areaVector(t).norm() / 6.0;
      for (const auto v : surface.triangles[t]) {
        if (left_out_[v] != 0) continue;
        all += third;
        if (shown_[v].any()) covered += third;
      }
    }
    out_.coverage = all > 0.0 ? covered / all : 0.0;
    Comparison& c = comparison();
    c.gouge_tolerance_mm = o_.gouge_mm;
    c.excess_tolerance_mm = o_.excess_mm;
    c.nominal_faces = o_.nominal_faces;
    for (const double d : scan_->measured().deviation) {
      c.max_gouge_mm = std::max(c.max_gouge_mm, -d);
      c.max_excess_mm = std::max(c.max_excess_mm, d);
    }
    const DeviationPieces pieces = scan_->pieces(covered);
    c.machined = figuresOf(pieces);
    c.rms_mm = c.machined.rms_mm;
    c.p95_mm = c.machined.p95_mm;
    addToHistogram(pieces, 1.0, c);
  }

  void judge() {
    judgeKind(DeviationKind::kGouge, o_.gouge_mm);
    judgeKind(DeviationKind::kExcess, o_.excess_mm);
    for (auto* patches : {&comparison().patches, &comparison().undecided}) {
      std::stable_sort(
          patches->begin(), patches->end(),
          [](const DeviationPatch& a, const DeviationPatch& b) { return a.depth_mm > b.depth_mm; });
    }
  }

  void judgeKind(DeviationKind kind, double tolerance) {
    const Box3 box = meshBounds(nominal_);
    // Coordinates come as float: what is within four units in the last place is no deviation.
    const double level =
        tolerance + 4.0 * 1.2e-7 * std::max(box.min.cwiseAbs().maxCoeff(), box.max.cwiseAbs().maxCoeff());
    CompareOptions spots = o_;
    spots.spot_gap = {};
    spots.resolution_mm = std::max(o_.resolution_mm, out_.reach_mm);
    for (FoundPatch& found : joinSpots(findPatches(sides_, kind, level, Beyond::kMeasured, nullptr), spots)) {
      DeviationPatch& p = found.patch;
      p.allowed_mm = tolerance;
      p.volume_mm3 = std::max(0.0, p.volume_mm3);
      addFoot(p);
      (p.depth_mm - p.bound_mm > level ? comparison().patches : comparison().undecided).push_back(p);
    }
    tellLonePoint(kind, tolerance, level);
  }

  /// A point beyond tolerance that no sample of the nominal is near to, as at the edge of a blade, is told
  /// all the same.
  void tellLonePoint(DeviationKind kind, double tolerance, double level) {
    const Comparison& c = comparison();
    for (const auto* patches : {&c.patches, &c.undecided}) {
      for (const DeviationPatch& p : *patches) {
        if (p.kind == kind) return;
      }
    }
    const double sign = kind == DeviationKind::kExcess ? 1.0 : -1.0;
    const std::vector<float>& all = scan_->measured().deviation;
    const auto deepest =
        std::max_element(all.begin(), all.end(), [&](float a, float b) { return sign * a < sign * b; });
    if (deepest == all.end() || !(sign * *deepest > level)) return;
    const auto i = static_cast<std::size_t>(deepest - all.begin());
    DeviationPatch p;
    p.kind = kind;
    p.where = scan_->measured().feet[i];
    p.normal = scan_->measured().normals[i];
    p.depth_mm = sign * *deepest;
    p.allowed_mm = tolerance;
    p.bounds.extend(p.where);
    p.makers.push_back({{}, 1.0, p.depth_mm, p.where, p.normal});
    p.from_nominal_only = true;
    addFoot(p);
    (p.depth_mm - p.bound_mm > level ? comparison().patches : comparison().undecided).push_back(p);
  }

  /// The face and its chord, and the scan's own point in place of the sample.
  void addFoot(DeviationPatch& p) const {
    const SurfaceDistance d = model_->distance.at(p.where);
    p.chord_mm = model_->shape.unsureAt(d.triangle, p.where, o_.resolution_mm);
    p.bound_mm += p.chord_mm;
    if (o_.nominal_faces != nullptr) p.face = o_.nominal_faces->of_triangle[d.triangle];
    const double deviation = p.kind == DeviationKind::kExcess ? p.depth_mm : -p.depth_mm;
    p.where = scan_->pointNear(p.where, deviation, std::max(out_.reach_mm, samples_.spacing_mm));
  }

  void finish() {
    Comparison& c = comparison();
    for (std::size_t v = 0; v < nominal_.positions.size(); ++v) c.vertex_deviation.push_back(shown_[v].mean);
    c.field = std::make_shared<const ScanField>(model_, scan_, o_);
    c.ignored_mm2.assign(o_.ignored.size(), 0.0);
    const bool doubt = model_->shape.largestDoubt() > model_->shape.largestRead();
    c.nominal_chord_in_doubt = doubt;
    c.nominal_chord_mm = doubt ? model_->shape.largestDoubt() : model_->shape.largestRead();
    c.nominal_chord_at = doubt ? model_->shape.largestDoubtAt() : model_->shape.largestReadAt();
    c.machined_spacing_mm = c.nominal_spacing_mm = samples_.spacing_mm;
    c.machined_samples = out_.points;
    c.nominal_samples = samples_.surface.points.size();
  }

  const TriMesh& nominal_;
  const ScanOptions& options_;
  const CompareOptions& o_;
  Progress& progress_;
  std::shared_ptr<const NominalModel> model_;
  std::shared_ptr<const ScanSurface> scan_;
  SampleMesh samples_;
  const SampleMesh nothing_ = nothing();
  const std::vector<std::uint32_t> no_motions_;
  std::vector<Shown> shown_;    ///< of the samples
  std::vector<char> left_out_;  ///< of the samples: in an ignored region
  BothSides sides_;
  ScanComparison out_;
};

}  // namespace scan_detail

double scanOffLimit(const CompareOptions& options) {
  return std::max(2.0, 20.0 * std::max(options.gouge_mm, options.excess_mm));
}

std::vector<Vec3> scanPointsOf(const TriMesh& mesh, double spacing_mm) {
  return makeSampleMesh(mesh, spacing_mm, scan_detail::kMostSampleTriangles).surface.points;
}

Result<ScanComparison> compareScan(const std::vector<Vec3>& points, const TriMesh& nominal,
                                   const ScanOptions& options, Progress& progress) {
  if (points.empty()) return inputError("the scan has no points");
  for (const Vec3& p : points) {
    if (!p.allFinite()) return inputError("the scan has a point that is not finite");
  }
  if (auto bad = findBadElements(nominal, "the nominal mesh")) return *bad;
  const OpenEdges open = findOpenEdges(nominal);
  if (!open.closed())
    return inputError(fmt::format("the nominal mesh is not closed at {} mm", placeText(open.first)));
  PROVEOUT_ASSERT(options.compare.nominal_faces == nullptr ||
                  options.compare.nominal_faces->of_triangle.size() == nominal.triangles.size());
  return scan_detail::ScanComparer(nominal, options, progress).run(points);
}

}  // namespace proveout
