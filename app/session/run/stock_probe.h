// Measuring moves of a program meet the stock as the program has cut it so far.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/nc/control/control_host.h"
#include "core/tool/tool.h"
#include "removal/contact/contact_query.h"
#include "removal/grid/stock.h"

namespace proveout {

/// The stock that a program starts with.
struct ProbedStock {
  /// Makes it anew, each time the same.
  std::function<Result<Stock>(Progress&)> make;
  const StockShape* blank = nullptr;  ///< its shape, where nothing has been cut from it
  RemovalOptions options;
  std::vector<Tool> tools;
};

/// Asks the workpiece as the program has cut it so far.
class PieceProbe : public Probe {
 public:
  /// Why the workpiece could not answer.
  virtual const std::optional<Error>& failure() const = 0;
  /// Whether something was asked that fixtures, which do not answer, may have stood in the way of.
  virtual bool passedFixtures() const { return false; }
};

/// Says that a motion names a tool which the job does not have.
Error undefinedTool(int number);

/// Cuts the path known so far into a new stock when a measuring move asks and something may have been cut
/// since the last time. The run cuts everything again afterwards: what it makes does not depend on who asked
/// in between.
class StockProbe final : public PieceProbe {
 public:
  /// `path` gets what the control does and must hold everything before the move that is asked about.
  StockProbe(const ProbedStock& stock, const Toolpath& path, Progress& progress)
      : stock_(stock), path_(path), progress_(progress) {}

  /// Errors: a tool that the job does not define, a path with another tool axis than +z, no memory,
  /// cancelled.
  Result<std::optional<double>> firstContact(const Motion& move, const ArcGeometry* arc,
                                             const AxisSweep* axis) override;
  const std::optional<Error>& failure() const override { return failure_; }
  bool passedFixtures() const override { return query_ != nullptr; }

 private:
  Status cutSoFar();
  bool mayHaveCut(std::size_t first) const;
  Status takeMotions();

  const ProbedStock& stock_;
  const Toolpath& path_;
  Progress& progress_;
  Toolpath
      cut_;  ///< the motions that the stock of the query was cut with, and those known to have cut nothing
  std::size_t read_ = 0;  ///< of path_.motions
  std::unique_ptr<ContactQuery> query_;
  std::optional<Error> failure_;
};

}  // namespace proveout
