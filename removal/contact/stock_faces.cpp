#include "removal/contact/stock_faces.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "removal/cut/cut_record.h"
#include "removal/grid/blank_field.h"
#include "removal/grid/earlier_stock.h"
#include "removal/surface/surface.h"

namespace proveout {
namespace {

/// How far the mesh may leave what the grid has, mm: far below what counts as contact.
constexpr double kMeshMm = 1e-4;
/// On the surface there is no way to it, mm.
constexpr double kOnIt = 1e-9;
/// More passes of earlier clamping than this are not kept, some 100 MB.
constexpr std::size_t kMostPasses = 500'000;

StockFaces::Sample meshSample(const TriangleTree& tree, const Vec3& p) {
  const TriangleTree::Nearest nearest = tree.nearest(p);
  const double distance = std::sqrt(nearest.squared);
  const Vec3 away = p - nearest.point;
  if (distance < kOnIt) return {0.0, Vec3::UnitZ()};
  const bool inside = tree.goesRound(p);
  return inside ? StockFaces::Sample{-distance, -away / distance}
                : StockFaces::Sample{distance, away / distance};
}

/// None where a piece fell off.
std::optional<StockFaces::Sample> earlierSample(const EarlierStock& stock, const Vec3& here, double h) {
  const Vec3 p = stock.back(here);
  const auto fell = [&](const Box3& box) { return box.inflated(h).overlaps(Box3{p, p}); };
  if (std::any_of(stock.dropped.begin(), stock.dropped.end(), fell)) return std::nullopt;
  StockFaces::Sample out{};
  if (stock.blank != nullptr) {
    const BlankSample s = stock.blank->sample(p);
    out = {s.value, s.normal};
  } else if (stock.earlier != nullptr) {
    const std::optional<StockFaces::Sample> before = earlierSample(*stock.earlier, p, h);
    if (!before) return std::nullopt;
    out = *before;
  } else {
    out = meshSample(*stock.mesh, p);
  }
  if (stock.cut != nullptr && out.value < 0.0) {
    const CutterIndex::Near cut = stock.cut->cutters().nearest(p, kNoMotion, -out.value);
    if (cut.body != nullptr) out = {-cut.distance, -cut.body->field(stock.cut->table).sample(p).gradient};
  }
  out.gradient = stock.back.rotation.transpose() * out.gradient;
  return out;
}

std::size_t passesOf(const EarlierStock* stock) {
  std::size_t sum = 0;
  for (; stock != nullptr; stock = stock->earlier.get())
    if (stock->cut != nullptr) sum += stock->cut->table.passes.size();
  return sum;
}

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
  if (stock_.earlier != nullptr) {
    if (const auto known = earlierSample(*stock_.earlier, p, stock_.h)) return *known;
  }
  // Whoever waits here must not take up work that asks for the same.
  std::call_once(made_, [this] { tbb::this_task_arena::isolate([this] { make(); }); });
  return meshSample(*tree_, p);
}

void forgetLargeRecords(Stock::Impl& stock) {
  if (passesOf(stock.earlier.get()) > kMostPasses) stock.earlier = nullptr;
}

}  // namespace proveout
