#include "app/fixtures.h"

#include <fmt/format.h>

#include "app/contact_findings.h"
#include "removal/turning/turned_stock.h"

namespace proveout {

Result<std::vector<FixtureStock>> makeFixtures(const Job& setup, double resolution_mm, Progress& progress) {
  std::vector<FixtureStock> fixtures;
  for (const FixtureSpec& spec : setup.fixtures) {
    const auto inFixture = [&](const Error& error) {
      return Error{error.kind, fmt::format("fixture '{}': {}", spec.name, error.message)};
    };
    const Result<StockShape> shape = loadStockShape(spec.shape);
    if (!shape) return inFixture(shape.error());
    if (const Status fits = checkThickness(*shape, resolution_mm); !fits) return inFixture(fits.error());
    Result<Stock> stock = Stock::create(*shape, removalOptions(setup, resolution_mm), progress);
    if (!stock) return inFixture(stock.error());
    fixtures.push_back({spec.name, std::move(*stock)});
  }
  return fixtures;
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
