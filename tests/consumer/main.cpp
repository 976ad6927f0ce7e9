// Cuts one slot into a block and prints the volume that is left.
#include <cstdio>

#include "removal/grid/stock.h"

int main() {
  using namespace proveout;
  Progress progress;
  const RemovalOptions options{.resolution_mm = 0.5};
  const BoxShape block{{0, 0, 0}, {20, 20, 10}};
  auto stock = Stock::create(block, options, progress);
  if (!stock) {
    std::fprintf(stderr, "%s\n", stock.error().message.c_str());
    return 2;
  }
  Tool mill;
  mill.number = 1;
  mill.type = ToolType::kFlat;
  mill.diameter = 4.0;
  Toolpath path;
  path.files = {"slot"};
  Motion cut;
  cut.kind = MotionKind::kFeed;
  cut.from = {10, -5, 8};
  cut.to = {10, 25, 8};
  cut.feed = 100;
  cut.spindle = 1000;
  cut.tool = 1;
  ToolpathBuilder(path).motion(cut, nullptr);
  if (const auto removed = stock->remove(path, {mill}, options, progress); !removed) {
    std::fprintf(stderr, "%s\n", removed.error().message.c_str());
    return 2;
  }
  const auto surface = stock->surface(options.threads, progress);
  if (!surface) {
    std::fprintf(stderr, "%s\n", surface.error().message.c_str());
    return 2;
  }
  std::printf("volume %.1f mm3, closed %d\n", meshVolume(surface->mesh),
              analyseTopology(surface->mesh).closedManifold());
  return 0;
}
