#include "app/turning.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "app/stopwatch.h"
#include "core/nc/interpreter.h"
#include "io/half_section.h"
#include "removal/turning/revolve.h"
#include "removal/turning/turned_stock.h"

namespace proveout {
namespace {

/// Share of the profile's resolution that facets may leave the surface by.
constexpr double kFacetShare = 0.1;
/// Distance of the start from the blank, mm.
constexpr double kClearance = 10.0;

bool needsGrid(const Job& job) {
  const auto& formats = job.output.formats;
  return std::find(formats.begin(), formats.end(), OutputFormat::kVdb) != formats.end();
}

double facetTolerance(const Job& job) { return kFacetShare * job.simulation.profile_resolution_mm; }

/// Which of the bodies is the part: the one whose extent along Z fits the nominal best; without one the
/// body that the chuck holds.
std::size_t partOf(const std::vector<SectionBody>& bodies, const TriMesh* nominal) {
  if (nominal == nullptr || bodies.size() < 2) return 0;
  const Box3 wanted = meshBounds(*nominal);
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Vec2& p : bodies[k].loops.front().points) {
      low = std::min(low, p.y());
      high = std::max(high, p.y());
    }
    const double off = std::abs(low - wanted.min.z()) + std::abs(high - wanted.max.z());
    if (off >= least) continue;
    least = off;
    best = k;
  }
  return best;
}

StockBody bodyOf(const SectionBody& section, const char* role) {
  StockBody body;
  body.volume_mm3 = section.volume_mm3;
  body.role = role;
  for (const Vec2& p : section.loops.front().points) {
    body.bounds.extend(Vec3(-p.x(), -p.x(), p.y()));
    body.bounds.extend(Vec3(p.x(), p.x(), p.y()));
  }
  return body;
}

/// The part on the 3-D grid, threads and all.
Status gridSurface(const Job& job, const TurnedShape& part, RunResult& run, SetupRun& setup,
                   Progress& progress) {
  RemovalOptions options = removalOptions(job, run.resolution_mm);
  const StockShape shape = TurnedStockShape{std::make_shared<const TurnedShape>(part)};
  Result<Stock> stock = Stock::create(shape, options, progress);
  if (!stock) return stock.error();
  run.stock = std::move(*stock);
  if (part.threads.empty()) return Done{};
  SurfaceOptions surface_options;
  surface_options.simplify_mm = simplification(job, run.resolution_mm);
  surface_options.threads = job.simulation.threads;
  Result<StockSurface> surface = run.stock->surface(surface_options, progress);
  if (!surface) return surface.error();
  setup.surface = std::move(*surface);
  return Done{};
}

}  // namespace

bool turnsPart(const Job& job) {
  const auto& all = controls();
  return std::any_of(all.begin(), all.end(), [&](const ControlInfo& control) {
    return control.turns && control.name == job.control;
  });
}

Status checkTurning(const Job& job, const Blank& blank) {
  if (!job.setups.empty())
    return inputError(fmt::format("{}: jobs with setups cannot be turned yet", job.control));
  if (!job.fixtures.empty())
    return inputError(fmt::format("{}: fixtures cannot be checked while the part turns", job.control));
  const Result<TurnedStock> stock = TurnedStock::create(blank.shape);
  if (!stock) return stock.error();
  return Done{};
}

Vec3 turningStart(const Box3& blank) { return {blank.max.x() + kClearance, 0.0, blank.max.z() + kClearance}; }

Status machineTurned(const Job& job, const Blank& blank, const TriMesh* nominal, SetupRun& setup,
                     RunResult& run, Progress& progress) {
  Stopwatch watch;
  Result<TurnedStock> stock = TurnedStock::create(blank.shape);
  if (!stock) return stock.error();
  Result<RemovalSummary> removal = stock->remove(setup.interpreted.path, setup.job.tools, progress);
  if (!removal) return removal.error();
  run.performance.remove_s += watch.lap();
  TurnedShape all = stock->shape();
  TurnedShape part = all;
  setup.initial_mm3 = stock->initialVolume();
  setup.bodies.clear();
  if (!all.bodies.empty()) {
    const std::size_t chosen = partOf(all.bodies, nominal);
    std::swap(all.bodies[0], all.bodies[chosen]);
    part.bodies.assign(1, all.bodies.front());
    setup.surface.mesh = revolved(part.bodies, facetTolerance(job));
    setup.surface.volume_mm3 = part.bodies.front().volume_mm3;
    if (stock->hasThreads() || needsGrid(job)) {
      if (Status done = gridSurface(job, part, run, setup, progress); !done) return done;
    }
    for (const SectionBody& body : all.bodies) setup.bodies.push_back(bodyOf(body, "loose"));
    setup.bodies.front().role = "part";
    setup.bodies.front().volume_mm3 = setup.surface.volume_mm3;
    for (std::size_t k = 1; k < all.bodies.size(); ++k) setup.surface.volume_mm3 += all.bodies[k].volume_mm3;
  }
  run.performance.mesh_s += watch.lap();
  fitRemovedVolume(*removal, setup.initial_mm3 - setup.surface.volume_mm3);
  setup.removal = std::move(*removal);
  setup.turned = std::make_shared<const TurnedShape>(std::move(all));
  return Done{};
}

