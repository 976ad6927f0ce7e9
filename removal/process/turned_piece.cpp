#include "removal/process/turned_piece.h"

#include <algorithm>
#include <numeric>

#include "core/base/stopwatch.h"
#include "removal/process/turned_part.h"
#include "removal/process/wire_grid_piece.h"
#include "removal/turning/section/revolve.h"
#include "removal/turning/threads/thread_mesh.h"
#include "removal/turning/turned_field.h"

namespace proveout {
namespace {

StockBody bodyOf(const SectionBody& section, const char* role) {
  StockBody body;
  body.volume_mm3 = section.volume_mm3;
  body.role = role;
  for (const Vec2& p : section.loops.front().points) {
    body.bounds.extend(Vec3(-p.x(), -p.x(), p.y()));
    body.bounds.extend(Vec3(p.x(), p.x(), p.y()));
  }
  return body;
}

/// Whether a thread comes to the heights and radii of the first body.
bool threadReaches(const TurnedShape& shape) {
  const StockBody body = bodyOf(shape.bodies.front(), "");
  return std::any_of(shape.threads.begin(), shape.threads.end(), [&](const ThreadSweep& thread) {
    const Vec2 low = thread.from.cwiseMin(thread.to) + thread.outline->min(),
               high = thread.from.cwiseMax(thread.to) + thread.outline->max();
    return low.y() < body.bounds.max.z() && high.y() > body.bounds.min.z() && low.x() < body.bounds.max.x();
  });
}

/// Of the sections alone; the same, bit for bit, for the same bodies in any order.
double sectionVolume(const TurnedShape& shape) {
  std::vector<double> volumes;
  for (const SectionBody& body : shape.bodies) volumes.push_back(body.volume_mm3);
  std::sort(volumes.begin(), volumes.end());
  return std::accumulate(volumes.begin(), volumes.end(), 0.0);
}

/// The body alone, with all threads.
TurnedShape alone(const TurnedShape& all, std::size_t body) {
  TurnedShape one = all;
  one.bodies = {all.bodies[body]};
  return one;
}

/// The bodies of the shape, the part first, with their threads.
std::vector<StockBody> bodiesOf(const TurnedShape& all, double part_mm3) {
  std::vector<StockBody> bodies;
  for (const SectionBody& body : all.bodies) bodies.push_back(bodyOf(body, "loose"));
  bodies.front().role = "part";
  bodies.front().volume_mm3 = part_mm3;
  for (std::size_t k = 1; k < all.bodies.size(); ++k) {
    const TurnedShape piece = alone(all, k);
    if (!threadReaches(piece)) continue;
    bodies[k].volume_mm3 = threadedVolume(piece.bodies.front(), piece.threads);
  }
  return bodies;
}

/// What is left of a clamping's stock, mm3. Sections that nothing was taken from are the same to the last
/// digit; sums and moves of them are not, and neither are means over the angle where there are threads.
double volumeLeft(const Machined& made, const TurnedShape& shape, const RemovalSummary& removal,
                  double held_mm3) {
  if (made.bodies->empty()) return 0.0;
  const double taken_mm3 = held_mm3 - sectionVolume(shape);
  if (shape.threads.empty()) return made.initial_mm3 - taken_mm3;
  const bool nothing = taken_mm3 == 0.0 && std::all_of(removal.removed_mm3.begin(), removal.removed_mm3.end(),
                                                       [](float removed) { return removed == 0.0f; });
  if (nothing) return made.initial_mm3;
  double sum = 0.0;
  for (const StockBody& body : *made.bodies) sum += body.volume_mm3;
  return std::min(sum, made.initial_mm3);
}

}  // namespace

TurnedPiece::TurnedPiece(TurnedStock stock) : stock_(std::move(stock)), left_mm3_(stock_.initialVolume()) {}

Status TurnedPiece::makeGrid(const TurnedShape& part, const PieceOptions& options, Progress& progress) {
  const StockShape shape = turnedStock(std::make_shared<const TurnedShape>(part));
  Result<Stock> stock = Stock::create(shape, options.grid, progress);
  if (!stock) return stock.error();
  grid_ = std::move(*stock);
  return Done{};
}

/// The surface of a part with threads: from its half sections, or where those do not go over into each other
/// from the grid.
Status TurnedPiece::threadSurface(const TurnedShape& part, const PieceOptions& options, Machined& out,
                                  Progress& progress) {
  if (auto surface = threadedSurface(part.bodies.front(), part.threads, 0.5 * out.facet_error_mm, progress)) {
    out.surface.mesh = std::move(surface->mesh);
    out.surface.volume_mm3 = surface->volume_mm3;
    out.facet_error_mm = surface->deviation_mm;
    return Done{};
  }
  if (progress.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted"};
  if (options.grid_fits) {
    if (Status enough = options.grid_fits(); !enough) return enough;
  }
  if (Status done = makeGrid(part, options, progress); !done) return done;
  Result<StockSurface> surface = grid_->surface(options.surface, progress);
  if (!surface) return surface.error();
  out.surface = std::move(*surface);
  out.facet_error_mm = 0.0;
  return Done{};
}

/// Fills the surface and the bodies from what is left; the part comes first.
Status TurnedPiece::takePart(const PieceOptions& options, Machined& out, Progress& progress) {
  TurnedShape all = stock_.shape();
  out.facet_error_mm = 2.0 * options.facet_mm;
  out.bodies.emplace();
  if (!all.bodies.empty()) {
    const Result<PartChoice> chosen = partAmong(all.bodies, options);
    if (!chosen) return chosen.error();
    std::swap(all.bodies[0], all.bodies[chosen->body]);
    if (chosen->rival) out.rival = *chosen->rival == 0 ? chosen->body : *chosen->rival;
    const TurnedShape part = alone(all, 0);
    if (part.threads.empty()) {
      out.surface.mesh = revolved(part.bodies, options.facet_mm);
      out.surface.volume_mm3 = part.bodies.front().volume_mm3;
    } else if (Status done = threadSurface(part, options, out, progress); !done) {
      return done;
    }
    if (options.keeps_grid && !grid_) {
      if (Status done = makeGrid(part, options, progress); !done) return done;
    }
    out.bodies = bodiesOf(all, out.surface.volume_mm3);
  }
  made_ = std::make_shared<const TurnedForm>(std::move(all));
  out.form = made_;
  return Done{};
}

Result<Machined> TurnedPiece::machine(const Toolpath& path, const std::vector<Tool>& tools,
                                      const PieceOptions& options, Progress& progress) {
  Stopwatch watch;
  const double held_mm3 = sectionVolume(stock_.shape());
  Result<RemovalSummary> removal = stock_.remove(path, tools, progress);
  if (!removal) return removal.error();
  Machined out;
  out.remove_s = watch.lap();
  if (Status done = takePart(options, out, progress); !done) return done.error();
  out.mesh_s = watch.lap();
  if (!out.bodies->empty()) part_mm3_ = out.bodies->front().volume_mm3;
  out.bodies->insert(out.bodies->end(), apart_.begin(), apart_.end());
  out.initial_mm3 = left_mm3_;
  out.surface.volume_mm3 = volumeLeft(out, made_->shape(), *removal, held_mm3);
  fitRemovedVolume(*removal, out.initial_mm3 - out.surface.volume_mm3);
  out.removal = std::move(*removal);
  left_mm3_ = out.surface.volume_mm3;
  if (!out.bodies->empty()) apart_.assign(out.bodies->begin() + 1, out.bodies->end());
  return out;
}

Status TurnedPiece::cut(const Toolpath& path, const std::vector<Tool>& tools, const PieceOptions& options,
                        Progress& progress) {
  const Result<Machined> made = machine(path, tools, options, progress);
  return made ? Status(Done{}) : Status(made.error());
}

Result<std::unique_ptr<Workpiece>> TurnedPiece::become(ProcessKind next, const RigidTransform& move,
                                                       const PieceOptions& options, Progress& progress) {
  if (made_ == nullptr || made_->shape().bodies.empty()) return inputError("nothing is left to be clamped");
  for (StockBody& body : apart_) body.bounds = move(body.bounds);
  if (next == ProcessKind::kTurning) {
    Result<TurnedStock> moved = stock_.moved(made_->shape().bodies.front(), move);
    if (!moved) return moved.error();
    auto piece = std::make_unique<TurnedPiece>(std::move(*moved));
    piece->left_mm3_ = left_mm3_;
    piece->apart_ = std::move(apart_);
    return std::unique_ptr<Workpiece>(std::move(piece));
  }
  const StockShape shape = turnedStock(std::make_shared<const TurnedShape>(alone(made_->shape(), 0)), move);
  Result<Stock> stock = Stock::create(shape, options.grid, progress);
  if (!stock) return stock.error();
  return pieceOnGrid(next, std::move(*stock), left_mm3_, part_mm3_, std::move(apart_));
}

}  // namespace proveout
