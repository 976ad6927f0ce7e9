#include "removal/process/wire_piece.h"

#include <algorithm>

#include "core/base/stopwatch.h"
#include "removal/process/wire_part.h"
#include "removal/wire/prism_mesh.h"

namespace proveout {

WirePiece::WirePiece(WireStock stock) : stock_(std::move(stock)) {}

Result<Machined> WirePiece::machine(const Toolpath& path, const std::vector<Tool>& tools,
                                    const PieceOptions& options, Progress& progress) {
  Stopwatch watch;
  Machined out;
  out.initial_mm3 = stock_.volume();
  stock_.holdAt(options.held_at);
  Result<RemovalSummary> removal = stock_.remove(path, tools, progress);
  if (!removal) return removal.error();
  out.remove_s = watch.lap();
  const PrismBlank& blank = stock_.blank();
  std::vector<PlaneBody> bodies = stock_.bodies();
  out.bodies.emplace();
  if (!bodies.empty()) {
    const Result<std::size_t> chosen = partAmong(bodies, blank, options);
    if (!chosen) return chosen.error();
    const auto part = bodies.begin() + static_cast<std::ptrdiff_t>(*chosen);
    std::rotate(bodies.begin(), part, part + 1);
  }
  for (const PlaneBody& body : bodies) {
    out.bodies->push_back({body.area_mm2 * (blank.z_high - blank.z_low), boundsOf(body, blank),
                           out.bodies->empty() ? "part" : "slug"});
  }
  // A nominal is that of the part alone.
  if (options.part && bodies.size() > 1) bodies.resize(1);
  out.surface.mesh = prismMesh(bodies, blank.z_low, blank.z_high, options.facet_mm);
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
  const Result<RemovalSummary> removal = stock_.remove(path, tools, progress);
  return removal ? Status(Done{}) : Status(removal.error());
}

Result<std::unique_ptr<Workpiece>> WirePiece::become(ProcessKind /*next*/, const RigidTransform& /*move*/,
                                                     const PieceOptions& /*options*/,
                                                     Progress& /*progress*/) {
  return inputError("what a wire has cut cannot be clamped again: that is not built yet");
}

}  // namespace proveout
