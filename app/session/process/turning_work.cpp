#include "app/session/process/turning_work.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "core/tool/convex_outline.h"
#include "core/tool/tool_table.h"
#include "removal/turning/section/section.h"

namespace proveout {

namespace {

/// A facet of the mesh may leave the surface by this share of the profile's resolution.
constexpr double kFacetShare = 0.1;

/// The smallest radius that the path comes to, in slices of the blank's length.
class LowestRadius {
 public:
  explicit LowestRadius(const Box3& blank)
      : from_(blank.min.z()),
        slice_(std::max(blank.size().z(), 1e-9) / kSlices),
        radius_(kSlices, std::numeric_limits<double>::infinity()) {}

  void lower(const Motion& m) {
    const Vec3 &low = m.from.z() <= m.to.z() ? m.from : m.to, &high = m.from.z() <= m.to.z() ? m.to : m.from;
    if (high.z() < from_ || low.z() > from_ + kSlices * slice_) return;
    const double length = high.z() - low.z();
    for (std::size_t i = sliceAt(low.z()), last = sliceAt(high.z()); i <= last; ++i) {
      const double z = from_ + (static_cast<double>(i) + 0.5) * slice_;
      const double t = length > 0.0 ? std::clamp((z - low.z()) / length, 0.0, 1.0) : 0.0;
      const double x = length > 0.0 ? low.x() + t * (high.x() - low.x()) : std::min(low.x(), high.x());
      radius_[i] = std::min(radius_[i], x);
    }
  }
  /// Whether a point lies where nothing goes deeper.
  bool isLowest(const Vec3& p) const {
    const double z = (p.z() - from_) / slice_;
    return z >= 0.0 && z <= kSlices && p.x() <= radius_[sliceAt(p.z())] + kSameMm;
  }

 private:
  static constexpr int kSlices = 1024;
  static constexpr double kSameMm = 0.05;
  std::size_t sliceAt(double z) const {
    return static_cast<std::size_t>(std::clamp((z - from_) / slice_, 0.0, kSlices - 1.0));
  }

  double from_, slice_;
  std::vector<double> radius_;
};

double noseRadius(const std::vector<Tool>& tools, int number) {
  const Tool* tool = ToolTable(tools).find(number);
  return tool != nullptr && tool->insert ? tool->insert->nose_radius : 0.0;
}

/// Points of the profile where a cut ends and the next sets out in another direction: the nose leaves an arc.
double cornerPoints(const Motion& before, const Motion& next, double nose_mm, double tolerance_mm) {
  const Vec3 a = before.to - before.from, b = next.to - next.from;
  const double turn = std::atan2(a.cross(b).norm(), a.dot(b));
  if (!(turn > 1e-6)) return 0.0;
  return 1.0 + (nose_mm > 0.0 ? turn / (2.0 * kPi) * circleSteps(nose_mm, tolerance_mm) : 0.0);
}

double arcPoints(const Toolpath& path, const Motion& m, double tolerance_mm) {
  if (m.arc < 0) return 0.0;
  const ArcGeometry& arc = path.arcs[static_cast<std::size_t>(m.arc)];
  return std::abs(arc.sweep_rad) / (2.0 * kPi) * circleSteps((m.from - arc.center).norm(), tolerance_mm);
}

/// Triangles of the mesh of what is turned without threads.
double profileTriangles(const SetupRun& setup, const Box3& blank) {
  const Toolpath& path = setup.interpreted.path;
  const double tolerance = turnedFacets(setup.job);
  LowestRadius lowest(blank);
  for (const Motion& m : path.motions) {
    if (m.kind == MotionKind::kFeed) lowest.lower(m);
  }
  double points = 4.0;
  const Motion* before = nullptr;
  for (const Motion& m : path.motions) {
    if (m.kind != MotionKind::kFeed) continue;
    if (lowest.isLowest(m.to)) points += arcPoints(path, m, tolerance);
    if (before != nullptr && before->tool == m.tool && lowest.isLowest(before->to))
      points += cornerPoints(*before, m, noseRadius(setup.job.tools, m.tool), tolerance);
    before = &m;
  }
  return 2.0 * points * circleSteps(blank.max.x(), tolerance);
}

/// Of a round insert; 0: of another tool, whose sides are straight.
double roundRadius(const std::vector<Tool>& tools, int number) {
  const Tool* tool = ToolTable(tools).find(number);
  const bool round = tool != nullptr && tool->insert && tool->insert->shape == InsertShape::kRound;
  return round ? tool->insert->nose_radius : 0.0;
}

/// What the passes of one start of a thread cover together.
class Groove {
 public:
  void add(const SetupRun& setup, const Motion& m, const Box3& blank) {
    ++passes_;
    round_ = std::max(round_, roundRadius(setup.job.tools, m.tool));
    starts_.extend(m.from);
    const double length = std::abs(m.to.z() - m.from.z()), inside = std::min(length, blank.size().z());
    const double share = length > 0.0 ? inside / length : 1.0;
    turns_ = std::max(turns_, threadTurns(setup.interpreted.path, m) * share);
  }

