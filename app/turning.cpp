#include "app/turning.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "app/blame.h"
#include "app/run_limits.h"
#include "app/stopwatch.h"
#include "app/turning_work.h"
#include "core/geometry/plane.h"
#include "core/nc/interpreter.h"
#include "core/tool/tool_table.h"
#include "removal/turning/revolve.h"
#include "removal/turning/thread_mesh.h"
#include "removal/turning/turned_stock.h"

namespace proveout {
namespace {

/// Chords that turn by less belong to an arc, radians; those of a corner radius of 0.1 mm turn by 0.09.
constexpr double kArcTurn = 0.1;

struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
};

Extent extentOf(const SectionBody& body) {
  Extent extent;
  for (const Vec2& p : body.loops.front().points) {
    extent.low = std::min(extent.low, p.y());
    extent.high = std::max(extent.high, p.y());
  }
  return extent;
}

/// The body whose extent along Z fits best.
std::size_t bodyLike(const std::vector<SectionBody>& bodies, const Box3& wanted) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const Extent extent = extentOf(bodies[k]);
    const double off = std::abs(extent.low - wanted.min.z()) + std::abs(extent.high - wanted.max.z());
    if (off >= least) continue;
    least = off;
    best = k;
  }
  return best;
}

/// Which of the bodies is the part: the one like the nominal; without one the largest that was parted off
/// whole, in front of what the chuck holds; else that. Slugs and rings lie beside what is held.
std::size_t partOf(const std::vector<SectionBody>& bodies, const std::optional<Box3>& nominal) {
  if (bodies.size() < 2) return 0;
  if (nominal) return bodyLike(bodies, *nominal);
  std::size_t best = 0;
  const double held_to = extentOf(bodies.front()).high;
  for (std::size_t k = 1; k < bodies.size(); ++k) {
    if (extentOf(bodies[k]).low < held_to - 1e-6) continue;
    if (best == 0 || bodies[k].volume_mm3 > bodies[best].volume_mm3) best = k;
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

/// The part on the 3-D grid, threads and all, as `run.stock`.
Status makeGrid(const Job& job, const TurnedShape& part, RunResult& run, Progress& progress) {
  const StockShape shape = TurnedStockShape{std::make_shared<const TurnedShape>(part)};
  Result<Stock> stock = Stock::create(shape, removalOptions(job, run.resolution_mm), progress);
  if (!stock) return stock.error();
  run.stock = std::move(*stock);
  return Done{};
}

/// The surface of a part with threads: from its half sections, or where those do not go over into each other
/// from the grid.
Status threadSurface(const Job& job, const TurnedShape& part, const Blank& blank, RunResult& run,
                     SetupRun& setup, Progress& progress) {
  if (auto surface = threadedSurface(part.bodies.front(), part.threads, facetTolerance(job), progress)) {
    setup.surface.mesh = std::move(surface->mesh);
    setup.surface.volume_mm3 = surface->volume_mm3;
    setup.facet_error_mm = surface->deviation_mm;
    return Done{};
  }
  if (progress.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted"};
  if (Status enough = checkMemory(job, turnedGridWork(blank), run.resolution_mm); !enough) return enough;
  if (Status done = makeGrid(job, part, run, progress); !done) return done;
  Result<StockSurface> surface = run.stock->surface(surfaceOptions(job, run.resolution_mm), progress);
  if (!surface) return surface.error();
  setup.surface = std::move(*surface);
  setup.facet_error_mm = 0.0;
  return Done{};
}

/// Whether a thread comes to the heights and radii of the first body.
bool threadReaches(const TurnedShape& shape) {
  const StockBody body = bodyOf(shape.bodies.front(), "");
  return std::any_of(shape.threads.begin(), shape.threads.end(), [&](const ThreadSweep& thread) {
    const Vec2 low = thread.from.cwiseMin(thread.to) + thread.outline->min(),
               high = thread.from.cwiseMax(thread.to) + thread.outline->max();
    return low.y() < body.bounds.max.z() && high.y() > body.bounds.min.z() && low.x() < body.bounds.max.x();
  });
}

}  // namespace

bool turnsPart(const Job& job) {
  const auto& all = controls();
  return std::any_of(all.begin(), all.end(), [&](const ControlInfo& control) {
    return control.turns && control.name == job.control;
  });
}

Status checkTurning(const Job& job, const Blank& blank) {
  Result<TurnedStock> stock = TurnedStock::create(blank.shape);
  if (!stock) return stock.error();
  const TurnedShape shape = stock->shape();
  const Vec3 origin = job.settings.work_offsets[0] + job.settings.common_offset;
  if (const auto& y = job.settings.tool_change.y; y && *y != origin.y())
    return inputError(fmt::format(
        "the tool change has Y{:g} (machine frame): a lathe's tools move in the plane Y0, here Y{:g}", *y,
        origin.y()));
  for (std::size_t k = 0; k < setupCount(job); ++k) {
    if (const std::optional<Vec3> start = jobOfSetup(job, k).start; start && start->y() != 0.0)
      return inputError(
          fmt::format("the start point has Y{:g}: a lathe's tools move in the plane Y0", start->y()));
    for (const FixtureSpec& fixture : jobOfSetup(job, k).fixtures) {
      const Result<StockShape> round = loadStockShape(fixture.shape);
      if (!round) return round.error();
      if (!TurnedStock::create(*round))
        return inputError(fmt::format(
            "fixture '{}': while the part turns a fixture must be a cylinder or tube about Z at X0 Y0",
            fixture.name));
    }
    if (k == 0) continue;
    const auto moved = stock->moved(shape.bodies.front(), job.setups[k].from_previous);
    if (!moved) return inputError(fmt::format("setup '{}': {}", job.setups[k].name, moved.error().message));
  }
  return Done{};
}

Vec3 turningStart(const Box3& blank) {
  return {blank.max.x() + kTurningClearanceMm, 0.0, blank.max.z() + kTurningClearanceMm};
}

namespace {

/// Bounds of the nominal in the frame of a clamping; none without one.
std::optional<Box3> nominalIn(const Job& job, const TriMesh* nominal, std::size_t setup) {
  if (nominal == nullptr) return std::nullopt;
  Box3 bounds = meshBounds(*nominal);
  for (std::size_t k = setupCount(job); k-- > setup + 1;)
    bounds = job.setups[k].from_previous.inverse()(bounds);
  return bounds;
}

/// What one clamping is cut from.
struct Clamped {
  TurnedStock stock;
  double initial_mm3 = 0.0;      ///< of the stock and of what fell off before
  std::vector<StockBody> apart;  ///< what fell off before, in this frame
};

/// Fills the surface and the bodies of a clamping from what is left of its stock; the part comes first.
Status takePart(const Job& job, const TurnedStock& stock, const Blank& blank,
                const std::optional<Box3>& nominal, bool grid, RunResult& run, SetupRun& setup,
                Progress& progress) {
  TurnedShape all = stock.shape();
  setup.facet_error_mm = 2.0 * facetTolerance(job);
  if (all.bodies.empty()) {
    setup.turned = std::make_shared<const TurnedShape>(std::move(all));
    return Done{};
  }
  std::swap(all.bodies[0], all.bodies[partOf(all.bodies, nominal)]);
  TurnedShape part = all;
  part.bodies.resize(1);
  if (part.threads.empty()) {
    setup.surface.mesh = revolved(part.bodies, facetTolerance(job));
    setup.surface.volume_mm3 = part.bodies.front().volume_mm3;
  } else if (Status done = threadSurface(job, part, blank, run, setup, progress); !done) {
    return done;
  }
  if (grid && !run.stock) {
    if (Status done = makeGrid(job, part, run, progress); !done) return done;
  }
  for (const SectionBody& body : all.bodies) setup.bodies.push_back(bodyOf(body, "loose"));
  setup.bodies.front().role = "part";
  setup.bodies.front().volume_mm3 = setup.surface.volume_mm3;
  for (std::size_t k = 1; k < all.bodies.size(); ++k) {
    TurnedShape piece = all;
    piece.bodies = {all.bodies[k]};
    if (!threadReaches(piece)) continue;
    setup.bodies[k].volume_mm3 = threadedVolume(piece.bodies.front(), piece.threads);
  }
  setup.turned = std::make_shared<const TurnedShape>(std::move(all));
  return Done{};
}

/// Of the sections alone; the same, bit for bit, for the same bodies in any order.
double sectionVolume(const TurnedShape& shape) {
  std::vector<double> volumes;
  for (const SectionBody& body : shape.bodies) volumes.push_back(body.volume_mm3);
  std::sort(volumes.begin(), volumes.end());
  return std::accumulate(volumes.begin(), volumes.end(), 0.0);
}

/// What is left of a clamping's stock, mm3. Sections that nothing was taken from are the same to the last
/// digit; sums and moves of them are not, and neither are means over the angle where there are threads.
double volumeLeft(const SetupRun& setup, const RemovalSummary& removal, double held_mm3) {
  if (setup.bodies.empty()) return 0.0;
  const double taken_mm3 = held_mm3 - sectionVolume(*setup.turned);
  if (setup.turned->threads.empty()) return setup.initial_mm3 - taken_mm3;
  const bool nothing = taken_mm3 == 0.0 && std::all_of(removal.removed_mm3.begin(), removal.removed_mm3.end(),
                                                       [](float removed) { return removed == 0.0f; });
  if (nothing) return setup.initial_mm3;
  double sum = 0.0;
  for (const StockBody& body : setup.bodies) sum += body.volume_mm3;
  return std::min(sum, setup.initial_mm3);
}

Status machineOne(const Job& job, const Blank& blank, Clamped& clamped, const std::optional<Box3>& nominal,
                  bool last, RunResult& run, SetupRun& setup, Progress& progress) {
  Stopwatch watch;
  const double held_mm3 = sectionVolume(clamped.stock.shape());
  Result<RemovalSummary> removal = clamped.stock.remove(setup.interpreted.path, setup.job.tools, progress);
  if (!removal) return removal.error();
  run.performance.remove_s += watch.lap();
  if (Status done =
          takePart(job, clamped.stock, blank, nominal, last && savesStock(job), run, setup, progress);
      !done)
    return done;
  run.performance.mesh_s += watch.lap();
  setup.bodies.insert(setup.bodies.end(), clamped.apart.begin(), clamped.apart.end());
  setup.initial_mm3 = clamped.initial_mm3;
  setup.surface.volume_mm3 = volumeLeft(setup, *removal, held_mm3);
  fitRemovedVolume(*removal, setup.initial_mm3 - setup.surface.volume_mm3);
  setup.removal = std::move(*removal);
  return Done{};
}

}  // namespace

Status machineTurned(const Job& job, const Blank& blank, const TriMesh* nominal, RunResult& run,
                     Progress& progress) {
  Result<TurnedStock> first = TurnedStock::create(blank.shape);
  if (!first) return first.error();
  Clamped clamped{std::move(*first), 0.0, {}};
  clamped.initial_mm3 = clamped.stock.initialVolume();
  for (std::size_t k = 0; k < run.setups.size(); ++k) {
    SetupRun& setup = run.setups[k];
    if (k > 0) {
      const SetupRun& before = run.setups[k - 1];
      Result<TurnedStock> moved = clamped.stock.moved(before.turned->bodies.front(), setup.from_previous);
      if (!moved) return moved.error();
      clamped.stock = std::move(*moved);
      clamped.initial_mm3 = before.surface.volume_mm3;
      clamped.apart.assign(before.bodies.begin() + 1, before.bodies.end());
      for (StockBody& body : clamped.apart) body.bounds = setup.from_previous(body.bounds);
    }
    const bool last = k + 1 == run.setups.size();
    if (Status done = machineOne(job, blank, clamped, nominalIn(job, nominal, k), last, run, setup, progress);
        !done)
      return done;
    if (setup.bodies.empty() || setup.surface.mesh.triangles.empty()) {
      run.setups.resize(k + 1);  // there is nothing to clamp again
    }
  }
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
    finding.volume_mm3 = setup.bodies[k].volume_mm3;  // with its threads
    const Box3& bounds = setup.bodies[k].bounds;
    finding.where = Vec3(0.0, 0.0, 0.5 * (bounds.min.z() + bounds.max.z()));
    finding.message = fmt::format(
        "{} of {:.4g} mm3, Z{:.3f} to Z{:.3f}, is cut off here; nothing cuts it any more",
        k == 0 ? "the part" : "a piece", setup.bodies[k].volume_mm3, bounds.min.z(), bounds.max.z());
    blame(finding, body.parted_by, path, texts);
    findings.push_back(std::move(finding));
  }
}

Result<std::optional<double>> TurningProbe::firstContact(const Motion& move, const ArcGeometry* arc,
                                                         const AxisSweep* axis) {
  const auto fail = [&](const Error& error) -> Result<std::optional<double>> {
    failure_ = error;
    return error;
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
    if (findTool(tools_, motion.tool) == nullptr)
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
  return stock->firstContact(asked, arc, *findTool(tools_, asked.tool));
}

double turnedUncertainty(const SetupRun& setup, double resolution_mm) {
  if (setup.facet_error_mm > 0.0) return setup.facet_error_mm + kSectionChordMm;
  double most = 0.0;
  const auto add = [&](double radius) {
    // A chord of the grid leaves a circle by h^2 / (8 r), but never by more than its radius.
    if (radius > 0.0)
      most = std::max(
          most, std::min({resolution_mm * resolution_mm / (8.0 * radius), radius, 0.5 * resolution_mm}));
  };
  for (const SectionLoop& loop : setup.turned->bodies.front().loops) {
    const std::size_t n = loop.points.size();
    for (std::size_t k = 0; k < n; ++k) {
      add(loop.points[k].x());
      // Chords of an arc turn by a little from one to the next: their length over that angle is its radius.
      const Vec2 into = loop.points[k] - loop.points[(k + n - 1) % n],
                 out = loop.points[(k + 1) % n] - loop.points[k];
      const double turn = std::abs(std::atan2(cross2(into, out), into.dot(out)));
      if (turn > 1e-6 && turn < kArcTurn) add(std::max(into.norm(), out.norm()) / turn);
    }
  }
  return most;
}

}  // namespace proveout
