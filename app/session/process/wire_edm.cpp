// Wire EDM: its paths are interpreted; material is not removed by a wire yet, so that no clamping runs.
#include <fmt/format.h>

#include "app/session/job_defaults.h"
#include "app/session/process/process.h"

namespace proveout {
namespace {

constexpr const char* kNoWireCut =
    "this version writes and checks the paths of a wire (proveout path, proveout check) and does not remove "
    "material with it yet";

Status check(const Job& job, std::size_t k, const Blank& /*blank*/) {
  return inputError(fmt::format("control {}: {}", jobOfSetup(job, k).control, kNoWireCut));
}

Vec3 start(const Box3& blank) { return defaultStart(blank); }

/// The wire is a matter of the control's settings.
bool holds(const Tool& /*tool*/) { return true; }

std::unique_ptr<PieceProbe> probe(const Job& /*setup*/, const ProbedStock& /*stock*/,
                                  const Toolpath& /*path*/, Progress& /*progress*/) {
  return nullptr;
}

Workload work(const Job& /*job*/, const RunResult& /*run*/, std::size_t /*k*/, const Blank& /*blank*/) {
  return {};
}

Result<std::unique_ptr<Workpiece>> make(Blank& /*blank*/, const Job& /*job*/, Progress& /*progress*/) {
  return inputError(kNoWireCut);
}

Result<std::unique_ptr<Fixtures>> fixtures(const SetupRun& /*setup*/, double /*resolution_mm*/,
                                           Progress& /*progress*/) {
  return inputError(kNoWireCut);
}

}  // namespace

const Process kWireEdmProcess{
    .kind = ProcessKind::kWire,
    .verb = "cuts with a wire",
    .part_turns = false,
    .on_grid = false,
    .always_changes_tool = false,
    .check = check,
    .start = start,
    .holds = holds,
    .probe = probe,
    .work = work,
    .make = make,
    .fixtures = fixtures,
};

}  // namespace proveout
