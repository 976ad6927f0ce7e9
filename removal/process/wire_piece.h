// A workpiece that a wire cuts, as a section of lines and arcs.
#pragma once

#include "removal/process/workpiece.h"
#include "removal/wire/wire_stock.h"

namespace proveout {

class WirePiece final : public Workpiece {
 public:
  explicit WirePiece(WireStock stock);

  /// Of several bodies the part is that which partAmong tells; the others are slugs.
  /// The mesh is that of the part alone where options.part, part_point or part_alone says so, else it has all
  /// bodies, each a shell.
  Result<Machined> machine(const Toolpath& path, const std::vector<Tool>& tools, const PieceOptions& options,
                           Progress& progress) override;
  Status cut(const Toolpath& path, const std::vector<Tool>& tools, const PieceOptions& options,
             Progress& progress) override;
  /// The part goes onto the grid from its mesh: to milling, or to a wire again.
  Result<std::unique_ptr<Workpiece>> become(ProcessKind next, const RigidTransform& move,
                                            const PieceOptions& options, Progress& progress) override;
  std::optional<Stock> takeGrid() override { return std::nullopt; }

 private:
  WireStock stock_;
  std::optional<std::size_t> part_;  ///< among its bodies, once it is cut
  std::vector<StockBody> apart_;     ///< the others
};

}  // namespace proveout