void addPartedBodies(const SetupRun& setup, const RecordingSource& texts, std::vector<Finding>& findings) {
  if (!setup.turned) return;
  const Toolpath& path = setup.interpreted.path;
  for (std::size_t k = 0; k < setup.turned->bodies.size(); ++k) {
    const SectionBody& body = setup.turned->bodies[k];
    if (body.parted_by == kNoMotion) continue;
    Finding finding;
    finding.kind = "part_off";
    finding.severity = Severity::kNote;
    finding.volume_mm3 = body.volume_mm3;
    const Box3& bounds = setup.bodies[k].bounds;
    finding.where = Vec3(0.0, 0.0, 0.5 * (bounds.min.z() + bounds.max.z()));
    finding.message =
        fmt::format("{} of {:.4g} mm3, Z{:.3f} to Z{:.3f}, is cut off here; nothing cuts it any more",
                    k == 0 ? "the part" : "a piece", body.volume_mm3, bounds.min.z(), bounds.max.z());
    blame(finding, body.parted_by, path, texts);
    findings.push_back(std::move(finding));
  }
}

namespace {

/// How far an uncompensated nose stays off the line that its control point draws, mm. `direction`: of travel
/// in (r, z).
double noseDeviation(const Insert& insert, const Vec2& direction) {
  const Vec2 tip = -noseCenter(insert);  // from S to P
  Vec2 normal(direction.y(), -direction.x());
  if (normal.dot(tip) < 0.0) normal = -normal;
  return std::abs(insert.nose_radius - normal.dot(tip));
}

/// The largest along a motion.
double noseDeviation(const Insert& insert, const Toolpath& path, const Motion& motion) {
  constexpr int kSteps = 16;
  double most = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const Vec3 a = path.pointAt(motion, static_cast<double>(i) / kSteps);
    const Vec3 d = path.pointAt(motion, static_cast<double>(i + 1) / kSteps) - a;
    const Vec2 direction(d.x(), d.z());
    if (direction.norm() > 0.0) most = std::max(most, noseDeviation(insert, direction.normalized()));
  }
  return most;
}

std::set<MotionId> motionsOfSurface(const SectionBody& body) {
  std::set<MotionId> motions;
  for (const SectionLoop& loop : body.loops) motions.insert(loop.motion.begin(), loop.motion.end());
  motions.erase(kNoMotion);
  return motions;
}

}  // namespace

void addUncompensated(const SetupRun& setup, double least_mm, const RecordingSource& texts,
                      std::vector<Finding>& findings) {
  if (!setup.turned || setup.turned->bodies.empty()) return;
  const Toolpath& path = setup.interpreted.path;
  const std::set<MotionId> made = motionsOfSurface(setup.turned->bodies.front());
  for (const Tool& tool : setup.job.tools) {
    if (!tool.insert || tool.insert->shape == InsertShape::kGroove ||
        tool.insert->shape == InsertShape::kThread)
      continue;
    double most = least_mm;
    MotionId worst = kNoMotion;
    std::size_t count = 0;
    for (const MotionId id : made) {
      const Motion& motion = path.motions[id];
      if (motion.tool != tool.number || motion.kind != MotionKind::kFeed || motion.compensated) continue;
      const double off = noseDeviation(*tool.insert, path, motion);
      if (off <= least_mm) continue;
      ++count;
      if (off <= most) continue;
      most = off;
      worst = id;
    }
    if (worst == kNoMotion) continue;
    Finding finding;
    finding.kind = "nose_deviation";
    finding.severity = Severity::kWarning;
    finding.where = path.motions[worst].to;
    finding.depth_mm = most;
    finding.message = fmt::format(
        "the nose radius {:g} is not compensated: here it leaves up to {:.3f} mm on the slope ({} such "
        "motions)",
        tool.insert->nose_radius, most, count);
    blame(finding, worst, path, texts);
    findings.push_back(std::move(finding));
  }
}

