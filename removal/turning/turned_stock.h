// A stock that turns about Z and is cut by tools in the plane of its axis, kept as a half section.
//
// Exact but for chords of kSectionChordMm on arcs and rounding to nanometres: there is no grid. Tool paths
// give X as a radius and Y as 0.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/geometry/rigid_transform.h"
#include "core/path/toolpath.h"
#include "core/tool/tool.h"
#include "removal/grid/stock.h"
#include "removal/grid/stock_shape.h"
#include "removal/turning/section/section.h"

namespace proveout {

/// Names what of a motion cannot be turned: a way out of the plane, a tilted axis. Null: nothing.
const char* turningObstacle(const Motion& motion, const ArcGeometry* arc, const AxisSweep* axis);
/// Error: a motion that cannot be turned, also for a thread of turns beyond number or a tool that is not
/// defined.
Status turnable(const Toolpath& path, const std::vector<Tool>& tools);

class TurnedStock {
 public:
  /// A cylinder or tube about Z; held at its lower end. Errors: other shapes, another axis.
  static Result<TurnedStock> create(const StockShape& shape);
  ~TurnedStock();
  TurnedStock(TurnedStock&&) noexcept;
  TurnedStock& operator=(TurnedStock&&) noexcept;

  /// Cuts the path into the stock; once. `tools` must hold every tool that the path uses. Threads are kept as
  /// such (shape()); their volumes are estimates in the summary. Errors: a motion with an obstacle, a missing
  /// tool, cancelled.
  Result<RemovalSummary> remove(const Toolpath& path, const std::vector<Tool>& tools, Progress& progress);

  /// Touches of a path with this stock, which is a fixture and is not cut: kFixture, kShank or kHolder.
  Result<std::vector<Contact>> touches(const Toolpath& path, const std::vector<Tool>& tools,
                                       Progress& progress) const;

  /// How much of the way (0..1) a tool goes until it touches what the chuck holds, to about a nanometre;
  /// nothing: it touches nothing. `arc`: null for a line. Requires a move without turningObstacle().
  std::optional<double> firstContact(const Motion& move, const ArcGeometry* arc, const Tool& tool) const;

  /// A body of this stock in another clamping, as a blank, with its threads; who made its surface is not
  /// known any more. Errors: a move that does not keep the axis (Z may be turned round).
  Result<TurnedStock> moved(const SectionBody& body, const RigidTransform& move) const;

  /// What is left: first the body that the chuck holds, then what was parted from it, in that order.
  TurnedShape shape() const;
  double initialVolume() const;  ///< mm3, of the blank
  Box3 bounds() const;           ///< of the blank, mm

 private:
  struct Impl;
  explicit TurnedStock(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace proveout
