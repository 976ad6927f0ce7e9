// What can be said of a program before anything is cut: of its path, the job and the bounds of the blank.
#pragma once

#include <optional>
#include <vector>

#include "app/session/programs/interpretation.h"
#include "core/geometry/rigid_transform.h"
#include "core/geometry/types.h"
#include "core/mesh/tri_mesh.h"
#include "io/job/job.h"
#include "io/report.h"
#include "removal/grid/stock_shape.h"

namespace proveout {

/// What the clamping before left, in its frame, and how that moved into this clamping.
struct LeftBefore {
  const TriMesh& mesh;
  const RigidTransform& moved;
};

/// A program as it was read. All that it refers to must outlive it.
struct CheckedProgram {
  const Job& job;  ///< as it is in this clamping, see jobOfSetup
  const Toolpath& path;
  const RecordingSource& texts;
  std::optional<Box3> blank = {};  ///< bounds of what is clamped, workpiece frame; none: it is not known
  /// What is clamped: the blank, or what the clamping before left; null: its bounds alone are known.
  const StockShape* shape = nullptr;
  std::optional<LeftBefore> left_before = {};
};

/// Values that can hardly be meant, and what the machine or its tools would not bear: times and dwells, feeds
/// and speeds above their limits, tool changes without a retract, a program in the other unit. Warnings.
void addProgramFindings(const CheckedProgram& program, std::vector<Finding>& findings);

/// A finding at the block that a motion was made for, at the motion's end.
Finding findingAt(FindingKind kind, MotionId motion, const CheckedProgram& program);

}  // namespace proveout
