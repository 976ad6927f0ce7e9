// A workpiece on the 3-D grid.
#pragma once

#include "removal/process/workpiece.h"

namespace proveout {

class MilledPiece final : public Workpiece {
 public:
  /// A blank. `saved`: it is an earlier run's stock, of which only the grid tells the volume.
  MilledPiece(Stock stock, bool saved);
  /// What an earlier clamping left: with the volume that was reported, which counts what fell off (`apart`,
  /// in this clamping's frame), and that of the piece itself.
  MilledPiece(Stock stock, double left_mm3, double own_mm3, std::vector<StockBody> apart);

  Result<Machined> machine(const Toolpath& path, const std::vector<Tool>& tools, const PieceOptions& options,
                           Progress& progress) override;
  Status cut(const Toolpath& path, const std::vector<Tool>& tools, const PieceOptions& options,
             Progress& progress) override;
  void letFall(const std::vector<StockBody>& bodies) override;
  /// Milling, or cutting with a wire. Exact where movesExactly, see Stock::moved.
  Result<std::unique_ptr<Workpiece>> become(ProcessKind next, const RigidTransform& move,
                                            const PieceOptions& options, Progress& progress) override;
  std::optional<Stock> takeGrid() override { return std::move(stock_); }

 private:
  double startVolume(double held_mm3) const;

  Stock stock_;
  bool first_ = true, saved_ = false;
  double left_mm3_ = 0.0;  ///< as the report tells it
  double own_mm3_ = 0.0;   ///< by its own shape
  std::vector<StockBody> apart_;
};

}  // namespace proveout
