#include "removal/process/wire_piece.h"

#include <algorithm>
#include <numeric>

#include "core/base/assert.h"
#include "core/base/stopwatch.h"
#include "core/mesh/mesh_placement.h"
#include "removal/process/wire_grid_piece.h"
#include "removal/process/wire_part.h"
#include "removal/wire/lean/wall_meetings.h"

namespace proveout {
namespace {

/// Walls of leaning wires leave their ruled surfaces by this much of what facets may: the wire's path and its
/// round ends are chords as well.
constexpr double kShareOfFacet = 0.5;

/// mm.
constexpr double kAroundPart = 1.0;

const char* wayOut(const BodyExit& exit) {
  if (exit.down) return exit.up ? "both" : "down";
  return exit.up ? "up" : "none";
}

}  // namespace

WirePiece::WirePiece(WireStock stock) : stock_(std::move(stock)) {}

Result<Machined> WirePiece::machine(const Toolpath& path, const std::vector<Tool>& tools,
                                    const PieceOptions& options, Progress& progress) {
  Stopwatch watch;
  Machined out;
  out.initial_mm3 = stock_.volume();
  stock_.holdAt(options.held_at);
  Result<RemovalSummary> removal = stock_.remove(path, tools, kShareOfFacet * options.facet_mm, progress);
  if (!removal) return removal.error();
  out.remove_s = watch.lap();
  std::vector<std::size_t> order(stock_.bodies().size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (!order.empty()) {
    const Result<PartChoice> chosen = partAmong(stock_, options);
    if (!chosen) return chosen.error();
    const auto part = order.begin() + static_cast<std::ptrdiff_t>(chosen->body);
    std::rotate(order.begin(), part, part + 1);
    if (chosen->rival) out.rival = *chosen->rival + (*chosen->rival < chosen->body ? 1 : 0);
  }
  out.bodies.emplace();
  for (const std::size_t k : order) {
    const WireBody& body = stock_.bodies()[k];
    if (out.bodies->empty())
      out.bodies->push_back({body.volume_mm3, body.bounds, "part", ""});
    else
      out.bodies->push_back({body.volume_mm3, body.bounds, "slug", wayOut(stock_.exit(k, order.front()))});
  }
  if (!order.empty()) part_ = order.front();
  apart_.assign(out.bodies->begin() + (out.bodies->empty() ? 0 : 1), out.bodies->end());
  for (std::size_t k = 1; k < order.size(); ++k)
    out.freed.push_back(stock_.mesh({order[k]}, options.facet_mm));
  // A nominal is that of the part alone, and a point says which body is asked for.
  const bool alone = (options.part || options.part_point || options.part_alone) && order.size() > 1;
  if (alone) order.resize(1);
  out.mesh_bodies = order.size();
  out.surface.mesh = stock_.mesh(order, options.facet_mm);
  if (!stock_.knownSound()) {
    out.surface.self_intersections = wallMeetings(out.surface.mesh).size();
    for (std::size_t k = 0; alone && k < out.freed.size(); ++k)
      out.freed_self_intersections += wallMeetings(out.freed[k]).size();
  }
  out.surface.volume_mm3 = stock_.volume();
  out.surface.volume_error_mm3 = stock_.volumeError();
  out.facet_error_mm = options.facet_mm;
  fitRemovedVolume(*removal, out.initial_mm3 - out.surface.volume_mm3);
  out.removal = std::move(*removal);
  out.mesh_s = watch.lap();
  return out;
}

Status WirePiece::cut(const Toolpath& path, const std::vector<Tool>& tools, const PieceOptions& options,
                      Progress& progress) {
  stock_.holdAt(options.held_at);
  return stock_.cut(path, tools, kShareOfFacet * options.facet_mm, progress);
}

Result<std::unique_ptr<Workpiece>> WirePiece::become(ProcessKind next, const RigidTransform& move,
                                                     const PieceOptions& options, Progress& progress) {
  if (!part_) return inputError("nothing is left to be clamped");
  PROVEOUT_ASSERT(*part_ < stock_.bodies().size());
  std::vector<StockBody> apart = std::move(apart_);
  for (StockBody& body : apart) body.bounds = move(body.bounds);
  MeshShape shape{stock_.mesh({*part_}, options.facet_mm), "what the wire left"};
  shape.mesh.motion.clear();
  moveMesh(move, shape.mesh);
  if (next == ProcessKind::kTurning)
    return inputError("what a wire has cut cannot be turned: only bars, tubes and what is still round can");
  // Out of a box somewhat larger: the grid then has the crossings of the mesh alone.
  const Box3 about = meshBounds(shape.mesh).inflated(kAroundPart);
  Result<Stock> stock = Stock::create(BoxShape{about.min, about.max}, options.grid, progress);
  if (!stock) return stock.error();
  if (const Status kept = stock->keepWithin(shape); !kept) return kept.error();
  return pieceOnGrid(next, std::move(*stock), stock_.volume(), stock_.bodies()[*part_].volume_mm3,
                     std::move(apart));
}

}  // namespace proveout
