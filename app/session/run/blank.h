// The blank as a run first needs it: its shape and where it is.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "io/job/job.h"
#include "removal/grid/stock.h"

namespace proveout {

struct Blank {
  StockShape shape;
  Box3 bounds;                 ///< mm, workpiece frame
  double resolution_mm = 0.0;  ///< grid spacing that the run uses
  /// Already made: where only the grid knows the bounds (a saved stock), or early.
  std::optional<Stock> stock;
  std::vector<StartHole> start_holes = {};  ///< of the job
  std::vector<std::string> repairs = {};    ///< of its mesh, one sentence each, for a warning
};

/// Reads the blank's files and settles the grid. The job must have a stock.
Result<Blank> openBlank(const Job& job, Progress& progress);

/// Makes the grid, once.
Result<Stock> takeStock(Blank& blank, const Job& job, Progress& progress);

RemovalOptions removalOptions(const Job& job, double resolution_mm);

/// The blank's bounds as they are after the moves into the first setups of the job, mm.
Box3 movedBounds(const Job& job, Box3 bounds, std::size_t moves);

/// Refuses a shape that is thinner than two cells of the grid: it would fall between the grid's points.
Status checkThickness(const StockShape& shape, double resolution_mm);

/// Checks that a start point given by the job is not inside the blank. Blanks from meshes are not judged
/// here: the removal reports the contact.
Status checkStart(const Job& job, const Blank& blank);

}  // namespace proveout
