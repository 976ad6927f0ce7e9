// Short ways to make turned parts in tests.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

#include "core/mesh/intersections.h"
#include "removal/grid/stock.h"
#include "removal/turning/section/section.h"
#include "removal/turning/threads/thread_mesh.h"
#include "removal/turning/turned_field.h"

namespace proveout::test {

/// One body; each edge is a motion of its own unless `one_motion`.
inline SectionBody body(const std::vector<Vec2>& points, bool one_motion = false) {
  SectionLoop loop;
  loop.points = points;
  for (std::size_t i = 0; i < points.size(); ++i)
    loop.motion.push_back(one_motion ? 7u : static_cast<MotionId>(i));
  SectionBody b;
  b.loops.push_back(loop);
  return b;
}

inline std::shared_ptr<TurnedShape> shapeOf(std::vector<SectionBody> bodies) {
  auto shape = std::make_shared<TurnedShape>();
  shape->bodies = std::move(bodies);
  return shape;
}

struct Made {
  StockSurface surface;
  double initial = 0.0;
};

/// Builds the part and its surface; fails the test unless that is a closed 2-manifold that does not meet
/// itself.
inline Made make(const std::shared_ptr<const TurnedShape>& shape, double resolution, int threads = 2) {
  Made made;
  RemovalOptions options;
  options.resolution_mm = resolution;
  options.threads = threads;
  Progress progress;
  auto stock = Stock::create(turnedStock(shape), options, progress);
  EXPECT_TRUE(stock.ok()) << stock.error().message;
  if (!stock) return made;
  SurfaceOptions fine;
  fine.simplify_mm = 0.0;
  fine.threads = threads;
  auto surface = stock->surface(fine, progress);
  EXPECT_TRUE(surface.ok()) << surface.error().message;
  if (!surface) return made;
  made.surface = std::move(*surface);
  made.initial = stock->initialVolume();
  EXPECT_TRUE(analyseTopology(made.surface.mesh).closedManifold());
  EXPECT_EQ(made.surface.self_intersections, 0u);
  return made;
}

/// The same from the half sections, with facets within `tolerance` mm.
inline Made makeFromSlices(const std::shared_ptr<const TurnedShape>& shape, double tolerance) {
  Made made;
  auto surface = threadedSurface(shape->bodies.front(), shape->threads, tolerance, Progress());
  EXPECT_TRUE(surface.has_value());
  if (!surface) return made;
  made.surface.mesh = std::move(surface->mesh);
  made.surface.volume_mm3 = made.initial = surface->volume_mm3;
  EXPECT_TRUE(analyseTopology(made.surface.mesh).closedManifold());
  const std::vector<std::uint8_t> all(made.surface.mesh.positions.size(), 1);
  EXPECT_EQ(findIntersections(made.surface.mesh, all).size(), 0u);
  return made;
}

}  // namespace proveout::test
