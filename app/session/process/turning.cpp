// Turning: the workpiece is a half section until a thread or a saved grid needs more.
#include <fmt/format.h>

#include "app/session/process/fixtures.h"
#include "app/session/process/turning_work.h"
#include "app/session/programs/clearance.h"
#include "app/session/run/process.h"
#include "app/session/run/run_result.h"
#include "core/tool/tool_table.h"
#include "removal/process/turned_piece.h"
#include "removal/turning/turned_stock.h"

namespace proveout {
namespace {

Status checkFixtures(const Job& setup) {
  for (const FixtureSpec& fixture : setup.fixtures) {
    const Result<StockShape> round = loadStockShape(fixture.shape);
    if (!round) return round.error();
    if (!TurnedStock::create(*round))
      return inputError(fmt::format(
          "fixture '{}': while the part turns a fixture must be a cylinder or tube about Z at X0 Y0",
          fixture.name));
  }
  return Done{};
}

/// Blanks and fixtures are round about Z, clampings keep the axis, tools stay in the plane of the axis.
Status check(const Job& job, std::size_t k, const Blank& blank) {
  const Result<TurnedStock> stock = TurnedStock::create(blank.shape);
  if (!stock) return stock.error();
  const Job setup = jobOfSetup(job, k);
  const Vec3 origin = offsetZero(setup.settings);
  const WorkpiecePlacement& placement = setup.settings.placement;
  if (placement.rotation_deg != 0.0 || workpieceZero(setup.settings).y() != origin.y())
    return inputError(
        "the placement of a turned part has an origin on the spindle axis, with the Y of the work offset, "
        "and no "
        "rotation: a spindle has no zero");
  if (const auto& y = setup.settings.tool_change.y; y && *y != origin.y())
    return inputError(fmt::format(
        "the tool change has Y{:g} (machine frame): a lathe's tools move in the plane Y0, here Y{:g}", *y,
        origin.y()));
  if (setup.start && setup.start->y() != 0.0)
    return inputError(
        fmt::format("the start point has Y{:g}: a lathe's tools move in the plane Y0", setup.start->y()));
  if (Status round = checkFixtures(setup); !round) return round;
  if (k == 0) return Done{};
  const auto moved = stock->moved(stock->shape().bodies.front(), job.setups[k].from_previous);
  if (!moved) return inputError(fmt::format("setup '{}': {}", job.setups[k].name, moved.error().message));
  return Done{};
}

/// Of the touch-off point: outside of the blank and in front of it.
Vec3 start(const Box3& blank) {
  return {blank.max.x() + kTurningClearanceMm, 0.0, blank.max.z() + kTurningClearanceMm};
}

bool holds(const Tool& tool) { return tool.type != ToolType::kWire; }

/// Measuring moves against the part as it has been turned so far.
class TurningProbe final : public PieceProbe {
 public:
  /// `path` gets what the control does and must hold everything before the move that is asked about.
  TurningProbe(const StockShape& blank, const std::vector<Tool>& tools, const Toolpath& path,
               Progress& progress)
      : blank_(blank), tools_(tools), path_(path), progress_(progress) {}
  /// Errors: a tool that the job does not define, a way out of the plane of the spindle axis, cancelled.
  Result<std::optional<double>> firstContact(const Motion& move, const ArcGeometry* arc,
                                             const AxisSweep* axis) override;
  const std::optional<Error>& failure() const override { return failure_; }

 private:
  Status takeMotions();

