#include "app/session/forecast/prediction.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/memory.h"

namespace proveout {
namespace {

// Measured with tests/bench/bench_prediction on two cores. A cell is a square of the grid on the surface.
constexpr double kBaseMb = 19.5;                ///< program, libraries, threads
constexpr double kBytesPerCell = 52.0;          ///< leaves, crossings, mesh of flat faces
constexpr double kBytesPerCutCell = 120.0;      ///< on top of that: round walls
constexpr double kBytesPerFlatCell = 60.0;      ///< in place of that: planes
constexpr double kBytesPerUnevenCell = 190.0;   ///< and where triangles are not merged
constexpr double kBytesPerUnmergedCell = 60.0;  ///< nor are those of planes, where nothing is to be merged
constexpr double kBytesPerTriangle = 75.0;  ///< of a mesh from half sections: the sections and the file, too
constexpr double kBytesPerGrooveTriangle = 70.0;      ///< on top of that: sections where ridges are cut
constexpr double kBytesPerTurnedCell = 20.0;          ///< on top of kBytesPerCell: from a half section
constexpr double kBytesPerThreadedCell = 160.0;       ///< and on top of that where threads run
constexpr double kBytesPerMotion = 500.0;             ///< motion and its passes
constexpr double kBytesPerTurnedMotion = 300.0;       ///< its edges in the half section
constexpr double kBytesPerFixtureCell = 28.0;         ///< leaves and crossings alone
constexpr double kModuleMb = 30.0;                    ///< OpenVDB, for saved stocks and meshes
constexpr double kBytesPerSavedCell = 250.0;          ///< reading or writing a saved stock
constexpr double kBytesPerSavedThreadedCell = 900.0;  ///< writing threads, on top of that
constexpr double kBytesPerBlankTriangle = 170.0;      ///< of a mesh that a stock is made from
constexpr double kBytesPerMeshedCell = 140.0;         ///< making a stock from a mesh
constexpr double kComparisonMb = 10.0;                ///< fixed part of a comparison
constexpr double kBytesPerComparedCell = 190.0;       ///< samples and search trees, both meshes
constexpr double kDrawingMb = 27.0;                   ///< of pictures: rows of what pixels show, Embree
constexpr double kBytesPerPixel = 10.0;               ///< two pictures, and a file
constexpr double kGivenBack = 0.3;                    ///< of a stock before pictures are drawn
constexpr double kBytesPerDrawnCell = 120.0;          ///< the renderer's search tree and normals
constexpr double kBytesPerDrawnTriangle = 140.0;
constexpr double kMostComparedCells = 1.2e6;  ///< the comparison widens its samples on huge meshes

constexpr double kBaseS = 0.02;
constexpr double kSecondsPerCell = 0.85e-7;      ///< blank, removal, crossings, mesh, files
constexpr double kSecondsPerCarriedCell = 2e-7;  ///< into the next clamping, grid line to grid line
/// On top of that of what is cut, its mesh and what is asked for it; all in proportion to this.
constexpr double kMeshing = 1.0;
constexpr double kSecondsPerFlatCell = kMeshing * 3.8e-7, kSecondsPerRuledCell = kMeshing * 7e-7,
                 kSecondsPerRoundCell = kMeshing * 8e-7, kSecondsPerUnevenCell = kMeshing * 1.55e-6;
constexpr double kSecondsPerUnmergedCell = kMeshing * 2e-7;
/// Of round walls and floors as many triangles stay as there are bends in a cell.
constexpr double kSecondsPerBend = kMeshing * 2.2e-6;
/// Nearest points on rims that go down slowly, low steps, and terraces that meet.
constexpr double kSecondsPerSteppedCell = kMeshing * 2.3e-6;
constexpr double kSecondsPerSweptCell = 6e-9;  ///< removal, each motion counted
/// Of curves about z, and of other curves: all in proportion to these.
constexpr double kTurning = 1.0, kLeaning = 1.0;
/// Of tools that lean or turn on their way: in proportion to this.
constexpr double kTilted = 1.0;
/// A column under a chord or a part, by CurveKind; under flanked arcs a cell of a strip along the columns.
constexpr std::array<double, kCurveKinds> kSecondsPerChordColumn = {
    kTurning * 1.2e-8, kTurning * 1.1e-8, kLeaning * 1e-8,   kLeaning * 0.9e-7, kTurning * 4.5e-7,
    kTurning * 1.7e-6, kTurning * 3.3e-6, kTurning * 9.5e-7, kLeaning * 0.4e-8, kTilted * 1e-8,
    kTilted * 7e-7,    kTilted * 5e-7,    kTilted * 1e-5,    kTilted * 2.5e-9,  0.0,
    kTilted * 8e-9,    kTilted * 3e-8,    kTilted * 6e-5};
/// And what each takes on top of that, removal and mesh, from CurveKind::kLeansOnLine on. Of all but circles
/// what cuts anew counts (kMostCover in workload.cpp). Measured with `bench_prediction --only "five axes"
/// --threads 1` and some longer programs on one thread of an AMD EPYC, by processor time; chords that lean
/// are estimated.
constexpr std::array<double, kCurveKinds - kFirstTilted> kSecondsPerTilted = {
    kTilted * 5e-5,  kTilted * 5e-5, kTilted * 5e-5, kTilted * 5e-5, 0.0, kTilted * 2.5e-4, 0.0, 0.0,
    kTilted * 2.8e-4};
/// Under a part of a spiral: what the height map does not show.
constexpr double kBytesPerUndercutColumn = 45.0;
constexpr double kBytesPerChord = 2700.0;   ///< its passes, and their numbers in lists
constexpr double kBytesPerPart = 1000.0;    ///< of a spiral: the same
constexpr double kBytesPerLeaning = 300.0;  ///< bodies of a tool that leans
/// Of a motion that turns the tool: its track and the bodies of those parts that come to the blank; and of
/// each pose, tip and axis.
constexpr double kBytesPerTurning = 2000.0, kBytesPerPose = 60.0;
constexpr double kSecondsPerTriangle = 7e-7;        ///< half sections, their mesh, its checks, files
constexpr double kSecondsPerGrooveTriangle = 8e-7;  ///< on top of that: sections where ridges are cut
constexpr double kSecondsPerPassPoint = 2.9e-6;     ///< passes that deeper ones hold are dropped
constexpr double kSecondsPerMotion = 2.0e-6;        ///< interpreter, culling
constexpr double kSecondsPerTurnedMotion = 3.0e-5;  ///< out of the half section
constexpr double kSecondsPerFixtureCell = 0.7e-7;   ///< leaves and crossings alone
constexpr double kSecondsPerTurnedCell = 6e-7;      ///< from a half section to the grid
constexpr double kSecondsPerThreadedCell = 2.5e-6;  ///< on top of that where threads run
constexpr double kSecondsPerMilledThread = 8e-6;    ///< and what is cut on, again for each of its cells
constexpr double kSecondsPerReadCell = 4.5e-7;      ///< of a saved stock
constexpr double kSecondsPerWrittenCell = 0.85e-6;  ///< as a saved stock
constexpr double kSecondsPerTextCell = 1.2e-6;      ///< cut cells in one mesh file as text
constexpr double kSecondsPerBlankTriangle = 3e-6;   ///< a stock from a mesh
constexpr double kSecondsPerMeshedCell = 1.9e-6;    ///< the same, and its cells
constexpr double kSecondsPerThinCell = 2e-6;        ///< and a cell along a thin triangle
constexpr double kSecondsPerMovedCell = 2.3e-6;     ///< a stock from that of the clamping before
constexpr double kSecondsPerComparedCell = 0.8e-6;  ///< comparison: a sample
constexpr double kSecondsPerComparedCut = 2.4e-6;   ///< on top of that where the part is not level
/// And each body of a tool that leans or turns near it, and a blank of thin triangles.
constexpr double kSecondsPerAskedLeaning = 0.65e-6, kSecondsPerAskedTurning = 0.6e-7,
                 kSecondsPerAskedThin = 1.5e-6;
constexpr double kMostSamples = 2e6;                  ///< of both meshes
constexpr double kSecondsPerDrawnTriangle = 5e-7;     ///< search tree and normals, for all pictures
constexpr double kSecondsPerPixel = 0.85e-7;          ///< one picture of flat faces
constexpr double kMoreSecondsCut = 0.8;               ///< so much more where nothing is level
constexpr double kTrianglesOfARoundPart = 50000.0;    ///< of sections: where half of that is reached
constexpr double kSecondsPerDeviationPixel = 0.5e-7;  ///< on top of that: distances between the vertices

}  // namespace

double availableMemoryMb() { return 1e-6 * availableMemoryBytes(); }

namespace {

/// A workload on one grid.
struct Cells {
  double surface, cut, flat, ruled, stepped, bends, uneven, unmerged, swept, turned, threaded, fixture,
      fixture_mesh, compared;

