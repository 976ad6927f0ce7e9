#include "app/session/machining/grid_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "app/session/findings/uncertainty.h"
#include "app/session/run/job_defaults.h"
#include "app/session/run/process.h"

namespace proveout {
namespace {

/// Cells to the width of a tool: its slots and corners are held by several samples.
constexpr double kCellsToATool = 5.0;
/// Samples to the lead of a thread.
constexpr double kSamplesToALead = 5.0;
/// Facets may leave a round wall by this share of the tolerance.
constexpr double kChordShare = 0.5;
/// Shares of the memory and seconds that nobody was asked for.
constexpr double kMemoryShare = 0.5, kMostSeconds = 30.0;
/// The finest that is chosen, as a share of what the blank asks for.
constexpr double kFinest = 0.1;

/// The next finer of 1, 2, 5 times powers of ten.
double finerStep(double h) {
  const double decade = std::pow(10.0, std::floor(std::log10(h) + 1e-9)), digit = h / decade;
  if (digit > 4.9) return 2.0 * decade;
  return digit > 1.9 ? decade : 0.5 * decade;
}

/// What tools and tolerance ask for, mm.
double wantedSpacing(const Job& job, const RunResult& run) {
  const double chord = kChordShare * std::min(job.nominal->gouge_mm, job.nominal->excess_mm);
  double wanted = std::numeric_limits<double>::infinity();
  for (const SetupRun& setup : run.setups) {
    if (!processOf(setup.job.control).on_grid) continue;
    std::set<int> used;
    for (const Motion& m : setup.interpreted.path.motions) {
      if (m.kind == MotionKind::kFeed || m.kind == MotionKind::kThread) used.insert(m.tool);
    }
    for (const Tool& tool : setup.job.tools) {
      if (!used.contains(tool.number)) continue;
      wanted = std::min(wanted, tool.diameter / kCellsToATool);
      if (chord > 0.0) wanted = std::min(wanted, std::sqrt(8.0 * chord * smallestRadius(tool)));
    }
  }
  return wanted;
}

}  // namespace

bool choosesGrid(const Job& job, const Blank& blank) {
  return job.nominal && !job.simulation.resolution_mm && needsGrid(job) &&
         !std::holds_alternative<SavedStock>(blank.shape);
}

double chooseResolution(const Job& job, const RunResult& run, const Blank& blank, const Workload& work,
                        double memory_mb) {
  const double wanted = wantedSpacing(job, run);
  double h = blank.resolution_mm;
  const double finest = kFinest * h;
  while (h > wanted) {
    const double next = finerStep(h);
    const Prediction p = predict(work, next);
    if (next < 0.999 * finest || p.memory_mb > kMemoryShare * memory_mb || p.time_s > kMostSeconds) break;
    h = next;
  }
  return h;
}

double threadResolution(const RunResult& run, double h) {
  double lead = std::numeric_limits<double>::infinity();
  for (const SetupRun& setup : run.setups) {
    const Toolpath& path = setup.interpreted.path;
    for (const Motion& m : path.motions) {
      if (m.kind == MotionKind::kThread) lead = std::min(lead, (m.to - m.from).norm() / threadTurns(path, m));
    }
  }
  const double finest = kFinest * h * (1.0 + 1e-9);
  while (h > finest && lead < kSamplesToALead * h) h = finerStep(h);
  return h;
}

}  // namespace proveout
