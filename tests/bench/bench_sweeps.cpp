// Rate of the distance kernels: samples a second on one core, in columns of nine as the leaf engine asks for
// them.
#include <benchmark/benchmark.h>

#include <array>

#include "core/tool/tool_solid.h"
#include "removal/sweep/sweep.h"

namespace proveout {
namespace {

void run(benchmark::State& state, const char* tool, const Vec3& to, const ArcGeometry* arc) {
  const ToolSolid solid = makeToolSolid(parseToolOption(tool).value());
  const Sweep sweep(solid.cutter.front(), {0, 0, -2}, to, arc);
  std::array<double, 9> cutoff, out;
  cutoff.fill(0.5);
  std::int64_t samples = 0;
  for (auto _ : state) {
    for (int x = 0; x < 9; ++x) {
      for (int y = 0; y < 9; ++y)
        sweep.column(1.0 + 0.25 * x, 1.5 + 0.25 * y, -3.0, 0.25, 9, cutoff.data(), out.data());
    }
    benchmark::DoNotOptimize(out);
    samples += 729;
  }
  state.SetItemsProcessed(samples);
}

const ArcGeometry kArc{{0, 5, -2}, {0, 0, 1}, 2.0};

BENCHMARK_CAPTURE(run, ball_level, "1=ball:6", Vec3(5, 1, -2), nullptr);
BENCHMARK_CAPTURE(run, ball_slanted, "1=ball:6", Vec3(5, 1, -3), nullptr);
BENCHMARK_CAPTURE(run, flat_slanted, "1=flat:6", Vec3(5, 1, -3), nullptr);
BENCHMARK_CAPTURE(run, bull_slanted, "1=bull:6:1", Vec3(5, 1, -3), nullptr);
BENCHMARK_CAPTURE(run, flat_level_arc, "1=flat:6", Vec3(4.546487, 7.080734, -2), &kArc);
BENCHMARK_CAPTURE(run, flat_helix, "1=flat:6", Vec3(4.546487, 7.080734, -3), &kArc);

// Tools without a level bottom or top, on curves whose turns pass near every point.
const ArcGeometry kTurns{{0, 5, -2}, {0, 0, 1}, 126.0};
BENCHMARK_CAPTURE(run, cone_helix_20_turns, "1=cone:6:0:60", Vec3(1.649954, 0.280079, -12), &kTurns);
BENCHMARK_CAPTURE(run, ball_helix_20_turns, "1=ball:6", Vec3(1.649954, 0.280079, -12), &kTurns);

}  // namespace
}  // namespace proveout

BENCHMARK_MAIN();
