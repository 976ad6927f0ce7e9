// What a run will take, before it is started: memory and time from the size of the surface on the grid and of
// what the tools sweep. Over jobs of many kinds memory is good to a factor of 1.5, time to one of 2
// (tests/bench/bench_prediction); the coefficients are measured.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/mesh/tri_mesh.h"
#include "core/path/toolpath.h"
#include "core/tool/tool.h"
#include "removal/grid/stock_shape.h"

namespace proveout {

/// Curves that are not level arcs, by the chords within 0.05 micrometres that they would have: also those
/// that are cut as bodies.
struct CurveWork {
  double chords = 0.0;       ///< near the blank
  double fresh = 0.0;        ///< of these, with tools that lean or turn: those that find something to cut
  double columns_mm2 = 0.0;  ///< sum of what they cover in plan view; of the fresh ones
};
/// Helices: about z; undercut: with tools that are wider below than above, but discs. Arcs: upright or
/// leaning; flanked: with undercut tools that have flanks. Spirals: about z, level or as helices whose radius
/// changes. Of these parts count, not chords. Lean...: with a tool that leans and stands; lines and circles
/// about its axis count, or the chords of other curves; searched: column by column, where kernels do not know
/// the tool, it has round corners or lies flat. Turns: while the tool turns, motions and what each piece
/// covers; poses: the same of each pose, edged: of tools that do not end in a ball.
enum class CurveKind {
  kHelix,
  kUndercutHelix,
  kArc,
  kFlankedArc,
  kLevelSpiral,
  kSpiral,
  kUndercutSpiral,
  kPlainSpiral,
  kChords,  ///< leaning arcs of tools that have no vectors there
  kLeansOnLine,
  kLeanSearched,
  kLeansOnArc,
  kLeanCornerArc,  ///< with round corners
  kLeanChords,
  kTurns,
  kPoses,
  kEdgedPoses,
  kTurnsSearched
};
inline constexpr int kCurveKinds = 18;
/// From this one on, tools lean or turn.
inline constexpr int kFirstTilted = static_cast<int>(CurveKind::kLeansOnLine);

/// What the figures are made of. Does not depend on the grid.
struct Workload {
  double surface_mm2 = 0.0;   ///< of the part: what is left of the blank's surface and what is cut
  double cut_mm2 = 0.0;       ///< of that what is cut, but level floors
  double flat_mm2 = 0.0;      ///< of what is cut: by flat ends on long lines, into planes
  double ruled_mm2 = 0.0;     ///< of what is cut: by other tools on long lines
  double stepped_mm2 = 0.0;   ///< of the rest: by rims of flat ends on short lines that are not level
  double bends_mm = 0.0;      ///< of the rest of what is cut: area over the radius of the tool
  double unmerged_mm2 = 0.0;  ///< of surface_mm2, where no triangles are to be merged: all of it
  double uneven_mm2 =
      0.0;  ///< of the part, in plan view: neither flat nor a wall; its triangles are not merged
  double swept_mm2 = 0.0;  ///< plan area that the tools pass over, each motion counted; along lines twice
  std::array<CurveWork, kCurveKinds> curves;
  double lean_asked = 0.0;   ///< bodies of tools that lean whose box holds a point of the blank, on average
  double turn_asked = 0.0;   ///< the same of pieces of tools that turn
  double nominal_mm2 = 0.0;  ///< of the model that the part is compared with; 0: no comparison
  double fixture_mm2 = 0.0;  ///< of fixtures that tools come near to
  double fixture_mesh_mm2 = 0.0;  ///< of those that are meshes
  double pixels = 0.0;            ///< of one picture; 0: none is drawn
  int pictures = 0;
  std::uint64_t motions = 0;
  std::uint64_t turned_motions = 0;  ///< of those, cuts of parts that turn
  double triangles = 0.0;            ///< of a mesh that needs no grid
  double thread_triangles = 0.0;     ///< threads and walls of leaning wires take the time of so many
  double groove_triangles = 0.0;     ///< of those, of grooves whose sides are rows of passes
  double pass_points = 0.0;          ///< of the outlines of all thread passes
  double turned_mm2 = 0.0;           ///< surface of a part from half sections that goes to a grid
  double threaded_mm2 = 0.0;         ///< of that what threads run over
  double blank_triangles = 0.0;      ///< of a mesh that the blank is made from
  double blank_thin_mm = 0.0;        ///< of these that are long and thin: their lengths
  bool reads_grid = false;           ///< from a saved stock
  bool writes_grid = false;          ///< as a saved stock
  int text_files = 0;                ///< meshes written as text
  int clampings = 0;
  int mesh_moves = 0;  ///< clampings whose stock is made anew from its mesh
};

struct Prediction {
  double memory_mb = 0.0;  ///< largest resident size
  double time_s = 0.0;     ///< wall time with two cores where it was measured (machine_speed.h)
  double serial_s = 0.0;   ///< of that, what one thread does alone
};

/// Sum of the longest sides of a mesh's long and thin triangles, mm: many of them meet each place.
double thinLength(const TriMesh& mesh);

/// Surface of the blank, mm2. Of a saved stock: of its bounds.
double blankArea(const StockShape& shape, const Box3& bounds);

/// Surface of the part after the path, and area swept. The cut surface is that of a coarse height map of the
/// tools' tips over the blank's bounds.
Workload workloadOf(const Toolpath& path, const std::vector<Tool>& tools, const Box3& blank,
                    double blank_mm2);

/// Clampings follow each other: time adds up, of all else the largest counts.
Workload together(const Workload& a, const Workload& b);

/// What the machine has free, MB.
double availableMemoryMb();

Prediction predict(const Workload& work, double resolution_mm);

/// The finest grid, mm, whose predicted memory fits into `limit_mb`; not finer than `resolution_mm`. Infinity
/// where the path alone does not fit.
double resolutionThatFits(const Workload& work, double resolution_mm, double limit_mb);

}  // namespace proveout
