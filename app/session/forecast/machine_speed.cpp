#include "app/session/forecast/machine_speed.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <vector>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"
#include "core/base/stopwatch.h"
#include "removal/grid/stock.h"

namespace proveout {
namespace {

/// Of pieces of milling on two threads at a time, on the two cores on which the prediction was measured: as
/// it follows from the 70 jobs of bench_prediction on another machine, where it took 3.7 ms.
constexpr double kReferenceS = 1.67e-3;
/// Of the work that threads share: what one does while the others wait.
constexpr double kSerial = 0.15;
/// The first pieces find cold caches and load the program's pages, and others may use the machine: the
/// fastest round of these counts. More of them where so long a run is expected that they do not show.
constexpr int kFewest = 3, kMost = 12;
constexpr double kShare = 0.015;

/// A ball's rows over hills: slopes, ridges between them, and one round wall.
Toolpath smallPath() {
  Toolpath path;
  const auto go = [&path](const Vec3& from, const Vec3& to) {
    Motion motion;
    motion.kind = MotionKind::kFeed;
    motion.tool = 1;
    motion.spindle = 1000.0;
    motion.from = from;
    motion.to = to;
    path.motions.push_back(motion);
  };
  constexpr double kFar = 7.0, kRow = 1.3;
  Vec3 at(-1.0, 0.7, -1.0);
  for (int row = 0; row < 4; ++row) {
    for (const double z : {-2.0, -0.6, -1.4}) {
      const Vec3 next = at + Vec3((row % 2 == 0 ? 1.0 : -1.0) * kFar / 3.0, 0.1, z - at.z());
      go(at, next);
      at = next;
    }
    at.y() += kRow;
  }
  go({3.0, 3.0, 2.0}, {3.0, 3.0, -3.0});
  return path;
}

/// Processor time of the calling thread, s.
double threadS() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Processor time that the piece takes on the calling thread alone, which does no other work meanwhile; s.
/// Infinite where it cannot be cut.
double pieceS(const Toolpath& path, const std::vector<Tool>& tools) {
  return tbb::task_arena(1).execute([&] {
    Progress progress;
    RemovalOptions options;
    options.resolution_mm = 0.25;
    const double start = threadS();
    Result<Stock> stock = Stock::create(BoxShape{{0, 0, -5}, {6, 6, 0}}, options, progress);
    const bool done = stock && stock->remove(path, tools, options, progress) && stock->volume({}, progress);
    return done ? threadS() - start : kNever;
  });
}

/// The fastest of a piece for each thread, all at a time: threads that share a core or its caches slow each
/// other down, in a run as well. A thread that makes the blank meanwhile is as good as one with a piece.
double roundS(int threads, const Toolpath& path, const std::vector<Tool>& tools) {
  PROVEOUT_ASSERT(threads >= 1);
  std::vector<double> pieces(static_cast<std::size_t>(threads), kNever);
  parallelFor(std::size_t{0}, pieces.size(), [&](std::size_t i) { pieces[i] = pieceS(path, tools); });
  return *std::min_element(pieces.begin(), pieces.end());
}

/// The threads that a run has, of which no more count than there are cores.
int threadsOfRuns() {
  const auto allowed = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  return std::max(1, std::min(static_cast<int>(allowed), tbb::info::default_concurrency()));
}

}  // namespace

MachineSpeed measureMachine(double expected_s) {
  Tool ball;
  ball.number = 1;
  ball.type = ToolType::kBall;
  ball.diameter = 3.0;
  const Toolpath path = smallPath();
  const std::vector<Tool> tools = {ball};
  const int threads = threadsOfRuns();
  double least = kNever, spent = 0.0;
  Stopwatch watch;
  for (int i = 0; i < kFewest || (i < kMost && spent < kShare * expected_s); ++i) {
    least = std::min(least, roundS(threads, path, tools));
    spent += watch.lap();
  }
  return {threads, std::isfinite(least) ? least / kReferenceS : 1.0};
}

Prediction predictedOn(const MachineSpeed& machine, const Prediction& predicted) {
  const auto shared = [](double threads) { return kSerial + (1.0 - kSerial) / threads; };
  const double serial_s = machine.slowness * predicted.serial_s,
               parallel_s = machine.slowness * predicted.time_s - serial_s;
  return {predicted.memory_mb, serial_s + parallel_s * shared(machine.threads) / shared(2.0), serial_s};
}

}  // namespace proveout
