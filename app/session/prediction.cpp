#include "app/session/prediction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "app/session/height_map.h"
#include "core/base/memory.h"
#include "core/base/parallel_for.h"
#include "core/mesh/tri_mesh.h"

namespace proveout {
namespace {

// Measured with tests/bench/bench_prediction on two cores. A cell is a square of the grid on the surface.
constexpr double kBaseMb = 24.0;               ///< program, libraries, threads
constexpr double kBytesPerCell = 52.0;         ///< leaves, crossings, mesh of flat faces
constexpr double kBytesPerCutCell = 120.0;     ///< on top of that: round walls
constexpr double kBytesPerUnevenCell = 220.0;  ///< and where triangles are not merged
constexpr double kBytesPerTriangle = 75.0;  ///< of a mesh from half sections: the sections and the file, too
constexpr double kBytesPerGrooveTriangle = 70.0;      ///< on top of that: sections where ridges are cut
constexpr double kBytesPerTurnedCell = 20.0;          ///< on top of kBytesPerCell: from a half section
constexpr double kBytesPerThreadedCell = 160.0;       ///< and on top of that where threads run
constexpr double kBytesPerMotion = 500.0;             ///< motion and its passes
constexpr double kBytesPerTurnedMotion = 600.0;       ///< its edges in the half section
constexpr double kBytesPerFixtureCell = 28.0;         ///< leaves and crossings alone
constexpr double kModuleMb = 30.0;                    ///< OpenVDB, for saved stocks and meshes
constexpr double kBytesPerSavedCell = 250.0;          ///< reading or writing a saved stock
constexpr double kBytesPerSavedThreadedCell = 900.0;  ///< writing threads, on top of that
constexpr double kBytesPerBlankTriangle = 170.0;      ///< of a mesh that a stock is made from
constexpr double kBytesPerMeshedCell = 170.0;         ///< making a stock from a mesh
constexpr double kComparisonMb = 18.0;                ///< fixed part of a comparison
constexpr double kBytesPerComparedCell = 260.0;       ///< samples and search trees, both meshes
constexpr double kDrawingMb = 27.0;                   ///< of pictures: rows of what pixels show, Embree
constexpr double kBytesPerPixel = 10.0;               ///< two pictures, and a file
constexpr double kBytesPerDrawnCell = 120.0;          ///< the renderer's search tree and normals
constexpr double kBytesPerDrawnTriangle = 140.0;
constexpr double kMostComparedCells = 1.8e6;  ///< the comparison widens its samples on huge meshes

constexpr double kBaseS = 0.02;
constexpr double kSecondsPerCell = 1.4e-7;        ///< blank, removal, crossings, mesh, files
constexpr double kSecondsPerCarriedCell = 2e-7;   ///< into the next clamping, grid line to grid line
constexpr double kSecondsPerCutCell = 1.45e-6;    ///< on top of that
constexpr double kSecondsPerUnevenCell = 1.2e-6;  ///< and where triangles are not merged
constexpr double kSecondsPerSweptCell = 5e-9;     ///< removal, each motion counted
/// A column under a chord or a part, by CurveKind.
constexpr std::array<double, kCurveKinds> kSecondsPerChordColumn = {1.2e-8, 3e-8,   1e-8,   5e-8,
                                                                    4.5e-7, 1.7e-6, 3.3e-6, 9.5e-7};
/// Of spirals: what a column costs was measured for parts of this size.
constexpr double kPartsPerTurn = 8.0, kSpiralGrowthMm = 1e-4;
/// Of helices with tools that are not undercut: the lower turns hold what the upper ones cut.
constexpr double kTurnsThatCount = 3.0;
/// Under a part of a spiral: what the height map does not show.
constexpr double kBytesPerUndercutColumn = 45.0;
constexpr double kBytesPerChord = 1000.0;  ///< a pass, and its numbers in lists
/// Chords of helices with undercut tools may be farther off: this part of the grid, instead of this, mm.
constexpr double kHelixChordShare = 1e-3, kChordMm = 5e-5;
constexpr double kSecondsPerTriangle = 1.1e-6;        ///< half sections, their mesh, its checks, files
constexpr double kSecondsPerGrooveTriangle = 1.1e-6;  ///< on top of that: sections where ridges are cut
constexpr double kSecondsPerPassPoint = 3.6e-6;       ///< passes that deeper ones hold are dropped
constexpr double kSecondsPerMotion = 2.0e-6;          ///< interpreter, culling
constexpr double kSecondsPerTurnedMotion = 4e-5;      ///< out of the half section
constexpr double kSecondsPerFixtureCell = 1.0e-7;     ///< leaves and crossings alone
constexpr double kSecondsPerTurnedCell = 4e-7;        ///< from a half section to the grid
constexpr double kSecondsPerThreadedCell = 6e-6;      ///< on top of that where threads run
constexpr double kSecondsPerReadCell = 6e-7;          ///< of a saved stock
constexpr double kSecondsPerWrittenCell = 1.3e-6;     ///< as a saved stock
constexpr double kSecondsPerTextCell = 1.2e-6;        ///< cut cells in one mesh file as text
constexpr double kSecondsPerBlankTriangle = 4.5e-6;   ///< a stock from a mesh
constexpr double kSecondsPerMeshedCell = 2.1e-6;      ///< the same, and its cells
constexpr double kSecondsPerMovedCell = 2.3e-6;       ///< a stock from that of the clamping before
constexpr double kSecondsPerComparedCell = 2.2e-6;    ///< comparison
constexpr double kSecondsPerDrawnTriangle = 1.2e-6;   ///< search tree and normals, for all pictures
constexpr double kSecondsPerPixel = 0.65e-7;          ///< one picture of flat faces
constexpr double kMoreSecondsCut = 1.0;               ///< so much more where nothing is level

/// The height map has at most this many cells along a side, and its making touches at most so many.
constexpr int kMapSide = 256;
constexpr double kMapWork = 6e6;
/// Arcs as this many chords a turn: enough for a coarse map.
constexpr double kChordsPerTurn = 24.0;

void add(CurveWork& sum, const CurveWork& more) {
  sum.chords += more.chords;
  sum.columns_mm2 += more.columns_mm2;
}

int segmentsOf(const Toolpath& path, const Motion& motion) {
  if (motion.arc < 0) return 1;
  const double turns = std::abs(path.arcs[static_cast<std::size_t>(motion.arc)].sweep_rad) / (2 * kPi);
  return static_cast<int>(std::clamp(std::ceil(turns * kChordsPerTurn), 1.0, 10000.0));
}

template <typename Use>
void forEachSegment(const Toolpath& path, const Motion& motion, const Use& use) {
  const int chords = segmentsOf(path, motion);
  Vec3 from = motion.from;
  for (int i = 1; i <= chords; ++i) {
    const Vec3 to = i == chords ? motion.to : path.pointAt(motion, static_cast<double>(i) / chords);
    use(from, to);
    from = to;
  }
}

bool reaches(const Box3& blank, const Vec3& a, const Vec3& b, double radius) {
  Box3 box;
  box.extend(a);
  box.extend(b);
  box = box.inflated(radius);
  box.max.z() = std::numeric_limits<double>::infinity();
  box.min.z() += radius;  // the tip is the lowest point
  return box.overlaps(blank);
}

struct CutterSize {
  Footprint footprint;
  bool undercut = false;  ///< wider below than above somewhere
  bool plain = false;     ///< kernels have vectors for rising spirals: flat and ball ends, bull noses
};

std::map<int, CutterSize> cutterSizes(const std::vector<Tool>& tools) {
  std::map<int, CutterSize> out;
  for (const Tool& tool : tools) {
    out[tool.number] = {
        footprintOf(tool), hasNeck(tool.type),
        tool.type == ToolType::kFlat || tool.type == ToolType::kBall || tool.type == ToolType::kBull};
  }
  return out;
}

/// The motions that come to the blank.
class Strokes {
 public:
  Strokes(const Toolpath& path, const std::map<int, CutterSize>& cutters, const Box3& blank)
      : path_(path), blank_(blank), parts_((path.motions.size() + kPart - 1) / kPart) {
    parallelFor(std::size_t{0}, parts_.size(), [&](std::size_t i) { collect(i, cutters); });
  }

