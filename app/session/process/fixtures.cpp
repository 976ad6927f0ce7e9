#include "app/session/process/fixtures.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "app/session/findings/contact_findings.h"
#include "app/session/forecast/prediction.h"
#include "app/session/nominal/nominal_mesh.h"
#include "app/session/run/blank.h"
#include "core/tool/tool_solid.h"
#include "core/tool/tool_type.h"
#include "removal/sweep/tool_frame.h"
#include "removal/turning/turned_stock.h"

namespace proveout {

namespace {

/// Cells of the grid that a window is wider than what the tools reach.
constexpr double kWindowCells = 16.0;

/// Bounds of all that any part of a tool sweeps, mm; empty: nothing moves.
Box3 reachOfTools(const SetupRun& setup) {
  std::map<int, Box3> bounds;
  for (const Tool& tool : setup.job.tools) {
    if (rowOf(tool.type).rotates) bounds.try_emplace(tool.number, boundsOf(makeToolSolid(tool)));
  }
  Box3 reach;
  for (const Motion& motion : setup.interpreted.path.motions) {
    const auto tool = bounds.find(motion.tool);
    if (tool == bounds.end()) continue;
    const Box3 way = setup.interpreted.path.bounds(motion);
    if (const MotionWay how = wayOf(setup.interpreted.path, motion); how.leans() || how.turns()) {
      const Box3& tip_up = tool->second;  // any direction
      reach.extend(way.inflated(tip_up.min.cwiseAbs().cwiseMax(tip_up.max.cwiseAbs()).norm()));
      continue;
    }
    reach.extend(way.min + tool->second.min);
    reach.extend(way.max + tool->second.max);
  }
  return reach;
}

}  // namespace

Result<FixtureStocks> makeFixtures(const SetupRun& setup, double resolution_mm, Progress& progress) {
  FixtureStocks fixtures;
  RemovalOptions options = removalOptions(setup.job, resolution_mm);
  if (!setup.job.fixtures.empty())
    options.window = reachOfTools(setup).inflated(kWindowCells * resolution_mm);
  for (const FixtureSpec& spec : setup.job.fixtures) {
    const auto inFixture = [&](const Error& error) {
      return Error{error.kind, fmt::format("fixture '{}': {}", spec.name, error.message)};
    };
    const Result<LoadedSolid> solid = loadSolid(spec.shape);
    if (!solid) return inFixture(solid.error());
    for (const std::string& repair : solid->repairs)
      fixtures.repairs.push_back(fmt::format("fixture '{}': {}", spec.name, repair));
    const StockShape& shape = solid->shape;
    if (const Status fits = checkThickness(shape, resolution_mm); !fits) return inFixture(fits.error());
    if (!shapeBounds(shape).overlaps(*options.window)) continue;
    Result<Stock> stock = Stock::create(shape, options, progress);
    if (!stock) return inFixture(stock.error());
    fixtures.stocks.push_back({spec.name, std::move(*stock)});
  }
  return fixtures;
}

FixtureAreas fixtureAreas(const SetupRun& setup) {
  FixtureAreas areas;
  if (setup.job.fixtures.empty()) return areas;
  const Box3 reach = reachOfTools(setup);
  for (const FixtureSpec& spec : setup.job.fixtures) {
    const Result<StockShape> shape = loadStockShape(spec.shape);
    if (!shape) continue;  // told when it is made
    const Box3 bounds = shapeBounds(*shape);
    if (!bounds.overlaps(reach)) continue;
    const double whole = blankArea(*shape, bounds);
    if (std::holds_alternative<MeshShape>(*shape)) {
      areas.meshes_mm2 += whole;
      continue;
    }
    const Box3 built{bounds.min.cwiseMax(reach.min), bounds.max.cwiseMin(reach.max)};
    areas.solids_mm2 += std::min(whole, blankArea(BoxShape{built.min, built.max}, built));
  }
  return areas;
}

Status addFixtureContacts(std::vector<FixtureStock>& fixtures, const SetupRun& setup,
                          const RecordingSource& texts, std::vector<Finding>& findings, Progress& progress) {
  for (FixtureStock& fixture : fixtures) {
    RemovalOptions options = removalOptions(setup.job, fixture.stock.resolution());
    options.watch_all = true;
    const Toolpath& path = setup.interpreted.path;
    const Result<RemovalSummary> touched = fixture.stock.remove(path, setup.job.tools, options, progress);
    if (!touched) return touched.error();
    addFixtureContacts(touched->contacts, fixture.name, setup.job.simulation.contact_mm, path, texts,
                       findings);
  }
  return Done{};
}

Status addTurnedFixtureContacts(const SetupRun& setup, const RecordingSource& texts,
                                std::vector<Finding>& findings, Progress& progress) {
  for (const FixtureSpec& spec : setup.job.fixtures) {
    const Result<StockShape> shape = loadStockShape(spec.shape);
    if (!shape) return shape.error();
    const Result<TurnedStock> fixture = TurnedStock::create(*shape);
    if (!fixture) return fixture.error();
    const Toolpath& path = setup.interpreted.path;
    const auto touched = fixture->touches(path, setup.job.tools, progress);
    if (!touched) return touched.error();
    addFixtureContacts(*touched, spec.name, setup.job.simulation.contact_mm, path, texts, findings);
  }
  return Done{};
}

}  // namespace proveout