Result<std::optional<double>> TurningProbe::firstContact(const Motion& move, const ArcGeometry* arc,
                                                         const AxisSweep* axis) {
  const auto fail = [&](const Error& error) -> Result<std::optional<double>> {
    failure_ = error;
    return error;
  };
  const auto defined = [&](int number) {
    return std::find_if(tools_.begin(), tools_.end(),
                        [&](const Tool& tool) { return tool.number == number; });
  };
  Toolpath so_far;
  so_far.files = path_.files;
  so_far.motions = path_.motions;
  so_far.arcs = path_.arcs;
  so_far.axes = path_.axes;
  so_far.motions.push_back(move);
  const int lowest =
      tools_.empty() ? 0 : std::min_element(tools_.begin(), tools_.end(), [](const auto& a, const auto& b) {
                             return a.number < b.number;
                           })->number;
  for (Motion& motion : so_far.motions) {
    if (motion.tool == 0) motion.tool = lowest;  // as assignTools does
    if (defined(motion.tool) == tools_.end())
      return fail(
          inputError(fmt::format("tool {} is not defined; give it as [[tool]] in the job", motion.tool)));
  }
  const Motion asked = so_far.motions.back();
  so_far.motions.pop_back();
  if (const char* obstacle = turningObstacle(asked, arc, axis))
    return fail(inputError(fmt::format("{}: a part that turns cannot be measured so", obstacle)));
  Result<TurnedStock> stock = TurnedStock::create(blank_);
  if (!stock) return fail(stock.error());
  if (const auto cut = stock->remove(so_far, tools_, progress_); !cut) return fail(cut.error());
  return stock->firstContact(asked, arc, *defined(asked.tool));
}

Status writeTurnedProfile(const Job& job, const RunResult& run, StagingFolder& staging, Report& report) {
  const SetupRun& setup = run.setups.back();
  if (!setup.turned || setup.turned->bodies.empty()) return Done{};
  std::vector<std::vector<Vec2>> machined;
  if (!setup.turned->threads.empty()) {
    machined = halfSectionLoops(setup.surface.mesh);
  } else {
    for (const SectionLoop& loop : setup.turned->bodies.front().loops) machined.push_back(loop.points);
  }
  ProfileChartOptions options;
  options.name = job.name;
  if (job.nominal) {
    options.gouge_mm = job.nominal->gouge_mm;
    options.excess_mm = job.nominal->excess_mm;
  }
  return writeProfileChart(machined, run.nominal ? &*run.nominal : nullptr, options, staging, report);
}

Workload turningWork(const SetupRun& setup, const Blank& blank) {
  Workload work;
  const auto& motions = setup.interpreted.path.motions;
  work.motions = motions.size();
  const bool threads = std::any_of(motions.begin(), motions.end(),
                                   [](const Motion& m) { return m.kind == MotionKind::kThread; });
  if (threads || needsGrid(setup.job)) {
    work.surface_mm2 = blankArea(blank.shape, blank.bounds);
    work.uneven_mm2 = work.surface_mm2;  // round everywhere: hardly a cell is merged
  }
  return work;
}

double turnedUncertainty(const SetupRun& setup, double resolution_mm) {
  double least = std::numeric_limits<double>::infinity();
  const bool threads = setup.turned && !setup.turned->threads.empty();
  if (!threads) return 2.0 * facetTolerance(setup.job) + kSectionChordMm;
  for (const SectionLoop& loop : setup.turned->bodies.front().loops) {
    for (const Vec2& p : loop.points) least = p.x() > 0.0 ? std::min(least, p.x()) : least;
  }
  for (const Tool& tool : setup.job.tools) {
    if (tool.insert && tool.insert->nose_radius > 0.0) least = std::min(least, tool.insert->nose_radius);
  }
  if (!std::isfinite(least)) return 0.0;
  return std::min(resolution_mm * resolution_mm / (8.0 * least), 0.5 * resolution_mm);
}

}  // namespace proveout