  double swept_mm2() const {
    return std::accumulate(parts_.begin(), parts_.end(), 0.0,
                           [](double sum, const Part& part) { return sum + part.swept_mm2; });
  }

  std::array<CurveWork, kCurveKinds> curves() const {
    std::array<CurveWork, kCurveKinds> sum;
    for (const Part& part : parts_) {
      for (int kind = 0; kind < kCurveKinds; ++kind) add(sum[kind], part.curves[kind]);
    }
    return sum;
  }

  void lower(HeightMap& map, int band) const {
    for (const Part& part : parts_) {
      for (const Stroke& stroke : part.strokes) {
        if (!map.touches(stroke.x_min, stroke.x_max, band)) continue;
        eachSegment(path_.motions[stroke.motion], stroke.tool.radius,
                    [&](const Vec3& a, const Vec3& b) { map.lower(a, b, stroke.tool, band); });
      }
    }
  }

 private:
  static constexpr std::size_t kPart = 4096;
  struct Stroke {
    MotionId motion;
    Footprint tool;
    double x_min, x_max;  ///< mm; what it reaches over
  };
  struct Part {
    std::vector<Stroke> strokes;
    double swept_mm2 = 0.0;
    std::array<CurveWork, kCurveKinds> curves;
  };

  /// The parts of a spiral of which `segments` of forEachSegment come to the blank.
  void addSpiral(const Motion& motion, const CutterSize& cutter, double segments, Part& part) const {
    const double share = segments / segmentsOf(path_, motion);
    const ArcGeometry& arc = path_.arcs[static_cast<std::size_t>(motion.arc)];
    const double parts = std::max(1.0, share * std::abs(arc.sweep_rad) / (2 * kPi) * kPartsPerTurn);
    const double reach = cutter.footprint.radius, length = share * path_.length(motion) / parts;
    const double plan =
        std::min(kPi * reach * reach + 2 * reach * length, blank_.size().x() * blank_.size().y());
    const CurveKind kind = motion.from.z() == motion.to.z() ? CurveKind::kLevelSpiral
                           : cutter.plain                   ? CurveKind::kPlainSpiral
                           : cutter.undercut                ? CurveKind::kUndercutSpiral
                                                            : CurveKind::kSpiral;
    add(part.curves[static_cast<std::size_t>(kind)], {parts, parts * plan});
  }