  double round() const { return std::max(0.0, cut - flat - ruled); }
};

Cells cellsOf(const Workload& work, double resolution_mm) {
  const double h2 = resolution_mm * resolution_mm, surface = work.surface_mm2 / h2;
  return {surface,
          work.cut_mm2 / h2,
          work.flat_mm2 / h2,
          work.ruled_mm2 / h2,
          work.stepped_mm2 / h2,
          work.bends_mm / resolution_mm,
          work.uneven_mm2 / h2,
          work.unmerged_mm2 / h2,
          work.swept_mm2 / h2,
          work.turned_mm2 / h2,
          work.threaded_mm2 / h2,
          work.fixture_mm2 / h2,
          work.fixture_mesh_mm2 / h2,
          work.nominal_mm2 > 0.0 ? std::min(surface + work.nominal_mm2 / h2, kMostComparedCells) : 0.0};
}

/// What reading, writing and making a stock from a mesh take on top of the stock, bytes; one after the other.
/// Their module stays in memory behind them.
double moduleBytes(const Workload& work, const Cells& cells) {
  const double meshed =
      std::max(work.blank_triangles > 0.0 || work.mesh_moves > 0 ? cells.surface : 0.0, cells.fixture_mesh);
  const double threads = work.writes_grid ? cells.threaded * kBytesPerSavedThreadedCell : 0.0;
  const double saved =
      work.reads_grid || work.writes_grid ? cells.surface * kBytesPerSavedCell + threads : 0.0;
  const double made = std::max(work.blank_triangles * kBytesPerBlankTriangle, meshed * kBytesPerMeshedCell);
  return std::max(saved, made);
}

/// The renderer's search tree and normals, and what pixels show.
double drawingBytes(const Workload& work, const Cells& cells) {
  if (!(work.pixels > 0.0)) return 0.0;
  return (cells.cut + cells.uneven + cells.unmerged + cells.threaded) * kBytesPerDrawnCell +
         work.triangles * kBytesPerDrawnTriangle + work.pixels * kBytesPerPixel + 1e6 * kDrawingMb;
}

double memoryMb(const Workload& work, const Cells& cells) {
  const double comparing =
      cells.compared > 0.0 ? 1e6 * kComparisonMb + cells.compared * kBytesPerComparedCell : 0.0;
  const double stock = cells.surface * kBytesPerCell + (cells.cut - cells.flat) * kBytesPerCutCell +
                       cells.flat * kBytesPerFlatCell + cells.uneven * kBytesPerUnevenCell +
                       cells.unmerged * kBytesPerUnmergedCell + cells.turned * kBytesPerTurnedCell +
                       cells.threaded * kBytesPerThreadedCell + cells.fixture * kBytesPerFixtureCell;
  // Pictures are drawn while the part is compared, in what removal and meshing gave back; files come behind
  // both, which give their memory back.
  const double looking = std::max(0.0, comparing + drawingBytes(work, cells) - kGivenBack * stock);
  const double module = moduleBytes(work, cells);
  return kBaseMb + (module > 0.0 ? kModuleMb : 0.0) +
         1e-6 *
             (stock + work.triangles * kBytesPerTriangle + work.groove_triangles * kBytesPerGrooveTriangle +
              static_cast<double>(work.motions) * kBytesPerMotion +
              static_cast<double>(work.turned_motions) * kBytesPerTurnedMotion + std::max(looking, module));
}

double curveBytes(const Workload& work, double resolution_mm) {
  const auto of = [&](CurveKind kind) { return work.curves[static_cast<std::size_t>(kind)]; };
  double parts = 0.0;
  for (const CurveKind kind :
       {CurveKind::kLevelSpiral, CurveKind::kSpiral, CurveKind::kUndercutSpiral, CurveKind::kPlainSpiral})
    parts += of(kind).chords;
  const double leaning = of(CurveKind::kLeansOnLine).chords + of(CurveKind::kLeanSearched).chords +
                         of(CurveKind::kLeansOnArc).chords + of(CurveKind::kLeanCornerArc).chords +
                         of(CurveKind::kLeanChords).chords,
               turning = of(CurveKind::kTurns).chords + of(CurveKind::kTurnsSearched).chords;
  return of(CurveKind::kChords).chords * kBytesPerChord + parts * kBytesPerPart + leaning * kBytesPerLeaning +
         turning * kBytesPerTurning +
         (of(CurveKind::kPoses).chords + of(CurveKind::kEdgedPoses).chords) * kBytesPerPose +
         of(CurveKind::kUndercutSpiral).columns_mm2 / (resolution_mm * resolution_mm) *
             kBytesPerUndercutColumn;
}

double curveS(const Workload& work, double resolution_mm) {
  double seconds = 0.0;
  for (int kind = 0; kind < kCurveKinds; ++kind) {
    const double a_cell = kind == static_cast<int>(CurveKind::kFlankedArc)
                              ? resolution_mm  // strips, 1 mm wide
                              : resolution_mm * resolution_mm;
    seconds += work.curves[kind].columns_mm2 / a_cell * kSecondsPerChordColumn[kind];
    if (kind >= kFirstTilted) seconds += work.curves[kind].fresh * kSecondsPerTilted[kind - kFirstTilted];
  }
  return seconds;
}

/// Removal, the surface and its mesh, of grids.
double stockS(const Workload& work, const Cells& cells) {
  const double clampings = std::max(1, work.clampings);
  const double each = clampings * kSecondsPerCell + (clampings - 1.0) * kSecondsPerCarriedCell;
  const double thread = kSecondsPerThreadedCell + (clampings - 1.0) * kSecondsPerMilledThread;
  return cells.surface * each + cells.flat * kSecondsPerFlatCell + cells.ruled * kSecondsPerRuledCell +
         cells.round() * kSecondsPerRoundCell + cells.stepped * kSecondsPerSteppedCell +
         cells.bends * kSecondsPerBend + cells.uneven * kSecondsPerUnevenCell +
         cells.unmerged * kSecondsPerUnmergedCell + cells.swept * kSecondsPerSweptCell +
         cells.fixture * kSecondsPerFixtureCell + cells.fixture_mesh * kSecondsPerMeshedCell +
         cells.turned * kSecondsPerTurnedCell + cells.threaded * thread;
}

/// Bodies that need no grid.
double sectionS(const Workload& work) {
  return work.thread_triangles * kSecondsPerTriangle + work.groove_triangles * kSecondsPerGrooveTriangle +
         work.pass_points * kSecondsPerPassPoint;
}

/// Stocks from meshes.
double meshedS(const Workload& work, const Cells& cells, double resolution_mm) {
  const double from_mesh = work.blank_triangles > 0.0
                               ? work.blank_triangles * kSecondsPerBlankTriangle +
                                     cells.surface * kSecondsPerMeshedCell +
                                     work.blank_thin_mm / resolution_mm * kSecondsPerThinCell
                               : 0.0;
  return from_mesh + work.mesh_moves * cells.surface * kSecondsPerMovedCell;
}

/// What one thread does while the others wait: programs, half sections, files.
double serialS(const Workload& work, const Cells& cells) {
  return static_cast<double>(work.motions) * kSecondsPerMotion +
         static_cast<double>(work.turned_motions) * kSecondsPerTurnedMotion +
         (work.reads_grid ? cells.surface * kSecondsPerReadCell : 0.0) +
         (work.writes_grid ? cells.surface * kSecondsPerWrittenCell : 0.0) +
         work.text_files * cells.cut * kSecondsPerTextCell;
}

double comparisonS(const Workload& work, const Cells& cells, double resolution_mm) {
  if (!(work.nominal_mm2 > 0.0)) return 0.0;
  // Bodies without a grid have about the surface of the nominal.
  const double nominal = work.nominal_mm2 / (resolution_mm * resolution_mm),
               samples = nominal + (cells.surface > 0.0 ? cells.surface : nominal);
  const double asked = work.lean_asked * kSecondsPerAskedLeaning + work.turn_asked * kSecondsPerAskedTurning +
                       (work.blank_thin_mm > 0.0 ? kSecondsPerAskedThin : 0.0);
  return std::min(samples, kMostSamples) * (kSecondsPerComparedCell + asked) +
         std::min(cells.cut + cells.uneven, kMostSamples) * kSecondsPerComparedCut;
}

double drawingS(const Workload& work, const Cells& cells) {
  if (!(work.pixels > 0.0) || work.pictures == 0) return 0.0;
  const double cut = cells.surface > 0.0 ? std::min(1.0, cells.cut / cells.surface)
                                         : work.triangles / (work.triangles + kTrianglesOfARoundPart);
  const double triangles =
      cells.cut - cells.flat + cells.uneven + cells.unmerged + cells.threaded + work.triangles;
  const double pixels = work.pictures * kSecondsPerPixel * (1.0 + kMoreSecondsCut * cut) +
                        (work.nominal_mm2 > 0.0 ? kSecondsPerDeviationPixel : 0.0);
  return triangles * kSecondsPerDrawnTriangle + work.pixels * pixels;
}

/// What threads share.
double parallelS(const Workload& work, const Cells& cells, double resolution_mm) {
  return kBaseS + stockS(work, cells) + sectionS(work) + meshedS(work, cells, resolution_mm) +
         drawingS(work, cells) + comparisonS(work, cells, resolution_mm) + curveS(work, resolution_mm);
}

}  // namespace

Prediction predict(const Workload& work, double resolution_mm) {
  const Cells cells = cellsOf(work, resolution_mm);
  const double serial_s = serialS(work, cells);
  return {memoryMb(work, cells) + 1e-6 * curveBytes(work, resolution_mm),
          serial_s + parallelS(work, cells, resolution_mm), serial_s};
}

double resolutionThatFits(const Workload& work, double resolution_mm, double limit_mb) {
  constexpr double kCoarsest = 1e6;  // times
  constexpr int kHalvings = 60;
  const auto fits = [&](double grid) { return predict(work, grid).memory_mb <= limit_mb; };
  if (fits(resolution_mm)) return resolution_mm;
  if (!fits(kCoarsest * resolution_mm)) return std::numeric_limits<double>::infinity();
  double fine = 0.0, coarse = std::log(kCoarsest);
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (fine + coarse);
    (fits(resolution_mm * std::exp(middle)) ? coarse : fine) = middle;
  }
  return resolution_mm * std::exp(coarse);
}

}  // namespace proveout
