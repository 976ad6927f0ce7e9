// A stock with upright walls that a wire cuts all through, kept as a section of lines and arcs: exact but for
// rounding to nanometres, without a grid.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/path/toolpath.h"
#include "core/tool/tool.h"
#include "removal/grid/stock.h"
#include "removal/grid/stock_shape.h"
#include "removal/wire/plane_region.h"
#include "removal/wire/wire_stretch.h"

namespace proveout {

/// A blank with upright walls; mm, workpiece frame.
struct PrismBlank {
  std::vector<PlaneLoop> loops;  ///< borders and start holes that do not cross
  double z_low = 0.0, z_high = 0.0;
  /// Where fixtures reach between these heights, as convex polygons seen from +z: see footprintOf.
  std::vector<std::vector<Vec2>> held_at;
};

/// Boxes, and cylinders and tubes along Z. Errors: other shapes.
Result<PrismBlank> prismOf(const StockShape& shape);

class WireStock {
 public:
  explicit WireStock(PrismBlank blank);

  /// Cuts the path; once. Feed motions with a threaded wire cut by its radius and its spark gap, wherever the
  /// blank is. A piece that nothing holds falls as soon as it is free: nothing cuts it any more. Rapids that
  /// meet what is held then are contacts (kRapid, kByHand), and places where the wire is threaded into it are
  /// told. What a motion removed is estimated at stations along it. Errors: a wire that leans, a tool that is
  /// no wire or is missing, cancelled.
  Result<RemovalSummary> remove(const Toolpath& path, const std::vector<Tool>& tools, Progress& progress);

  /// What is left, the largest first.
  const std::vector<PlaneBody>& bodies() const { return bodies_; }
  const PrismBlank& blank() const { return blank_; }
  /// Before remove: where fixtures hold the blank, see PrismBlank.
  void holdAt(std::vector<std::vector<Vec2>> polygons) { blank_.held_at = std::move(polygons); }
  double initialVolume() const;  ///< mm3, of the blank
  double volume() const;         ///< mm3, of what is left

 private:
  PrismBlank blank_;
  std::vector<PlaneBody> bodies_;
};

}  // namespace proveout