  double triangles(double blank_radius, double tolerance) const {
    return 2.0 * turns_ * corners(blank_radius, tolerance) * circleSteps(blank_radius, tolerance);
  }
  bool inRows() const { return round_ > 0.0 && passes_ > 1; }
  double passPoints() const { return static_cast<double>(passes_) * circleSteps(round_, kSectionChordMm); }

 private:
  /// Of two sides, root and crest, or of the arcs that passes of a round tool leave, as of one large arc.
  double corners(double blank_radius, double tolerance) const {
    constexpr double kStraight = 4.0;
    if (!(round_ > 0.0)) return kStraight;
    const double width = starts_.size().z() + 2.0 * round_,
                 depth = std::max(0.0, blank_radius - (starts_.min.x() - round_));
    return std::max(kStraight, (width + 2.0 * depth) / (2.0 * kPi * round_) * circleSteps(round_, tolerance));
  }

  double round_ = 0.0, turns_ = 0.0;
  Box3 starts_;  ///< of the control point
  std::size_t passes_ = 0;
};

/// By start of the thread: the passes of one lie over each other.
void addThreads(const SetupRun& setup, const Box3& blank, Workload& work) {
  std::map<float, Groove> grooves;
  for (const Motion& m : setup.interpreted.path.motions) {
    if (m.kind != MotionKind::kThread) continue;
    grooves[m.thread_start_deg].add(setup, m, blank);
  }
  for (const auto& [start, groove] : grooves) {
    const double triangles = groove.triangles(blank.max.x(), turnedFacets(setup.job));
    work.thread_triangles += triangles;
    if (groove.inRows()) work.groove_triangles += triangles;
    work.pass_points += groove.passPoints();
  }
}

/// Of the cylinder about all threads, as far as it is within the blank, mm2.
double threadedArea(const SetupRun& setup, const Box3& blank) {
  double low = std::numeric_limits<double>::infinity(), high = -low, radius = 0.0;
  for (const Motion& m : setup.interpreted.path.motions) {
    if (m.kind != MotionKind::kThread) continue;
    low = std::min({low, m.from.z(), m.to.z()});
    high = std::max({high, m.from.z(), m.to.z()});
    radius = std::max({radius, m.from.x(), m.to.x()});
  }
  const double length = std::min(high, blank.max.z()) - std::max(low, blank.min.z());
  return length > 0.0 ? 2.0 * kPi * std::min(radius, blank.max.x()) * length : 0.0;
}

}  // namespace

double facetTolerance(const Job& job) { return kFacetShare * job.simulation.profile_resolution_mm; }

double turnedFacets(const Job& job) {
  constexpr double kEach = 0.5;
  return std::max(facetTolerance(job), kEach * job.simulation.simplify_mm.value_or(0.0));
}

Workload turnedGridWork(const Blank& blank) {
  Workload work;
  work.surface_mm2 = work.turned_mm2 = work.threaded_mm2 = blankArea(blank.shape, blank.bounds);
  return work;
}

Workload ontoGridWork(const SetupRun& turned, const Blank& blank) {
  Workload grid = turnedGridWork(blank);
  grid.threaded_mm2 = std::min(grid.threaded_mm2, threadedArea(turned, blank.bounds));
  return grid;
}

Workload turningWork(const SetupRun& setup, const Blank& blank) {
  Workload work;
  const auto& motions = setup.interpreted.path.motions;
  work.clampings = 1;
  work.motions = motions.size();
  for (const Motion& m : motions) {
    if (m.kind == MotionKind::kFeed) ++work.turned_motions;
  }
  addThreads(setup, blank.bounds, work);
  work.triangles = profileTriangles(setup, blank.bounds) + work.thread_triangles;
  return savesStock(setup.job) ? together(work, ontoGridWork(setup, blank)) : work;
}

}  // namespace proveout
