#include "removal/process/milled_piece.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/stopwatch.h"
#include "removal/grid/stock_impl.h"
#include "removal/process/wire_grid_piece.h"

namespace proveout {
namespace {

/// Part of the volume up to which the integral over the grid's crossings is the closed form but for rounding.
constexpr double kSameVolume = 1e-6;

/// What a path took, mm3: by the integrals over one grid before and after it, so that what no tool reached
/// cancels. Where walls share cells these may be off by more than little cuts take, even below 0; then what
/// the columns of the grid count stands. `initial_mm3`: as the report tells it; a move onto another grid may
/// have made more of it than there was, and then what is left is what the grid holds.
double removedVolume(const RemovalSummary& removal, double initial_mm3, double before_mm3, double after_mm3) {
  const double removed_mm3 =
      after_mm3 <= before_mm3 ? before_mm3 - after_mm3 : std::min(countedVolume(removal), before_mm3);
  if (removed_mm3 <= initial_mm3) return removed_mm3;
  return initial_mm3 - std::clamp(after_mm3, 0.0, initial_mm3);
}

/// By how much what a path took may be off, mm3, by the errors of both integrals; faces that no tool reached
/// are as wrong before as after. A cut of less than a cell may lie where no crossing shows it, and its error
/// then neither: integral and columns have met it in places of their own, and differ by what they missed. No
/// crossing shows what the grid loses either.
double removedError(const RemovalSummary& removal, double removed_mm3, double of_integrals_mm3,
                    double cell_mm3) {
  const double told = of_integrals_mm3 + removal.lost_mm3;
  if (removed_mm3 >= cell_mm3) return told;
  return std::max(told, std::abs(removed_mm3 - countedVolume(removal)));
}

/// What an earlier clamping made has numbers of its own path.
void forgetEarlier(const Toolpath& path, TriMesh& mesh) {
  for (MotionId& motion : mesh.motion) {
    if (motion >= path.motions.size()) motion = kNoMotion;
  }
}

}  // namespace

MilledPiece::MilledPiece(Stock stock, bool saved)
    : stock_(std::move(stock)), saved_(saved), own_mm3_(stock_.initialVolume()) {}

MilledPiece::MilledPiece(Stock stock, double left_mm3, double own_mm3, std::vector<StockBody> apart)
    : stock_(std::move(stock)),
      first_(false),
      left_mm3_(left_mm3),
      own_mm3_(own_mm3),
      apart_(std::move(apart)) {}

/// Volume of what a run starts with: what the grid holds of it, as all volumes behind it are integrals over
/// that grid. Where the blank's own volume is the same but for rounding, that.
double MilledPiece::startVolume(double held_mm3) const {
  const bool same = std::abs(held_mm3 - own_mm3_) <= kSameVolume * own_mm3_;
  return same && !saved_ ? own_mm3_ : held_mm3;
}

Result<Machined> MilledPiece::machine(const Toolpath& path, const std::vector<Tool>& tools,
                                      const PieceOptions& options, Progress& progress) {
  Stopwatch watch;
  Machined out;
  const Result<StockVolume> held = stock_.volume(options.surface, progress);
  if (!held) return held.error();
  if (!first_ || !saved_) out.holding = {own_mm3_, held->mm3};
  out.initial_mm3 = first_ ? startVolume(held->mm3) : left_mm3_;
  if (first_ && out.initial_mm3 != own_mm3_) out.initial_error_mm3 = held->error_mm3 + held->edges_mm3;
  Result<RemovalSummary> removal = stock_.remove(path, tools, options.grid, progress);
  if (!removal) return removal.error();
  out.remove_s = watch.lap();
  Result<StockSurface> surface = stock_.surface(options.surface, progress);
  if (!surface) return surface.error();
  out.mesh_s = watch.lap();
  // Else the stock is what it was, and read as it was: the integrals are the same to the last bit.
  const bool changed = stock_.inside().cut != nullptr;
  const double unseen_mm3 = std::exchange(surface->unseen_mm3, 0.0);
  const double removed_mm3 =
      !changed ? 0.0
      : surface->mesh.triangles.empty()
          ? out.initial_mm3 - volumeOf(apart_)  // whatever moves and rounding made of it
          : removedVolume(*removal, out.initial_mm3, held->mm3, surface->volume_mm3 + unseen_mm3);
  surface->volume_mm3 = out.initial_mm3 - removed_mm3;
  surface->volume_error_mm3 =
      changed ? removedError(*removal, removed_mm3, std::abs(surface->volume_error_mm3 - held->error_mm3),
                             std::pow(stock_.resolution(), 3)) +
                    (out.holding ? out.holding->errorOf(removed_mm3) : 0.0)
              : 0.0;
  fitRemovedVolume(*removal, removed_mm3);
  if (!first_) forgetEarlier(path, surface->mesh);
  out.removal = std::move(*removal);
  out.surface = std::move(*surface);
  out.apart = apart_;
  left_mm3_ = out.surface.volume_mm3;
  own_mm3_ = held->mm3 - removed_mm3 - unseen_mm3;  // as crossings show it: the next path knows no other
  return out;
}

Status MilledPiece::cut(const Toolpath& path, const std::vector<Tool>& tools, const PieceOptions& options,
                        Progress& progress) {
  const Result<RemovalSummary> removal = stock_.remove(path, tools, options.grid, progress);
  return removal ? Status(Done{}) : Status(removal.error());
}

void MilledPiece::letFall(const std::vector<StockBody>& bodies) {
  if (bodies.size() < 2) return;
  std::vector<Box3> loose;
  for (auto body = bodies.begin() + 1; body != bodies.end(); ++body) {
    loose.push_back(body->bounds);
    own_mm3_ -= body->volume_mm3;
  }
  stock_.dropPieces(loose, bodies.front().bounds);
  apart_.insert(apart_.begin(), bodies.begin() + 1, bodies.end());
}

Result<std::unique_ptr<Workpiece>> MilledPiece::become(ProcessKind next, const RigidTransform& move,
                                                       const PieceOptions& options, Progress& progress) {
  Result<Stock> moved = stock_.moved(move, options.grid, progress);
  if (!moved) return moved.error();
  for (StockBody& body : apart_) body.bounds = move(body.bounds);
  return pieceOnGrid(next, std::move(*moved), left_mm3_, own_mm3_, std::move(apart_));
}

}  // namespace proveout
