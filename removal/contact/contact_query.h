// Where a tool on its way first touches the stock: for measuring moves.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/path/toolpath.h"
#include "core/tool/tool_solid.h"
#include "removal/grid/blank_field.h"
#include "removal/grid/stock.h"
#include "removal/sweep/swept_field.h"

namespace proveout {

/// Answers from the surface of a stock. Its mesh says where to look; there it is divided, and its points are
/// put onto the swept volumes and the blank that made it, until chords are within kContactFlatMm. So far the
/// contact is exact where the surface is known: made by the path, flat, or the round of a blank. Curved
/// surfaces that an earlier clamping made, and of blanks from meshes, are touched where the mesh is: h^2 / (8
/// r) off on walls of radius r.
class ContactQuery {
 public:
  /// How far the divided mesh may be from the surface, mm.
  static constexpr double kContactFlatMm = 1e-4;
  /// Tolerance of the mesh that queries should be made from, mm (SurfaceOptions::simplify_mm).
  static constexpr double kMeshMm = 1e-4;

  /// `surface`: of a stock with spacing `resolution_mm` that was cut by `path`; motions of its triangles are
  /// those of the path. `blank`: what the stock was before that, null where it is not known. `path` must
  /// outlive the query.
  ContactQuery(StockSurface surface, const Toolpath& path, const std::vector<Tool>& tools,
               const StockShape* blank, double resolution_mm);

  /// The parameter in 0..1 at which the tool, going straight from `from` to `to` (tip, workpiece frame, mm),
  /// first touches the surface with any of its parts; nothing: it does not. 0: it touches already. Requires
  /// validateTool(tool).
  std::optional<double> firstContact(const Tool& tool, const Vec3& from, const Vec3& to) const;

 private:
  friend class ContactSearch;

  /// The triangle on the other side of edge k (from corner k to the next).
  std::optional<std::size_t> across(std::size_t triangle, std::size_t k) const;

  StockSurface surface_;
  /// Edges of the mesh by their vertices, and a triangle at each; sorted.
  std::vector<std::pair<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>> edges_;
  const Toolpath& path_;
  std::map<int, ToolSolid> solids_;  ///< by number of the tool
  std::unique_ptr<BlankField> blank_;
  double h_;
};

}  // namespace proveout
