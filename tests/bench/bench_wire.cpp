// Time of a wire's sections alone: closed contours of 20,000 short motions, upright and with taper, and the
// mesh of what is left.
#include <benchmark/benchmark.h>

#include <cmath>

#include "removal/wire/lean/lean_solid.h"
#include "removal/wire/section/kerf_section.h"
#include "removal/wire/section/prism_mesh.h"

namespace proveout {
namespace {

constexpr int kMotions = 20000;
constexpr double kKerf = 0.15;

/// A wavy circle; `rounded`: to micrometres, as in programs.
std::vector<WireStretch> contour(double radius, int waves, bool rounded) {
  std::vector<Vec2> corners;
  for (int i = 0; i < kMotions; ++i) {
    const double angle = 2 * kPi * i / kMotions, r = radius * (1 + 0.05 * std::sin(waves * angle));
    Vec2 p(r * std::cos(angle), r * std::sin(angle));
    if (rounded) p = Vec2(std::round(1e3 * p.x()) / 1e3, std::round(1e3 * p.y()) / 1e3);
    if (corners.empty() || p != corners.back()) corners.push_back(p);
  }
  std::vector<WireStretch> way(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    way[i].from = corners[i];
    way[i].to = corners[(i + 1) % corners.size()];
    way[i].kerf_mm = kKerf;
    way[i].motion = static_cast<MotionId>(i);
  }
  return way;
}

std::vector<PlaneLoop> plate() { return {rectangleLoop({-60, -60}, {60, 60})}; }

void section(benchmark::State& state, double radius, int waves, bool rounded) {
  const std::vector<WireStretch> way = contour(radius, waves, rounded);
  for (auto _ : state) benchmark::DoNotOptimize(cutSection(plate(), way));
  state.counters["motions"] = static_cast<double>(way.size());
}

void mesh(benchmark::State& state) {
  const std::vector<PlaneBody> bodies = cutSection(plate(), contour(50, 200, false));
  std::size_t triangles = 0;
  for (auto _ : state) triangles = prismMesh(bodies, 0.0, 20.0, 1e-3).triangles.size();
  state.counters["triangles"] = static_cast<double>(triangles);
}

/// With 2 degrees of taper in a plate of 60 mm: every height has another contour.
void taper(benchmark::State& state, double radius, int waves, bool rounded) {
  constexpr HeightSpan kSpan{0.0, 60.0};
  const std::vector<WireStretch> low = contour(radius, waves, rounded);
  const double out = kSpan.high * std::tan(2.0 * kPi / 180.0);
  const auto above = [&](const Vec2& p) { return Vec2(p * (1.0 + out / p.norm())); };
  std::size_t triangles = 0, levels = 0;
  for (auto _ : state) {
    std::vector<LeanStretch> way;
    for (const WireStretch& s : low) {
      WireSweep sweep{kSpan.low, kSpan.high, {}, {}};
      sweep.lower.from = s.from;
      sweep.lower.to = s.to;
      sweep.upper.from = above(s.from);
      sweep.upper.to = above(s.to);
      addLeanStretches(sweep, kSpan, kKerf, 5e-4, s.motion, way);
    }
    Progress progress;
    const Result<LeanSolid> solid = leanSolid(plate(), kSpan, way, 5e-4, progress);
    if (!solid) return state.SkipWithError(solid.error().message.c_str());
    levels = solid->levels.size();
    triangles = 0;
    for (const LeanBody& body : solid->bodies) triangles += body.mesh.triangles.size();
  }
  state.counters["levels"] = static_cast<double>(levels);
  state.counters["triangles"] = static_cast<double>(triangles);
}

BENCHMARK_CAPTURE(taper, steps_of_15_micrometres, 50, 12, false)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(taper, narrow_waves, 50, 200, false)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(taper, rough_steps_of_5_micrometres, 16, 12, true)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(section, steps_of_15_micrometres, 50, 12, false)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(section, narrow_waves, 50, 200, false)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(section, rough_steps_of_5_micrometres, 16, 12, true)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(mesh)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace proveout

BENCHMARK_MAIN();
