#include "app/session/forecast/run_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/memory.h"

namespace proveout {
namespace {

/// Rounded up to two digits, so that it fits as it is printed.
std::string resolutionText(double mm) {
  const double digit = std::pow(10.0, std::floor(std::log10(mm)) - 1.0);
  return fmt::format("{:.2g}", std::ceil(mm / digit - 1e-9) * digit);
}

/// What the job allows, or a limit of the process that is below it; else what there is.
MemoryBound boundOf(const Job& job) {
  if (job.simulation.max_memory_gb <= 0.0) return memoryBound();
  const MemoryBound process = processMemoryBound();
  const double allowed = 1e9 * job.simulation.max_memory_gb;
  return process.bytes < allowed ? process : MemoryBound{allowed, {}};
}

/// What to do, behind "or": the limit that was met, by its name.
std::string allowMore(const Job& job) {
  const std::string reason = boundOf(job).reason;
  return reason.empty() ? "allow more (--max-memory)" : "allow more: " + reason;
}

}  // namespace

double memoryLimitMb(const Job& job) { return 1e-6 * boundOf(job).bytes; }

Status checkMemory(const Job& job, const Workload& work, double resolution_mm) {
  const double limit_mb = memoryLimitMb(job);
  const double needed_mb = predict(work, resolution_mm).memory_mb;
  if (needed_mb <= limit_mb) return Done{};
  if (!(work.surface_mm2 > 0.0)) {
    return Error{
        ErrorKind::kResourceLimit,
        fmt::format("{} would need about {:.0f} MB, {:.0f} MB are allowed; {}{}",
                    work.triangles > 0.0 ? "the mesh" : "the tool path", needed_mb, limit_mb,
                    work.triangles > 0.0 ? "take a larger profile_resolution, or " : "", allowMore(job))};
  }
  const double fits = resolutionThatFits(work, resolution_mm, limit_mb);
  const std::string way = std::isfinite(fits)
                              ? fmt::format("a grid of {} mm would fit (--resolution)", resolutionText(fits))
                              : std::string("no grid would fit");
  return Error{ErrorKind::kResourceLimit,
               fmt::format("a grid of {:g} mm would need about {:.0f} MB, {:.0f} MB are allowed; {}, or {}",
                           resolution_mm, needed_mb, limit_mb, way, allowMore(job))};
}

Status checkTime(const Job& job, const Prediction& prediction) {
  constexpr double kDoubt = 2.0;
  const double allowed_s = job.simulation.max_time_s;
  if (allowed_s <= 0.0 || prediction.time_s <= kDoubt * allowed_s) return Done{};
  return Error{ErrorKind::kResourceLimit,
               fmt::format("this run would take about {:.0f} s, {:g} s are allowed; take a coarser grid "
                           "(--resolution), or allow more (--max-time, max_time_s)",
                           prediction.time_s, allowed_s)};
}

double simplification(const Job& job, double resolution_mm) {
  if (job.simulation.simplify_mm) return *job.simulation.simplify_mm;
  constexpr double kShare = 0.1;
  double within = resolution_mm;
  if (job.nominal) within = std::min({within, job.nominal->gouge_mm, job.nominal->excess_mm});
  return kShare * within;
}

SurfaceOptions surfaceOptions(const Job& setup, double resolution_mm) {
  SurfaceOptions options;
  options.simplify_mm = simplification(setup, resolution_mm);
  options.threads = setup.simulation.threads;
  return options;
}

}  // namespace proveout
