#include "removal/contact/stock_faces.h"

#include <tbb/task_arena.h>

#include <cmath>
#include <stdexcept>

#include "removal/surface/surface.h"

namespace proveout {
namespace {

/// How far the mesh may leave what the grid has, mm: far below what counts as contact.
constexpr double kMeshMm = 1e-4;
/// On the surface there is no way to it, mm.
constexpr double kOnIt = 1e-9;

}  // namespace

void StockFaces::make() const {
  if (stock_.blank_mesh != nullptr) {
    tree_ = stock_.blank_mesh;
    return;
  }
  SurfaceOptions options;
  options.simplify_mm = kMeshMm;
  Progress progress;
  const Result<StockSurface> surface = extractSurface(stock_, options, progress);
  if (!surface) throw std::runtime_error(surface.error().message);
  tree_ = std::make_shared<const TriangleTree>(toSurface(surface->mesh));
}

StockFaces::Sample StockFaces::at(const Vec3& p) const {
  // Whoever waits here must not take up work that asks for the same.
  std::call_once(made_, [this] { tbb::this_task_arena::isolate([this] { make(); }); });
  const TriangleTree::Nearest nearest = tree_->nearest(p);
  const double distance = std::sqrt(nearest.squared);
  const Vec3 away = p - nearest.point;
  if (distance < kOnIt) return {0.0, Vec3::UnitZ()};
  const bool inside = tree_->goesRound(p);
  return inside ? Sample{-distance, -away / distance} : Sample{distance, away / distance};
}

}  // namespace proveout
