// From program to surface: wall time, peak memory, triangles and volume error, one line a case. Each case
// runs in a process of its own, so that its peak memory is its own.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/nc/interpreter.h"
#include "io/program_files.h"
#include "removal/stock.h"

namespace proveout {
namespace {

struct Case {
  std::string name;
  std::function<Toolpath()> path;
  BoxShape stock;
  std::string tool;
  double grid;
  std::optional<double> exact_mm3;  ///< of the part
};

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Toolpath readProgram(const std::string& file) {
  Toolpath path;
  ToolpathBuilder builder(path);
  const FileProgramSource source(PROVEOUT_SHARED_PROGRAMS "/" + file);
  interpret(ControlId::kNct, source, ControlSettings{}, builder);
  return path;
}

Toolpath slot() {
  Toolpath path;
  path.files = {"slot"};
  Motion m;
  m.from = {0, 25, -5};
  m.to = {100, 25, -5};
  m.kind = MotionKind::kFeed;
  m.spindle = 1000;
  path.motions.push_back(m);
  return path;
}

void print(const Case& c) {
  const double start = now();
  Toolpath path = c.path();
  for (Motion& m : path.motions) m.tool = 1;
  const double interpreted = now();
  RemovalOptions options;
  options.resolution_mm = c.grid;
  Progress progress;
  auto stock = Stock::create(c.stock, options, progress);
  if (!stock) return void(std::printf("%-28s %s\n", c.name.c_str(), stock.error().message.c_str()));
  const auto summary = stock->remove(path, {parseToolOption(c.tool).value()}, options, progress);
  const double removed = now();
  if (!summary) return void(std::printf("%-28s %s\n", c.name.c_str(), summary.error().message.c_str()));
  const auto surface = stock->surface(0, progress);
  const double end = now();
  if (!surface) return void(std::printf("%-28s %s\n", c.name.c_str(), surface.error().message.c_str()));
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf("%-28s %5.2f %8zu %8.2f %8.2f %8.2f %8.2f %8.0f %9zu %12.3f", c.name.c_str(), c.grid,
              path.motions.size(), interpreted - start, removed - interpreted, end - removed, end - start,
              usage.ru_maxrss / 1024.0, surface->mesh.triangles.size(), surface->volume_mm3);
  if (c.exact_mm3) std::printf(" %9.1e", surface->volume_mm3 / *c.exact_mm3 - 1);
  std::printf("\n");
}

void runApart(const Case& c) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    print(c);
    std::fflush(stdout);
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (!WIFEXITED(status)) std::printf("%-28s ended by signal %d\n", c.name.c_str(), WTERMSIG(status));
}

}  // namespace
}  // namespace proveout

int main() {
  using namespace proveout;
  const BoxShape bear{{0, 0, -20}, {80, 80, 0}},
      flower{{-3.92956, -3.92829, -9.95121}, {61.0796, 61.0529, 0}}, diamond{{-60, -60, -10}, {60, 60, 0}},
      block{{0, 0, -20}, {100, 50, 0}};
  std::vector<Case> cases;
  for (const double grid : {0.25, 0.1})
    cases.push_back({"slot 10x5 in 100x50x20", slot, block, "1=flat:10", grid, 95000.0});
  if (access(PROVEOUT_SHARED_PROGRAMS "/bear.nc", R_OK) == 0) {
    for (const double grid : {0.5, 0.25, 0.1}) {
      cases.push_back({"bear.nc", [] { return readProgram("bear.nc"); }, bear, "1=ball:3.175", grid, {}});
    }
    cases.push_back(
        {"flower_mold.nc", [] { return readProgram("flower_mold.nc"); }, flower, "1=flat:1", 0.25, {}});
    cases.push_back({"circle_diamond_square",
                     [] { return readProgram("circle_diamond_square.gcode"); },
                     diamond,
                     "1=flat:3",
                     0.25,
                     {}});
  } else {
    std::printf("real programs are not beside this checkout: their cases are left out\n");
  }
  std::printf("%-28s %5s %8s %8s %8s %8s %8s %8s %9s %12s %9s\n", "case", "grid", "motions", "read s",
              "cut s", "mesh s", "all s", "peak MB", "triangles", "part mm3", "error");
  for (const Case& c : cases) runApart(c);
  return 0;
}
