#include "removal/process/wire_piece.h"

#include <algorithm>
#include <limits>

#include "core/base/stopwatch.h"
#include "removal/wire/prism_mesh.h"

namespace proveout {
namespace {

Box3 boundsOfBody(const PlaneBody& body, const PrismBlank& blank) {
  Box3 bounds = boundsOf(body.loops.front());
  bounds.min.z() = blank.z_low;
  bounds.max.z() = blank.z_high;
  return bounds;
}

/// The largest, which comes first, or the one whose bounds fit best.
std::size_t partAmong(const std::vector<PlaneBody>& bodies, const PrismBlank& blank,
                      const std::optional<Box3>& wanted) {
  if (!wanted) return 0;
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const Box3 bounds = boundsOfBody(bodies[k], blank);
    const double off = (bounds.min - wanted->min).head<2>().cwiseAbs().sum() +
                       (bounds.max - wanted->max).head<2>().cwiseAbs().sum();
    if (off >= least) continue;
    least = off;
    best = k;
  }
  return best;
}

}  // namespace

WirePiece::WirePiece(WireStock stock) : stock_(std::move(stock)) {}

Result<Machined> WirePiece::machine(const Toolpath& path, const std::vector<Tool>& tools,
                                    const PieceOptions& options, Progress& progress) {
  Stopwatch watch;
  Machined out;
  out.initial_mm3 = stock_.volume();
  Result<RemovalSummary> removal = stock_.remove(path, tools, progress);
  if (!removal) return removal.error();
  out.remove_s = watch.lap();
  const PrismBlank& blank = stock_.blank();
  std::vector<PlaneBody> bodies = stock_.bodies();
  out.bodies.emplace();
  if (!bodies.empty()) {
    const auto part = bodies.begin() + static_cast<std::ptrdiff_t>(partAmong(bodies, blank, options.part));
    std::rotate(bodies.begin(), part, part + 1);
  }
  for (const PlaneBody& body : bodies) {
    out.bodies->push_back({body.area_mm2 * (blank.z_high - blank.z_low), boundsOfBody(body, blank),
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

Status WirePiece::cut(const Toolpath& path, const std::vector<Tool>& tools, const PieceOptions& /*options*/,
                      Progress& progress) {
  const Result<RemovalSummary> removal = stock_.remove(path, tools, progress);
  return removal ? Status(Done{}) : Status(removal.error());
}

Result<std::unique_ptr<Workpiece>> WirePiece::become(ProcessKind /*next*/, const RigidTransform& /*move*/,
                                                     const PieceOptions& /*options*/,
                                                     Progress& /*progress*/) {
  return inputError("what a wire has cut cannot be clamped again: that is not built yet");
}

}  // namespace proveout
