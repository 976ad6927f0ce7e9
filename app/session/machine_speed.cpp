#include "app/session/machine_speed.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/stopwatch.h"
#include "removal/grid/stock.h"

namespace proveout {
namespace {

/// Of the piece of milling, on the two cores on which the prediction was measured.
constexpr double kReferenceS = 1.30e-3;
/// The first pieces find cold caches and load the program's pages, and others may use the machine: the
/// fastest of these counts. More of them where so long a run is expected that they do not show.
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

/// Seconds that it takes on one thread; infinite where it cannot be cut.
double pieceS(const Toolpath& path, const std::vector<Tool>& tools) {
  Progress progress;
  RemovalOptions options;
  options.resolution_mm = 0.25;
  options.threads = 1;
  SurfaceOptions meshing;
  meshing.threads = 1;
  Stopwatch watch;
  Result<Stock> stock = Stock::create(BoxShape{{0, 0, -5}, {6, 6, 0}}, options, progress);
  const bool done =
      stock && stock->remove(path, tools, options, progress) && stock->volume(meshing, progress);
  return done ? watch.lap() : std::numeric_limits<double>::infinity();
}

}  // namespace

double machineSlowness(double expected_s) {
  Tool ball;
  ball.number = 1;
  ball.type = ToolType::kBall;
  ball.diameter = 3.0;
  const Toolpath path = smallPath();
  const std::vector<Tool> tools = {ball};
  double least = std::numeric_limits<double>::infinity(), spent = 0.0;
  for (int i = 0; i < kFewest || (i < kMost && spent < kShare * expected_s); ++i) {
    const double piece = pieceS(path, tools);
    least = std::min(least, piece);
    spent += piece;
  }
  return std::isfinite(least) ? least / kReferenceS : 1.0;
}

}  // namespace proveout