  /// The chords of a curve of which `segments` of forEachSegment come to the blank.
  void addChords(const Motion& motion, const CutterSize& cutter, double segments, Part& part) const {
    const ArcGeometry& arc = path_.arcs[static_cast<std::size_t>(motion.arc)];
    const bool about_z = arc.normal.head<2>().squaredNorm() < 1e-24;
    if (segments == 0.0) return;
    const double start = (motion.from - arc.center).head<2>().norm(),
                 end = (motion.to - arc.center).head<2>().norm();
    const bool spiral = about_z && std::abs(end - start) > kSpiralGrowthMm;
    if (spiral) return addSpiral(motion, cutter, segments, part);
    if (about_z && motion.from.z() == motion.to.z()) return;
    const double radius = std::max((motion.from - arc.center).norm(), kChordMm);
    double angle = std::abs(arc.sweep_rad) * segments / segmentsOf(path_, motion);
    if (about_z && !cutter.undercut) angle = std::min(angle, kTurnsThatCount * 2 * kPi);
    const double chords = angle / std::sqrt(8.0 * kChordMm / radius);
    const Vec3 size = blank_.size();
    const double reach = cutter.footprint.radius;
    const double plan = std::min(kPi * reach * reach, size.x() * size.y());
    const CurveKind kind = about_z           ? cutter.undercut ? CurveKind::kUndercutHelix : CurveKind::kHelix
                           : cutter.undercut ? CurveKind::kUndercutOther
                                             : CurveKind::kOther;
    add(part.curves[static_cast<std::size_t>(kind)], {chords, chords * plan});
  }

