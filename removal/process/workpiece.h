// What is clamped, as the process that machines it keeps it: one implementation a process.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/geometry/rigid_transform.h"
#include "core/path/process_kind.h"
#include "core/path/toolpath.h"
#include "core/tool/tool.h"
#include "removal/grid/stock.h"
#include "removal/process/part_form.h"
#include "removal/process/stock_body.h"
#include "removal/turning/section/section.h"

namespace proveout {

/// How a workpiece is machined and its surface made.
struct PieceOptions {
  RemovalOptions grid;      ///< for pieces that are on a grid or come onto one
  SurfaceOptions surface;   ///< of those
  double facet_mm = 1e-3;   ///< facets of turned surfaces leave them by no more than this, > 0
  bool keeps_grid = false;  ///< Workpiece::takeGrid will be asked for
  std::optional<Box3>
      part;  ///< where the part is among several bodies, frame of the clamping; none: not known
  std::optional<Vec3> part_point;  ///< in the part, of which bodies there may be several; goes before `part`
  bool part_alone = false;         ///< the mesh of what a wire cuts has the part alone, `part` or not
  /// Where fixtures reach between the heights of a workpiece that a wire cuts, as convex polygons seen from
  /// +z: what they touch is held. None: nobody knows what is held.
  std::vector<std::vector<Vec2>> held_at;
  std::function<Status()>
      grid_fits;  ///< asked before a grid is made that a turned part needs; null: it may be
};

/// What one clamping made of its workpiece.
struct Machined {
  double initial_mm3 = 0.0;  ///< before it, as it is reported: what fell off before counts
  /// By how much that may be off, about, of a first clamping whose volume is that which the grid holds, mm3.
  double initial_error_mm3 = 0.0;
  RemovalSummary removal;  ///< volumes fitted: their sum is initial less final
  StockSurface surface;    ///< after it, in its frame; the volume is initial_mm3 less what was removed
  /// The part first, what fell off in earlier clampings last. None: the bodies of the mesh are those of the
  /// workpiece, and `apart` is what fell off before.
  std::optional<std::vector<StockBody>> bodies;
  std::vector<StockBody> apart;
  /// Of `bodies` one that may be the part as well: nothing says which of the two is.
  std::optional<std::size_t> rival;
  /// Of pieces that this clamping cut free: bodies[1] and those behind it, a closed mesh each.
  std::vector<TriMesh> freed;
  /// So many of `bodies` are in the mesh, the first ones.
  std::size_t mesh_bodies = 1;
  /// As of the surface, of those of them that are not in its mesh.
  std::size_t freed_self_intersections = 0;
  std::shared_ptr<const PartForm> form = PartForm::plain();
  /// Of a mesh from a section: how far it may leave that and its threads, mm; 0: it comes from a grid.
  double facet_error_mm = 0.0;
  /// What the grid holds of what was clamped, mm3, and what that has by itself; none where they are the same.
  struct Holding {
    double own_mm3, held_mm3;
    /// By how much what was removed may be off by that, mm3: the difference lies somewhere in the workpiece,
    /// at its edges mostly, and counts with twice the share that was removed.
    double errorOf(double removed_mm3) const {
      if (held_mm3 <= 0.0) return own_mm3;
      return std::abs(own_mm3 - held_mm3) * std::min(1.0, 2.0 * removed_mm3 / held_mm3);
    }
  };
  std::optional<Holding> holding;
  double remove_s = 0.0, mesh_s = 0.0;  ///< wall time
};

class Workpiece {
 public:
  virtual ~Workpiece() = default;

  /// Cuts the path, once a clamping, and makes the surface. `tools` must hold every tool that the path uses.
  /// Errors: cancelled, out of memory, a motion that the process does not do.
  virtual Result<Machined> machine(const Toolpath& path, const std::vector<Tool>& tools,
                                   const PieceOptions& options, Progress& progress) = 0;
  /// Cuts the path alone: for pieces that are asked about touches, not for their surface.
  virtual Status cut(const Toolpath& path, const std::vector<Tool>& tools, const PieceOptions& options,
                     Progress& progress) = 0;

  /// Behind machine(), where its bodies are those of the mesh: which of them is the part, first in this list,
  /// and which have come loose: those are not clamped any more.
  virtual void letFall(const std::vector<StockBody>& /*bodies*/) {}

  /// What is left, in another clamping, for the same or another process; this piece is not to be used any
  /// more. A turned part goes onto the grid from its section and threads, exactly by any move. Errors:
  /// nothing is left, a move that the process cannot do, a process that cannot go on from this one.
  virtual Result<std::unique_ptr<Workpiece>> become(ProcessKind next, const RigidTransform& move,
                                                    const PieceOptions& options, Progress& progress) = 0;

  /// The stock on its grid, to be saved or asked: of turned parts where one was kept or needed; else none.
  /// Once.
  virtual std::optional<Stock> takeGrid() = 0;
};

}  // namespace proveout