  const StockShape& blank_;
  const std::vector<Tool>& tools_;
  const Toolpath& path_;
  Progress& progress_;
  Toolpath cut_;  ///< of path_: what has been read
  std::optional<Error> failure_;
};

/// Motions that came since the last time, with the tools that they are cut with.
Status TurningProbe::takeMotions() {
  const auto takeNew = [](const auto& from, auto& to) {
    to.insert(to.end(), from.begin() + std::ssize(to), from.end());
  };
  cut_.files = path_.files;
  takeNew(path_.arcs, cut_.arcs);
  takeNew(path_.axes, cut_.axes);
  const ToolTable tools(tools_);
  while (cut_.motions.size() < path_.motions.size()) {
    Motion motion = path_.motions[cut_.motions.size()];
    const Tool* tool = tools.ofMotion(motion.tool);
    if (tool == nullptr) return undefinedTool(motion.tool);
    motion.tool = tool->number;
    cut_.motions.push_back(motion);
  }
  return Done{};
}

Result<std::optional<double>> TurningProbe::firstContact(const Motion& move, const ArcGeometry* arc,
                                                         const AxisSweep* axis) {
  const auto fail = [&](const Error& error) -> Result<std::optional<double>> {
    failure_ = error;
    return error;
  };
  if (Status done = takeMotions(); !done) return fail(done.error());
  const Tool* tool = ToolTable(tools_).ofMotion(move.tool);
  if (tool == nullptr) return fail(undefinedTool(move.tool));
  Motion asked = move;
  asked.tool = tool->number;
  if (const char* obstacle = turningObstacle(asked, arc, axis))
    return fail(inputError(fmt::format("{}: a part that turns cannot be measured so", obstacle)));
  Result<TurnedStock> stock = TurnedStock::create(blank_);
  if (!stock) return fail(stock.error());
  if (const auto cut = stock->remove(cut_, tools_, progress_); !cut) return fail(cut.error());
  return stock->firstContact(asked, arc, *tool);
}

std::unique_ptr<PieceProbe> probe(const Job& /*setup*/, const ProbedStock& stock, const Toolpath& path,
                                  Progress& progress) {
  // Behind another clamping nothing answers, and the control says so.
  if (stock.blank == nullptr) return nullptr;
  return std::make_unique<TurningProbe>(*stock.blank, stock.tools, path, progress);
}

Workload work(const Job& /*job*/, const RunResult& run, std::size_t k, const Blank& blank) {
  return turningWork(run.setups[k], blank);
}

Result<std::unique_ptr<Workpiece>> make(Blank& blank, const Job& /*job*/, Progress& /*progress*/) {
  Result<TurnedStock> stock = TurnedStock::create(blank.shape);
  if (!stock) return stock.error();
  return std::unique_ptr<Workpiece>(std::make_unique<TurnedPiece>(std::move(*stock)));
}

/// Fixtures that are round about the spindle axis.
class RoundFixtures final : public Fixtures {
 public:
  Status addContacts(const SetupRun& setup, const RecordingSource& texts, std::vector<Finding>& findings,
                     Progress& progress) override {
    return addTurnedFixtureContacts(setup, texts, findings, progress);
  }
};

Result<std::unique_ptr<Fixtures>> fixtures(const SetupRun& /*setup*/, double /*resolution_mm*/,
                                           Progress& /*progress*/) {
  return std::unique_ptr<Fixtures>(std::make_unique<RoundFixtures>());
}

std::string facetsText(const Job& setup) {
  return fmt::format("the mesh stays within {:g} mm, around and along the section or the thread, each",
                     turnedFacets(setup));
}

}  // namespace

const Process kTurningProcess{
    .kind = ProcessKind::kTurning,
    .words = {.verb = "turns the part",
              .tool_advice = "",
              .needs_job = "control {} turns with inserts, which a job file gives: a [[tool]] with type = "
                           "\"insert\"; drills "
                           "alone can be named "
                           "here, as --tool 1=drill:10",
              .exact_tool =
                  "inserts are exact outlines; wear, deflection and the height of the tip are not simulated",
              .exact_grid =
                  ", measured on the cells of the mesh; of the mesh alone: the part is compared as its "
                  "section and "
                  "threads",
              .exact_section =
                  "the half section is made of chords within 0.0001 mm of its arcs, rounded to nanometres",
              .exact_facets = facetsText},
    .part_turns = true,
    .on_grid = false,
    .always_changes_tool = false,
    .tool_turns = false,
    .starts_outside = true,
    .from_above = false,
    .names_tools = true,
    .cuts_through = false,
    .check = check,
    .start = start,
    .holds = holds,
    .probe = probe,
    .work = work,
    .make = make,
    .fixtures = fixtures,
    .look = nullptr,
};

}  // namespace proveout
