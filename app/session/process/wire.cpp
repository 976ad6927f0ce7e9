// Cutting with a wire: the workpiece is sections, or on the grid where its blank is no prism.
#include <fmt/format.h>

#include "app/session/process/process.h"
#include "app/session/run_result.h"
#include "app/session/turning_work.h"
#include "app/session/wire_findings.h"
#include "app/session/wire_fixtures.h"
#include "removal/process/wire_grid_piece.h"
#include "removal/process/wire_piece.h"
#include "removal/wire/start_holes.h"
#include "removal/wire/wire_work.h"

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

/// Of a wire that leans: some walls take many heights, of programs of any length.
double leanTriangles(const Job& job, const Toolpath& path, const Box3& bounds) {
  constexpr double kAPiece = 36.0, kRefinedPieces = 2000.0, kARefinedPiece = 2000.0;
  const auto pieces =
      static_cast<double>(leanPieces(path, {bounds.min.z(), bounds.max.z()}, facetTolerance(job)));
  return kAPiece * pieces + kARefinedPiece * std::min(pieces, kRefinedPieces);
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
  work.triangles = standsUpright(path) ? kTrianglesOfAMotion * static_cast<double>(work.motions)
                                       : leanTriangles(run.setups[k].job, path, bounds);
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

}  // namespace

const Process kWireProcess{
    .kind = ProcessKind::kWire,
    .verb = "cuts with a wire",
    .part_turns = false,
    .on_grid = false,
    .always_changes_tool = false,
    .tool_turns = false,
    .starts_outside = false,
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