  template <typename Use>
  void eachSegment(const Motion& motion, double radius, const Use& use) const {
    forEachSegment(path_, motion, [&](const Vec3& a, const Vec3& b) {
      if (reaches(blank_, a, b, radius)) use(a, b);
    });
  }

  void collect(std::size_t number, const std::map<int, CutterSize>& cutters) {
    Part& part = parts_[number];
    const double most_x = blank_.size().x(), most_y = blank_.size().y();
    const std::size_t last = std::min(path_.motions.size(), (number + 1) * kPart);
    for (std::size_t i = number * kPart; i < last; ++i) {
      const Motion& motion = path_.motions[i];
      const auto found = cutters.find(motion.tool);
      const CutterSize cutter = found == cutters.end() ? CutterSize{} : found->second;
      const double radius = cutter.footprint.radius;
      double segments = 0.0;
      Stroke stroke{static_cast<MotionId>(i), cutter.footprint, std::numeric_limits<double>::infinity(),
                    -std::numeric_limits<double>::infinity()};
      eachSegment(motion, radius, [&](const Vec3& a, const Vec3& b) {
        const double length = std::min((b - a).norm(), most_x + most_y);
        ++segments;
        part.swept_mm2 += (length + 2 * radius) * std::min(2 * radius, std::max(most_x, most_y));
        stroke.x_min = std::min(stroke.x_min, std::min(a.x(), b.x()) - radius);
        stroke.x_max = std::max(stroke.x_max, std::max(a.x(), b.x()) + radius);
      });
      if (motion.arc >= 0) addChords(motion, cutter, segments, part);
      if (stroke.x_min <= stroke.x_max) part.strokes.push_back(stroke);
    }
  }

