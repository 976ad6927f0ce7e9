#include "app/fixtures.h"

#include <fmt/format.h>

#include "io/report_text.h"
#include "removal/turning/turned_stock.h"

namespace proveout {
namespace {

std::string_view partName(ContactKind kind) {
  if (kind == ContactKind::kShank) return "the tool's shank";
  if (kind == ContactKind::kHolder) return "the tool holder";
  return "the tool";
}

Finding contactFinding(const Contact& contact, const std::string& fixture) {
  Finding finding;
  finding.kind = "fixture_contact";
  finding.where = contact.where;
  finding.depth_mm = contact.depth_mm;
  finding.volume_mm3 = contact.volume_mm3;
  finding.message =
      fmt::format("{} runs into fixture '{}': {} mm deep, {} mm3 in the way", partName(contact.kind), fixture,
                  report_text::figure(contact.depth_mm), report_text::figure(contact.volume_mm3));
  return finding;
}

void addContacts(const std::vector<Contact>& contacts, const std::string& fixture, const Toolpath& path,
                 const RecordingSource& texts, std::vector<Finding>& findings) {
  for (const Contact& contact : contacts) {
    Finding finding = contactFinding(contact, fixture);
    blame(finding, contact.motion, path, texts);
    findings.push_back(std::move(finding));
  }
}

}  // namespace

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
    addContacts(touched->contacts, fixture.name, path, texts, findings);
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
    addContacts(*touched, spec.name, path, texts, findings);
  }
  return Done{};
}

}  // namespace proveout
