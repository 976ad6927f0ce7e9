// Time of turning alone: the path of the sample shaft cut into its bar, and the mesh of what is left; worms
// of some hundred passes.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <stdexcept>

#include "app/job_setup.h"
#include "app/session/session.h"
#include "removal/turning/section/revolve.h"
#include "removal/turning/threads/thread_mesh.h"
#include "removal/turning/turned_stock.h"
#include "tests/support/worm.h"

namespace proveout {
namespace {

/// The shaft before anything is cut.
const PreparedRun& shaft() {
  static const PreparedRun prepared = [] {
    Diagnostics diagnostics;
    std::optional<Job> job = loadJob(PROVEOUT_PARTS "/wl4_shaft/job.toml", knownJobNames(), diagnostics);
    if (!job) throw std::runtime_error("the sample shaft's job cannot be read");
    const JobSources sources(*job);
    Progress progress;
    Result<PreparedRun> run = prepareRun(*job, sources.all(), progress);
    if (!run) throw std::runtime_error(run.error().message);
    return std::move(*run);
  }();
  return prepared;
}

TurnedStock cut(const Toolpath& path) {
  const SetupRun& setup = shaft().run.setups.front();
  Result<TurnedStock> stock = TurnedStock::create(shaft().blank.shape);
  if (!stock) throw std::runtime_error(stock.error().message);
  Progress progress;
  if (const auto removed = stock->remove(path, setup.job.tools, progress); !removed)
    throw std::runtime_error(removed.error().message);
  return std::move(*stock);
}

Toolpath pathWithoutThread() {
  Toolpath path = shaft().run.setups.front().interpreted.path;
  const auto thread_tool = std::find_if(path.motions.begin(), path.motions.end(),
                                        [](const Motion& m) { return m.kind == MotionKind::kThread; });
  if (thread_tool == path.motions.end()) throw std::runtime_error("the sample shaft has no thread");
  const int number = thread_tool->tool;
  std::erase_if(path.motions, [&](const Motion& m) { return m.tool == number; });
  return path;
}

void remove(benchmark::State& state, bool thread) {
  const Toolpath path = thread ? shaft().run.setups.front().interpreted.path : pathWithoutThread();
  for (auto _ : state) benchmark::DoNotOptimize(cut(path));
  state.counters["motions"] = static_cast<double>(path.motions.size());
}

void revolve(benchmark::State& state, double tolerance_mm) {
  const TurnedShape shape = cut(pathWithoutThread()).shape();
  std::size_t triangles = 0;
  for (auto _ : state) triangles = revolved(shape.bodies, tolerance_mm).triangles.size();
  state.counters["triangles"] = static_cast<double>(triangles);
}

/// From the bar to the mesh: processor time of all threads.
void worm(benchmark::State& state, const test::Worm& worm) {
  const TurningPath path = worm.path();
  std::size_t kept = 0, triangles = 0;
  for (auto _ : state) {
    Result<TurnedStock> stock = TurnedStock::create(bar(worm.bar, 80.0));
    Progress progress;
    if (!stock || !stock->remove(path.path, {worm.tool()}, progress))
      throw std::runtime_error("the worm cannot be cut");
    const TurnedShape shape = stock->shape();
    kept = shape.threads.size();
    const auto surface = threadedSurface(shape.bodies.front(), shape.threads, 1e-3, progress);
    triangles = surface ? surface->mesh.triangles.size() : 0;
  }
  state.counters["passes"] = worm.passes();
  state.counters["kept"] = static_cast<double>(kept);
  state.counters["triangles"] = static_cast<double>(triangles);
}

/// 64 passes a start.
constexpr test::Worm kFourStarts{.layer = 0.3, .step = 0.45};

BENCHMARK_CAPTURE(worm, four_starts, kFourStarts)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(remove, shaft, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(remove, shaft_without_thread, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(revolve, within_1_micrometre, 1e-3)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace proveout

BENCHMARK_MAIN();
