#include "app/session/run/process.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/base/assert.h"
#include "core/nc/control/control_info.h"

namespace proveout {
namespace {

constexpr std::array kProcesses = {&kMillingProcess, &kTurningProcess, &kWireProcess};

/// What a workpiece may become, see Workpiece::become.
bool mayFollow(const Process& before, const Process& next) {
  return next.kind == before.kind || !next.part_turns;
}

/// What only a wire needs of a job: start holes are those of the first clamping's blank.
Status checkThreading(const Job& job) {
  const Process& first = processOf(job, 0);
  if (!job.start_holes.empty() && !first.cuts_through)
    return inputError(
        fmt::format("start holes are for a wire, and control {} {}: leave [[stock.start_hole]] out",
                    jobOfSetup(job, 0).control, first.words.verb));
  return Done{};
}

}  // namespace

const Process& processOf(std::string_view control) {
  const auto& all = controls();
  const auto info =
      std::find_if(all.begin(), all.end(), [&](const ControlInfo& known) { return known.name == control; });
  const ProcessKind kind = info == all.end() ? ProcessKind::kMilling : info->process;
  const auto row = std::find_if(kProcesses.begin(), kProcesses.end(),
                                [&](const Process* process) { return process->kind == kind; });
  PROVEOUT_ASSERT(row != kProcesses.end());
  return **row;
}

const Process& processOf(const Job& job, std::size_t setup) {
  const bool own = setup < job.setups.size() && !job.setups[setup].control.empty();
  return processOf(own ? job.setups[setup].control : job.control);
}

Status checkProcesses(const Job& job, const Blank& blank) {
  if (Status threads = checkThreading(job); !threads) return threads;
  for (std::size_t k = 0; k < setupCount(job); ++k) {
    const Process& process = processOf(job, k);
    if (k > 0 && !mayFollow(processOf(job, k - 1), process))
      return inputError(fmt::format(
          "setup '{}': control {} {}, and what was clamped before cannot go on so: {}", job.setups[k].name,
          jobOfSetup(job, k).control, process.words.verb,
          process.part_turns
              ? "only bars, tubes and what was turned can be turned; give the turned clampings first"
              : "no process goes over to this one"));
    if (Status possible = process.check(job, k, blank); !possible) return possible;
  }
  return Done{};
}

bool needsGrid(const Job& job) {
  for (std::size_t k = 0; k < setupCount(job); ++k) {
    if (processOf(job, k).on_grid || (k > 0 && !processOf(job, k).part_turns)) return true;
  }
  return false;
}

}  // namespace proveout
