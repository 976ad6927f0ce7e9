// A milled part as what it is: a blank less the volumes that cutters swept. No grid.
#pragma once

#include <memory>
#include <vector>

#include "core/base/result.h"
#include "core/geometry/rigid_transform.h"
#include "core/tool/tool.h"
#include "removal/compare/exact_part.h"
#include "removal/grid/stock_shape.h"

namespace proveout {

struct TurnedShape;

/// What one clamping cut.
struct ClampedCut {
  const Toolpath* path = nullptr;
  const std::vector<Tool>* tools = nullptr;  ///< every tool that the path uses
  RigidTransform from_last;                  ///< from the frame of the last clamping into that of this one
};

/// Paths and tools must outlive the part. Feed and rapid take material, measuring moves do not; cutting parts
/// of tools do, shanks and holders do not: as Stock::remove. Null for blanks whose faces are not known (a
/// stock from a file). `blank_setup`: number of the clamping whose motions made the blank's faces, where such
/// did. Errors: as makeBlankField.
Result<std::unique_ptr<ExactPart>> makeSweptPart(const StockShape& blank, const std::vector<ClampedCut>& cuts,
                                                 std::uint32_t blank_setup = 0);

/// A part that only turned: its section, with threads. Errors: as makeTurnedField.
Result<std::unique_ptr<ExactPart>> makeTurnedPart(const std::shared_ptr<const TurnedShape>& shape);

}  // namespace proveout
