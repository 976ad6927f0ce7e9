#include "app/session/run/blank.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "app/session/nominal/nominal_mesh.h"
#include "app/session/run/job_defaults.h"

namespace proveout {
namespace {

/// So many cells a blank must be thick: a thinner one falls between the grid's points and is lost.
constexpr double kLeastCells = 2.0;

/// The thinnest extent of a blank, mm: a side of its bounds, or a tube's wall.
double thinnest(const StockShape& shape, const Box3& bounds) {
  double extent = bounds.size().minCoeff();
  if (const auto* cylinder = std::get_if<CylinderShape>(&shape))
    extent =
        std::min(extent, cylinder->inner_radius > 0 ? cylinder->radius - cylinder->inner_radius : extent);
  return extent;
}

bool strictlyInside(const Box3& box, const Vec3& p) {
  return (p.array() > box.min.array()).all() && (p.array() < box.max.array()).all();
}

bool inside(const StockShape& shape, const Vec3& p) {
  if (const auto* box = std::get_if<BoxShape>(&shape)) return strictlyInside({box->min, box->max}, p);
  if (const auto* cylinder = std::get_if<CylinderShape>(&shape)) {
    Vec3 radial = p - cylinder->base;
    const double height = radial[cylinder->axis];
    radial[cylinder->axis] = 0;
    const double r = radial.norm();
    return height > 0 && height < cylinder->length && r < cylinder->radius && r >= cylinder->inner_radius;
  }
  return false;
}

}  // namespace

RemovalOptions removalOptions(const Job& job, double resolution_mm) {
  RemovalOptions options;
  options.resolution_mm = resolution_mm;
  options.threads = job.simulation.threads;
  options.max_memory_gb = job.simulation.max_memory_gb;
  return options;
}

Result<Blank> openBlank(const Job& job, Progress& progress) {
  Result<LoadedSolid> solid = loadSolid(*job.stock);
  if (!solid) return solid.error();
  Blank blank;
  blank.shape = std::move(solid->shape);
  blank.repairs = std::move(solid->repairs);
  blank.bounds = shapeBounds(blank.shape);
  blank.start_holes = job.start_holes;
  if (std::holds_alternative<SavedStock>(blank.shape)) {
    if (job.simulation.resolution_mm) {
      return inputError("a saved stock has its own grid: leave the resolution away");
    }
    Result<Stock> stock =
        Stock::create(blank.shape, removalOptions(job, RemovalOptions{}.resolution_mm), progress);
    if (!stock) return stock.error();
    blank.bounds = stock->bounds();
    blank.resolution_mm = stock->resolution();
    blank.stock = std::move(*stock);
    return blank;
  }
  const double thin = thinnest(blank.shape, blank.bounds);
  // A flat mesh is no solid and is refused as such by the stock.
  const double most = thin > 0 ? thin / kLeastCells : std::numeric_limits<double>::infinity();
  blank.resolution_mm =
      job.simulation.resolution_mm.value_or(std::min(defaultResolution(blank.bounds), most));
  if (blank.resolution_mm > most) {
    return inputError(
        fmt::format("a grid of {:g} mm is too coarse for a blank that is {:g} mm thin; take a "
                    "resolution of {:.3g} mm or less",
                    blank.resolution_mm, thin, most * 0.99));
  }
  return blank;
}

Result<Stock> takeStock(Blank& blank, const Job& job, Progress& progress) {
  if (blank.stock) return std::move(*blank.stock);
  return Stock::create(blank.shape, removalOptions(job, blank.resolution_mm), progress);
}

Box3 movedBounds(const Job& job, Box3 bounds, std::size_t moves) {
  for (std::size_t k = 1; k <= moves; ++k) bounds = job.setups[k].from_previous(bounds);
  return bounds;
}

Status checkThickness(const StockShape& shape, double resolution_mm) {
  const double thin = thinnest(shape, shapeBounds(shape));
  if (!(thin > 0) || resolution_mm <= thin / kLeastCells) return Done{};
  return inputError(
      fmt::format("a grid of {:g} mm is too coarse for what is {:g} mm thin; take a resolution of {:.3g} mm "
                  "or less",
                  resolution_mm, thin, thin / kLeastCells * 0.99));
}

Status checkStart(const Job& job, const Blank& blank) {
  std::vector<std::optional<Vec3>> starts{job.start};
  for (const ChannelSpec& channel : job.channels) starts.push_back(channel.start);
  for (const std::optional<Vec3>& start : starts) {
    if (!start || !inside(blank.shape, *start)) continue;
    return inputError(fmt::format("the start point X{:g} Y{:g} Z{:g} lies inside the blank", start->x(),
                                  start->y(), start->z()));
  }
  return Done{};
}

}  // namespace proveout
