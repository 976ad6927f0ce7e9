// A workpiece that turns, as a half section with its threads.
#pragma once

#include "removal/process/turned_form.h"
#include "removal/process/workpiece.h"
#include "removal/turning/turned_stock.h"

namespace proveout {

class TurnedPiece final : public Workpiece {
 public:
  explicit TurnedPiece(TurnedStock stock);

  /// A grid is made where one is kept, or the half sections of a thread do not go over into each other.
  Result<Machined> machine(const Toolpath& path, const std::vector<Tool>& tools, const PieceOptions& options,
                           Progress& progress) override;
  Status cut(const Toolpath& path, const std::vector<Tool>& tools, const PieceOptions& options,
             Progress& progress) override;
  /// For turning: moves that keep the axis. For milling: the part goes onto the grid, what fell off does not.
  Result<std::unique_ptr<Workpiece>> become(ProcessKind next, const RigidTransform& move,
                                            const PieceOptions& options, Progress& progress) override;
  std::optional<Stock> takeGrid() override { return std::move(grid_); }

 private:
  Status makeGrid(const TurnedShape& part, const PieceOptions& options, Progress& progress);
  Status threadSurface(const TurnedShape& part, const PieceOptions& options, Machined& out,
                       Progress& progress);
  Status takePart(const PieceOptions& options, Machined& out, Progress& progress);

  TurnedStock stock_;
  std::optional<Stock> grid_;               ///< the part
  double left_mm3_ = 0.0;                   ///< of the stock and of what fell off before
  double part_mm3_ = 0.0;                   ///< of what the last machine() left, with its threads
  std::vector<StockBody> apart_;            ///< what fell off, frame of the clamping
  std::shared_ptr<const TurnedForm> made_;  ///< by the last machine(), the part first
};

}  // namespace proveout
