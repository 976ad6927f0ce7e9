// A workpiece on the grid that a wire cuts: what an earlier clamping left, or a blank that is no prism.
#pragma once

#include "removal/process/workpiece.h"

namespace proveout {

class WireGridPiece final : public Workpiece {
 public:
  /// As MilledPiece's second one; of a blank `left_mm3` and `own_mm3` are its volume.
  WireGridPiece(Stock stock, double left_mm3, double own_mm3, std::vector<StockBody> apart);

  /// The wire cuts a box about the workpiece as it would a blank (WireStock); what the body of it has that is
  /// to be the part stays. Kerfs that do not part anything and are narrower than the grid are lost in the
  /// mesh, and told (RemovalSummary::narrow_cuts). Rapids through material are found at the grid's points.
  Result<Machined> machine(const Toolpath& path, const std::vector<Tool>& tools, const PieceOptions& options,
                           Progress& progress) override;
  Status cut(const Toolpath& path, const std::vector<Tool>& tools, const PieceOptions& options,
             Progress& progress) override;
  /// Milling, or a wire again.
  Result<std::unique_ptr<Workpiece>> become(ProcessKind next, const RigidTransform& move,
                                            const PieceOptions& options, Progress& progress) override;
  std::optional<Stock> takeGrid() override { return std::move(stock_); }

 private:
  Stock stock_;
  double left_mm3_ = 0.0;  ///< as the report tells it
  double own_mm3_ = 0.0;   ///< by its own shape
  std::vector<StockBody> apart_;
};

/// A piece on the grid for a process that has one: milling, or a wire. Errors: others.
Result<std::unique_ptr<Workpiece>> pieceOnGrid(ProcessKind next, Stock stock, double left_mm3, double own_mm3,
                                               std::vector<StockBody> apart);

}  // namespace proveout
