#include "removal/process/wire_piece.h"

#include <algorithm>
#include <numeric>

#include "core/base/stopwatch.h"
#include "removal/process/wire_part.h"

namespace proveout {
namespace {

/// Walls of leaning wires leave their ruled surfaces by this much of what facets may: the wire's path and its
/// round ends are chords as well.
constexpr double kShareOfFacet = 0.5;

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
    const Result<std::size_t> chosen = partAmong(stock_, options);
    if (!chosen) return chosen.error();
    const auto part = order.begin() + static_cast<std::ptrdiff_t>(*chosen);
    std::rotate(order.begin(), part, part + 1);
  }
  out.bodies.emplace();
  for (const std::size_t k : order) {
    const WireBody& body = stock_.bodies()[k];
    if (out.bodies->empty())
      out.bodies->push_back({body.volume_mm3, body.bounds, "part", ""});
    else
      out.bodies->push_back({body.volume_mm3, body.bounds, "slug", wayOut(stock_.exit(k, order.front()))});
  }
  // A nominal is that of the part alone.
  if (options.part && order.size() > 1) order.resize(1);
  out.surface.mesh = stock_.mesh(order, options.facet_mm);
  out.surface.volume_mm3 = stock_.volume();
  out.facet_error_mm = options.facet_mm;
  fitRemovedVolume(*removal, out.initial_mm3 - out.surface.volume_mm3);
  out.removal = std::move(*removal);
  out.mesh_s = watch.lap();
  return out;
}

Status WirePiece::cut(const Toolpath& path, const std::vector<Tool>& tools, const PieceOptions& options,
                      Progress& progress) {
  stock_.holdAt(options.held_at);
  const Result<RemovalSummary> removal =
      stock_.remove(path, tools, kShareOfFacet * options.facet_mm, progress);
  return removal ? Status(Done{}) : Status(removal.error());
}

Result<std::unique_ptr<Workpiece>> WirePiece::become(ProcessKind /*next*/, const RigidTransform& /*move*/,
                                                     const PieceOptions& /*options*/,
                                                     Progress& /*progress*/) {
  return inputError("what a wire has cut cannot be clamped again: that is not built yet");
}

}  // namespace proveout
