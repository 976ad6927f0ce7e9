// Milling: the workpiece is a grid.
#include "app/session/process/fixtures.h"
#include "app/session/process/turning_work.h"
#include "app/session/run/job_defaults.h"
#include "app/session/run/process.h"
#include "app/session/run/run_result.h"
#include "core/tool/tool_type.h"
#include "removal/process/milled_piece.h"

namespace proveout {
namespace {

Status check(const Job& /*job*/, std::size_t /*setup*/, const Blank& /*blank*/) { return Done{}; }

bool holds(const Tool& tool) { return rowOf(tool.type).rotates; }

std::unique_ptr<PieceProbe> probe(const Job& setup, const ProbedStock& stock, const Toolpath& path,
                                  Progress& progress) {
  // The motions of several channels come when their order is settled: later than a measuring move asks.
  if (setup.channels.size() > 1) return nullptr;
  return std::make_unique<StockProbe>(stock, path, progress);
}

Workload work(const Job& job, const RunResult& run, std::size_t k, const Blank& blank) {
  const SetupRun& setup = run.setups[k];
  Workload work = workloadOf(setup.interpreted.path, setup.job.tools, movedBounds(job, blank.bounds, k),
                             blankArea(blank.shape, blank.bounds));
  const FixtureAreas fixtures = fixtureAreas(setup);
  work.fixture_mm2 = fixtures.solids_mm2 + fixtures.meshes_mm2;
  work.fixture_mesh_mm2 = fixtures.meshes_mm2;
  if (k == 0) return work;
  if (!processOf(job, k - 1).on_grid) return together(work, ontoGridWork(run.setups[k - 1], blank));
  work.mesh_moves = movesExactly(setup.from_previous) ? 0 : 1;
  return work;
}

Result<std::unique_ptr<Workpiece>> make(Blank& blank, const Job& job, Progress& progress) {
  Result<Stock> stock = takeStock(blank, job, progress);
  if (!stock) return stock.error();
  const bool saved = std::holds_alternative<SavedStock>(blank.shape);
  return std::unique_ptr<Workpiece>(std::make_unique<MilledPiece>(std::move(*stock), saved));
}

class GridFixtures final : public Fixtures {
 public:
  explicit GridFixtures(FixtureStocks made) : made_(std::move(made)) {}
  std::vector<std::string> repairs() const override { return made_.repairs; }
  Status addContacts(const SetupRun& setup, const RecordingSource& texts, std::vector<Finding>& findings,
                     Progress& progress) override {
    return addFixtureContacts(made_.stocks, setup, texts, findings, progress);
  }

 private:
  FixtureStocks made_;
};

Result<std::unique_ptr<Fixtures>> fixtures(const SetupRun& setup, double resolution_mm, Progress& progress) {
  Result<FixtureStocks> made = makeFixtures(setup, resolution_mm, progress);
  if (!made) return made.error();
  return std::unique_ptr<Fixtures>(std::make_unique<GridFixtures>(std::move(*made)));
}

}  // namespace

const Process kMillingProcess{
    .kind = ProcessKind::kMilling,
    .words = {.verb = "mills",
              .tool_advice = "",
              .needs_job = nullptr,
              .exact_tool =
                  "tools are exact solids of revolution; runout, wear and deflection are not simulated",
              .exact_grid = kSweptGridAccuracy,
              .exact_section = nullptr,
              .exact_facets = nullptr},
    .part_turns = false,
    .on_grid = true,
    .always_changes_tool = true,
    .tool_turns = true,
    .starts_outside = true,
    .from_above = true,
    .names_tools = true,
    .cuts_through = false,
    .check = check,
    .start = defaultStart,
    .holds = holds,
    .probe = probe,
    .work = work,
    .make = make,
    .fixtures = fixtures,
    .look = nullptr,
};

}  // namespace proveout
