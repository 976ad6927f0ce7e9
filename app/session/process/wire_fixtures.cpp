#include "app/session/process/wire_fixtures.h"

#include <fmt/format.h>

#include <utility>

#include "app/session/findings/contact_findings.h"
#include "app/session/nominal/nominal_mesh.h"
#include "app/session/run/run_result.h"
#include "removal/wire/contact/wire_fixture.h"
#include "removal/wire/falls/fixture_solid.h"

namespace proveout {

Result<WireFixtures> WireFixtures::create(const std::vector<FixtureSpec>& specs) {
  WireFixtures out;
  for (const FixtureSpec& spec : specs) {
    const auto inFixture = [&](const Error& error) {
      return Error{error.kind, fmt::format("fixture '{}': {}", spec.name, error.message)};
    };
    const Result<LoadedSolid> solid = loadSolid(spec.shape);
    if (!solid) return inFixture(solid.error());
    for (const std::string& repair : solid->repairs)
      out.repairs_.push_back(fmt::format("fixture '{}': {}", spec.name, repair));
    out.solids_.push_back({spec.name, solidOf(solid->shape)});
  }
  return out;
}

void WireFixtures::hold(const Box3& blank, PieceOptions& options) const {
  const Box3 near = blank.inflated(kHeldWithinMm);
  for (const Solid& solid : solids_) {
    for (std::vector<Vec2>& polygon : footprintOf(solid.surface, near.min.z(), near.max.z())) {
      Box3 box;
      for (const Vec2& p : polygon) box.extend(Vec3(p.x(), p.y(), near.min.z()));
      if (box.overlaps(near)) options.held_at.push_back(std::move(polygon));
    }
  }
}

Status WireFixtures::addContacts(const SetupRun& setup, const RecordingSource& texts,
                                 std::vector<Finding>& findings, Progress& progress) {
  const Toolpath& path = setup.interpreted.path;
  for (const Solid& solid : solids_) {
    const std::vector<Contact> touched = WireFixture(solid.surface).touches(path, setup.job.tools, progress);
    if (progress.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted"};
    addFixtureContacts(touched, solid.name, setup.job.simulation.contact_mm, path, texts, findings);
  }
  return Done{};
}

}  // namespace proveout
