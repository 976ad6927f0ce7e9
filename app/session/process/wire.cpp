// Cutting with a wire: the workpiece is sections, or on the grid where its blank is no prism.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/session/findings/wire_findings.h"
#include "app/session/process/turning_work.h"
#include "app/session/process/wire_fixtures.h"
#include "app/session/run/process.h"
#include "app/session/run/run_result.h"
#include "removal/process/wire_grid_piece.h"
#include "removal/process/wire_piece.h"
#include "removal/wire/falls/wire_work.h"
#include "removal/wire/start_holes.h"

namespace proveout {
namespace {

/// The blank with its start holes. Errors: another shape, holes that are not inside of it.
Result<PrismBlank> prismWithHoles(const Blank& blank) {
  Result<PrismBlank> prism = prismOf(blank.shape);
  if (!prism) return prism.error();
  if (const Status holes = addStartHoles(*prism, blank.start_holes); !holes) return holes.error();
  return prism;
}

/// Whether the blank goes without a grid; others, and what was clamped before, may be anything.
bool isPrism(const Blank& blank) { return prismOf(blank.shape).ok(); }

/// Start holes are for blanks with upright walls.
Status check(const Job& job, std::size_t k, const Blank& blank) {
  if (k == 0 && (isPrism(blank) || !blank.start_holes.empty())) {
    if (const Result<PrismBlank> prism = prismWithHoles(blank); !prism) return prism.error();
  }
  if (savesStock(job) && setupCount(job) == 1 && isPrism(blank))
    return inputError("what a wire cuts has no grid to be saved: leave vdb out");
  return Done{};
}

/// The control says itself where the wire is threaded.
Vec3 start(const Box3& blank) { return {0.0, 0.0, blank.min.z()}; }

bool holds(const Tool& tool) { return tool.type == ToolType::kWire; }

std::unique_ptr<PieceProbe> probe(const Job& /*setup*/, const ProbedStock& /*stock*/,
                                  const Toolpath& /*path*/, Progress& /*progress*/) {
  return nullptr;
}

/// Of a wire that leans, as triangles of a mesh from half sections.
struct LeanWork {
  double triangles = 0.0;
  double pieces = 0.0;    ///< of the way
  double sections = 0.0;  ///< whole contours that are cut at heights of their own, by what they take
};

/// Walls take more heights where steps are long, corners are sharp, the wire turns about its way, and on ways
/// to a contour and back; each sharp corner asks for sections of the whole contour (measured; see the jobs in
/// tests/bench).
LeanWork leanWork(const Job& job, const Toolpath& path, const Box3& bounds) {
  constexpr double kAPiece = 30.0, kAMmOfPiece = 800.0, kLongPiece = 2.0, kATurned = 650.0, kASharp = 4500.0,
                   kALead = 50000.0, kTurn = 0.15, kSharp = 0.8, kAPieceOfASection = 2.6;
  const HeightSpan span{bounds.min.z(), bounds.max.z()};
  const auto angle = [](const Vec2& u, const Vec2& v) {
    const double lengths = u.norm() * v.norm();
    return lengths > 0.0 ? std::acos(std::clamp(u.dot(v) / lengths, -1.0, 1.0)) : 0.0;
  };
  double sum = 0.0, all = 0.0, sharp = 0.0;
  Vec2 before = Vec2::Zero();
  bool compensated = false;
  std::vector<LeanStretch> pieces;
  for (const Motion& motion : path.motions) {
    if (motion.wire < 0 || motion.kind != MotionKind::kFeed) continue;
    if (motion.compensated != compensated) sum += kALead;
    compensated = motion.compensated;
    pieces.clear();
    addLeanStretches(path.wires[static_cast<std::size_t>(motion.wire)], span, 1.0, facetTolerance(job), 0,
                     pieces);
    for (const LeanStretch& piece : pieces) {
      const Vec2 low = piece.to_low - piece.from_low, high = piece.to_high - piece.from_high;
      sum += kAPiece + kAMmOfPiece * std::min(kLongPiece, std::max(low.norm(), high.norm()));
      if (angle(low, high) > kTurn) sum += kATurned;
      if (angle(before, low) > kSharp) ++sharp;
      before = low;
    }
    all += static_cast<double>(pieces.size());
  }
  return {sum + sharp * kASharp, all, sharp * all * kAPieceOfASection};
}

/// Walls have two triangles a motion on either side of the kerf, faces as many. Behind another clamping each
/// body is cut out of the grid.
Workload work(const Job& job, const RunResult& run, std::size_t k, const Blank& blank) {
  constexpr double kTrianglesOfAMotion = 16.0;
  Workload work;
  work.clampings = 1;
  work.motions = run.setups[k].interpreted.path.motions.size();
  const Toolpath& path = run.setups[k].interpreted.path;
  const Box3 bounds = movedBounds(job, blank.bounds, k);
  if (standsUpright(path)) {
    constexpr double kShareOfTime = 0.9;
    work.triangles = kTrianglesOfAMotion * static_cast<double>(work.motions);
    work.thread_triangles = kShareOfTime * work.triangles;
  } else {
    // Of a triangle of a mesh from half sections.
    constexpr double kShareOfTime = 1.25, kPieceShare = 40.0, kSectionShare = 1.57;
    const LeanWork lean = leanWork(run.setups[k].job, path, bounds);
    work.triangles = lean.triangles;
    work.thread_triangles =
        kShareOfTime * lean.triangles + kPieceShare * lean.pieces + kSectionShare * lean.sections;
  }
  if (k == 0 && isPrism(blank)) return work;
  constexpr double kCopies = 3.0;
  work.surface_mm2 = kCopies * blankArea(blank.shape, bounds);
  if (k == 0) return work;
  work.mesh_moves = movesExactly(run.setups[k].from_previous) ? 0 : 1;
  return processOf(job, k - 1).on_grid ? work : together(work, ontoGridWork(run.setups[k - 1], blank));
}

Result<std::unique_ptr<Workpiece>> make(Blank& blank, const Job& job, Progress& progress) {
  if (!isPrism(blank)) {
    Result<Stock> stock = takeStock(blank, job, progress);
    if (!stock) return stock.error();
    double volume_mm3 = stock->initialVolume();
    if (std::holds_alternative<SavedStock>(blank.shape)) {  // that is of its first blank
      const Result<StockVolume> held = stock->volume(SurfaceOptions{}, progress);
      if (!held) return held.error();
      volume_mm3 = held->mm3;
    }
    return pieceOnGrid(ProcessKind::kWire, std::move(*stock), volume_mm3, volume_mm3, {});
  }
  Result<PrismBlank> prism = prismWithHoles(blank);
  if (!prism) return prism.error();
  return std::unique_ptr<Workpiece>(std::make_unique<WirePiece>(WireStock(std::move(*prism))));
}

Result<std::unique_ptr<Fixtures>> fixtures(const SetupRun& setup, double /*resolution_mm*/,
                                           Progress& /*progress*/) {
  Result<WireFixtures> made = WireFixtures::create(setup.job.fixtures);
  if (!made) return made.error();
  return std::unique_ptr<Fixtures>(std::make_unique<WireFixtures>(std::move(*made)));
}

std::string facetsText(const Job& setup) {
  return fmt::format("the mesh stays within {:g} mm of the walls that the wire left{}", facetTolerance(setup),
                     setup.simulation.simplify_mm ? "; simplify does not apply to them" : "");
}

}  // namespace

const Process kWireProcess{
    .kind = ProcessKind::kWire,
    .words =
        {.verb = "cuts with a wire",
         .tool_advice = ": it needs a job file whose [[tool]] has type = \"wire\" and its diameter",
         .needs_job =
             "control {} cuts with a wire, which a job file gives: proveout run JOB.toml, where the job has "
             "program, control, "
             "[stock] and a [[tool]] with type = \"wire\" and its diameter",
         .exact_tool = "the wire is a straight cylinder with its spark gap about it; that it lags, bows "
                       "and vibrates is not simulated",
         .exact_grid = kSweptGridAccuracy,
         .exact_section = nullptr,
         .exact_facets = facetsText},
    .part_turns = false,
    .on_grid = false,
    .always_changes_tool = false,
    .tool_turns = false,
    .starts_outside = false,
    .from_above = false,
    .names_tools = false,
    .cuts_through = true,
    .check = check,
    .start = start,
    .holds = holds,
    .probe = probe,
    .work = work,
    .make = make,
    .fixtures = fixtures,
    .look = addWireFindings,
};

}  // namespace proveout