  const Toolpath& path_;
  const Box3& blank_;
  std::vector<Part> parts_;
};

}  // namespace

double blankArea(const StockShape& shape, const Box3& bounds) {
  if (const auto* mesh = std::get_if<MeshShape>(&shape)) return meshArea(mesh->mesh);
  if (const auto* round = std::get_if<CylinderShape>(&shape)) {
    const double r = round->radius, inner = round->inner_radius;
    return 2 * kPi * ((r + inner) * round->length + r * r - inner * inner);
  }
  const Vec3 s = bounds.size();
  if (const auto* known = std::get_if<FieldShape>(&shape)) return known->body->aboutArea();
  return 2 * (s.x() * s.y() + s.y() * s.z() + s.z() * s.x());
}

Workload workloadOf(const Toolpath& path, const std::vector<Tool>& tools, const Box3& blank,
                    double blank_mm2) {
  const Strokes strokes(path, cutterSizes(tools), blank);
  Workload work;
  work.clampings = 1;
  work.motions = path.motions.size();
  work.swept_mm2 = strokes.swept_mm2();
  work.curves = strokes.curves();
  double cell = std::max(blank.size().x(), blank.size().y()) / kMapSide;
  cell = std::max(cell, std::sqrt(work.swept_mm2 / kMapWork));
  HeightMap map(blank, cell);
  parallelFor(0, HeightMap::kBands, [&](int band) { strokes.lower(map, band); });
  work.surface_mm2 = std::max(blank_mm2 + map.addedArea(), 0.1 * blank_mm2);
  work.cut_mm2 = std::min(map.cutArea(), work.surface_mm2);
  work.uneven_mm2 = std::min(map.unevenArea(), work.surface_mm2);
  return work;
}

Workload together(const Workload& a, const Workload& b) {
  Workload both = a;
  for (double Workload::*member :
       {&Workload::surface_mm2, &Workload::cut_mm2, &Workload::uneven_mm2, &Workload::nominal_mm2,
        &Workload::fixture_mm2, &Workload::fixture_mesh_mm2, &Workload::pixels, &Workload::triangles,
        &Workload::thread_triangles, &Workload::groove_triangles, &Workload::turned_mm2,
        &Workload::threaded_mm2, &Workload::blank_triangles})
    both.*member = std::max(a.*member, b.*member);
  both.swept_mm2 += b.swept_mm2;
  for (int kind = 0; kind < kCurveKinds; ++kind) add(both.curves[kind], b.curves[kind]);
  both.pictures = std::max(a.pictures, b.pictures);
  both.motions += b.motions;
  both.turned_motions += b.turned_motions;
  both.pass_points += b.pass_points;
  both.reads_grid |= b.reads_grid;
  both.writes_grid |= b.writes_grid;
  both.text_files = std::max(a.text_files, b.text_files);
  both.clampings += b.clampings;
  both.mesh_moves += b.mesh_moves;
  return both;
}

double availableMemoryMb() { return 1e-6 * availableMemoryBytes(); }

namespace {

/// A workload on one grid.
struct Cells {
  double surface, cut, uneven, swept, turned, threaded, fixture, fixture_mesh, compared;
};

Cells cellsOf(const Workload& work, double resolution_mm) {
  const double h2 = resolution_mm * resolution_mm, surface = work.surface_mm2 / h2;
  return {surface,
          work.cut_mm2 / h2,
          work.uneven_mm2 / h2,
          work.swept_mm2 / h2,
          work.turned_mm2 / h2,
          work.threaded_mm2 / h2,
          work.fixture_mm2 / h2,
          work.fixture_mesh_mm2 / h2,
          work.nominal_mm2 > 0.0 ? std::min(surface + work.nominal_mm2 / h2, kMostComparedCells) : 0.0};
}

/// What reading, writing and making a stock from a mesh take on top of the stock, bytes; one after the other.
double moduleBytes(const Workload& work, const Cells& cells) {
  const double meshed =
      std::max(work.blank_triangles > 0.0 || work.mesh_moves > 0 ? cells.surface : 0.0, cells.fixture_mesh);
  const double threads = work.writes_grid ? cells.threaded * kBytesPerSavedThreadedCell : 0.0;
  const double saved =
      work.reads_grid || work.writes_grid ? cells.surface * kBytesPerSavedCell + threads : 0.0;
  const double made = std::max(work.blank_triangles * kBytesPerBlankTriangle, meshed * kBytesPerMeshedCell);
  return saved + made > 0.0 ? 1e6 * kModuleMb + std::max(saved, made) : 0.0;
}

double memoryMb(const Workload& work, const Cells& cells) {
  const double comparing =
      cells.compared > 0.0 ? 1e6 * kComparisonMb + cells.compared * kBytesPerComparedCell : 0.0;
  const double drawing = work.pixels > 0.0
                             ? (cells.cut + cells.uneven + cells.threaded) * kBytesPerDrawnCell +
                                   work.triangles * kBytesPerDrawnTriangle + work.pixels * kBytesPerPixel +
                                   1e6 * kDrawingMb
                             : 0.0;
  const double stock = cells.surface * kBytesPerCell + cells.cut * kBytesPerCutCell +
                       cells.uneven * kBytesPerUnevenCell + cells.turned * kBytesPerTurnedCell +
                       cells.threaded * kBytesPerThreadedCell + cells.fixture * kBytesPerFixtureCell;
  // Pictures are drawn while the part is compared; files come behind both, which give their memory back.
  return kBaseMb + 1e-6 * (stock + work.triangles * kBytesPerTriangle +
                           work.groove_triangles * kBytesPerGrooveTriangle +
                           static_cast<double>(work.motions) * kBytesPerMotion +
                           static_cast<double>(work.turned_motions) * kBytesPerTurnedMotion +
                           std::max(comparing + drawing, moduleBytes(work, cells)));
}

/// Of a curve's chords, how many are made on this grid.
double chordShare(int kind, double resolution_mm) {
  if (kind != static_cast<int>(CurveKind::kUndercutHelix)) return 1.0;
  return std::sqrt(kChordMm / std::max(kChordMm, kHelixChordShare * resolution_mm));
}

double curveBytes(const Workload& work, double resolution_mm) {
  double bytes = 0.0;
  for (int kind = 0; kind < kCurveKinds; ++kind)
    bytes += work.curves[kind].chords * chordShare(kind, resolution_mm) * kBytesPerChord;
  const double undercut = work.curves[static_cast<std::size_t>(CurveKind::kUndercutSpiral)].columns_mm2;
  return bytes + undercut / (resolution_mm * resolution_mm) * kBytesPerUndercutColumn;
}

double curveS(const Workload& work, double resolution_mm) {
  double seconds = 0.0;
  for (int kind = 0; kind < kCurveKinds; ++kind)
    seconds += work.curves[kind].columns_mm2 * chordShare(kind, resolution_mm) * kSecondsPerChordColumn[kind];
  return seconds / (resolution_mm * resolution_mm);
}

double timeS(const Workload& work, const Cells& cells) {
  const double clampings = std::max(1, work.clampings);
  const double each = clampings * kSecondsPerCell + (clampings - 1.0) * kSecondsPerCarriedCell;
  const double stock = cells.surface * each + cells.cut * kSecondsPerCutCell +
                       cells.uneven * kSecondsPerUnevenCell + cells.swept * kSecondsPerSweptCell +
                       cells.fixture * kSecondsPerFixtureCell + cells.fixture_mesh * kSecondsPerMeshedCell;
  const double turned = cells.turned * kSecondsPerTurnedCell + cells.threaded * kSecondsPerThreadedCell +
                        work.thread_triangles * kSecondsPerTriangle +
                        work.groove_triangles * kSecondsPerGrooveTriangle +
                        work.pass_points * kSecondsPerPassPoint +
                        static_cast<double>(work.turned_motions) * kSecondsPerTurnedMotion;
  const double from_mesh = work.blank_triangles > 0.0 ? work.blank_triangles * kSecondsPerBlankTriangle +
                                                            cells.surface * kSecondsPerMeshedCell
                                                      : 0.0;
  const double moved = work.mesh_moves * cells.surface * kSecondsPerMovedCell;
  const double files = (work.reads_grid ? cells.surface * kSecondsPerReadCell : 0.0) +
                       (work.writes_grid ? cells.surface * kSecondsPerWrittenCell : 0.0) +
                       work.text_files * cells.cut * kSecondsPerTextCell;
  const double cut_share = cells.surface > 0.0 ? std::min(1.0, cells.cut / cells.surface) : 0.0;
  const double drawn = cells.cut + cells.uneven + cells.threaded + work.triangles;
  const double drawing = work.pixels > 0.0 && work.pictures > 0
                             ? drawn * kSecondsPerDrawnTriangle + work.pixels * work.pictures *
                                                                      kSecondsPerPixel *
                                                                      (1.0 + kMoreSecondsCut * cut_share)
                             : 0.0;
  return kBaseS + stock + turned + from_mesh + moved + files + drawing +
         static_cast<double>(work.motions) * kSecondsPerMotion + cells.compared * kSecondsPerComparedCell;
}

}  // namespace

Prediction predict(const Workload& work, double resolution_mm) {
  const Cells cells = cellsOf(work, resolution_mm);
  return {memoryMb(work, cells) + 1e-6 * curveBytes(work, resolution_mm),
          timeS(work, cells) + curveS(work, resolution_mm)};
}

double resolutionThatFits(const Workload& work, double resolution_mm, double limit_mb) {
  // Memory is a + b / h^2: two grids tell a and b.
  const double at = predict(work, resolution_mm).memory_mb;
  if (at <= limit_mb) return resolution_mm;
  const double fixed = (4.0 * predict(work, 2.0 * resolution_mm).memory_mb - at) / 3.0;
  if (fixed >= limit_mb) return std::numeric_limits<double>::infinity();
  return resolution_mm * std::sqrt((at - fixed) / (limit_mb - fixed));
}

}  // namespace proveout
