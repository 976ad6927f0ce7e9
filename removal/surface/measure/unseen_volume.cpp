#include "removal/surface/measure/unseen_volume.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "core/base/parallel_for.h"
#include "removal/surface/measure/cell_shares.h"

namespace proveout {

namespace {

constexpr std::uint16_t kThin = CellTraits::kOff | CellTraits::kManySheets;
/// Parts of a cell that may be missed: by the rules on crossings; before the cells beside it are looked at
/// as well; before the cell is reported as thin.
constexpr double kLittle = 0.005, kSpreads = 0.01, kMuch = 0.05;
/// How uncertain what is missed is: this part of it; where nothing is known, this part of a cell.
constexpr double kUnsure = 0.05, kUnknown = 0.1;
/// A part with more doubtful cells than this, or in which bodies must be asked for their distance more often
/// than this (in all, and per cell), is too fine for its grid in many places, and only an error is reported:
/// looking at some cells and not at others would be no better than looking at none. Asking takes some 0.1
/// microseconds.
constexpr std::size_t kMostDoubtful = 300, kMostAsked = 5'000'000, kAskedFirst = 600'000, kAskedACell = 1000;
/// Cells between two checks of how often was asked.
constexpr std::size_t kBatch = 16;
/// With more thin cells than this a part is too thin for its grid in many places: they are only reported.
constexpr std::size_t kFewThin = 10;
/// On grids with no more cells than this all that the path left with an edge or a step are looked at: that
/// is little work, and cells are large.
constexpr std::size_t kSmallGrid = 20'000, kAskedSmall = 800'000;
/// Part of a cell by which each that is looked at may be off: it is cut with planes, and what is missed does
/// not count where it is little.
constexpr double kOfLook = 1e-3;
/// Part of a cell by which the single vertex of a step may be off.
constexpr double kOfStep = 0.01;
/// Part of a cell by which each with an edge of a saved stock adds to the error of all: mostly they cancel.
constexpr double kOfUnknownEdge = 0.003;

struct ByPlace {
  bool operator()(const Coord& a, const Coord& b) const {
    return std::tuple(a.z(), a.y(), a.x()) < std::tuple(b.z(), b.y(), b.x());
  }
};
using Places = std::set<Coord, ByPlace>;

/// Cells where the surface may be elsewhere than its crossings show.
struct Doubtful {
  std::vector<Coord> misses;  ///< a face ends before the vertex
  std::vector<Coord> thin;    ///< several sheets, or a vertex off the surface
  std::vector<Coord> steps;
  std::vector<Coord> edges;  ///< all others through which no smooth face runs; of small grids only
};

/// Whether the last path made a crossing of the cell, or cut away what is at its vertex without making one:
/// where it is known what was cut, only that puts the vertex of such a cell off the surface.
bool isCut(const SurfaceGrid& grid, const Coord& cell, std::uint16_t traits) {
  if ((traits & CellTraits::kOff) != 0 && grid.impl().cut_blank != nullptr) return true;
  for (int edge = 0; edge < 12; ++edge) {
    const int corner = edgeStartCorner(edge);
    if (grid.motionOn(edge / 4, cell.offsetBy(corner & 1, corner >> 1 & 1, corner >> 2)) != kNoMotion)
      return true;
  }
  return false;
}

void sortIn(const Coord& cell, std::uint16_t traits, bool small, Doubtful& out) {
  if ((traits & CellTraits::kMisses) != 0) {
    out.misses.push_back(cell);
  } else if ((traits & kThin) != 0) {
    out.thin.push_back(cell);
  } else if ((traits & CellTraits::kStep) != 0) {
    out.steps.push_back(cell);
  } else if (small && (traits & CellTraits::kSmooth) == 0) {
    out.edges.push_back(cell);
  }
}

Doubtful doubtfulCells(const SurfaceGrid& grid) {
  const bool small = grid.cellCount() <= kSmallGrid;
  Doubtful out;
  for (const SurfaceLeaf& leaf : grid.leaves()) {
    if (leaf.all_level) continue;
    for (int rank = 0; rank < leaf.cells; ++rank) {
      const std::uint16_t traits = grid.traits(leaf.base + static_cast<std::uint32_t>(rank));
      const bool edge = small && (traits & CellTraits::kSmooth) == 0;
      if (!edge && (traits & (CellTraits::kMisses | kThin | CellTraits::kStep)) == 0) continue;
      const int at = leaf.placeOf(rank);
      const Coord cell = leaf.stock->origin.offsetBy(at >> 3 & 7, at & 7, at >> 6);
      if ((traits & CellTraits::kMisses) != 0 || isCut(grid, cell, traits)) sortIn(cell, traits, small, out);
    }
  }
  return out;
}

bool isThin(const SurfaceGrid& grid, const Coord& at) {
  const std::optional<std::uint32_t> cell = grid.cellAt(at);
  return cell && (grid.traits(*cell) & kThin) != 0;
}

/// The work that cells took, and what they may take.
struct Work {
  std::size_t cells = 0, asked = 0;
  std::size_t most = kMostAsked;
  bool tooMuch() const { return asked > std::min(most, kAskedFirst + cells * kAskedACell); }
};

/// Material of cells beyond what is under the surface, in parts of a cell. Empty where finding it takes too
/// much work. `work`: what others took; receives this as well.
std::optional<std::vector<double>> missedIn(const std::vector<Coord>& cells, const SurfaceGrid& grid,
                                            Work& work, Progress& progress) {
  std::vector<double> missed(cells.size());
  std::vector<std::size_t> asked(cells.size());
  std::size_t sum = 0;
  for (std::size_t begin = 0; begin < cells.size(); begin += kBatch) {
    const std::size_t end = std::min(begin + kBatch, cells.size());
    parallelFor(begin, end, [&](std::size_t i) {
      if (progress.cancelled()) return;
      CellMaterial material(grid.impl());
      const std::optional<double> left = material.share(grid.impl().position(cells[i]));
      if (left) missed[i] = *left - CellUnderSurface(grid).share(cells[i]);
      asked[i] = material.asked();
    });
    for (std::size_t i = begin; i < end; ++i) sum += asked[i];
    // What all will take if the others take as much as these.
    const std::size_t all = work.asked + sum * cells.size() / end;
    if (Work{work.cells + cells.size(), all, work.most}.tooMuch()) return std::nullopt;
  }
  work.cells += cells.size();
  work.asked += sum;
  return missed;
}

void addBeside(const Coord& cell, Places& seen, std::vector<Coord>& out) {
  for (int i = 0; i < 27; ++i) {
    const Coord beside = cell.offsetBy(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    if (seen.insert(beside).second) out.push_back(beside);
  }
}

/// The same of cells and of those beside them, as long as something is missed. Empty where that takes too
/// much work.
std::optional<UnseenVolume> missedAround(std::vector<Coord> cells, const SurfaceGrid& grid,
                                         std::size_t most_asked, Progress& progress) {
  const double cell = std::pow(grid.impl().h, 3);
  UnseenVolume out;
  Places seen(cells.begin(), cells.end());
  Work work{.most = most_asked};
  while (!cells.empty()) {
    const std::optional<std::vector<double>> found = missedIn(cells, grid, work, progress);
    if (!found) return std::nullopt;
    const std::vector<double>& missed = *found;
    std::vector<Coord> next;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (std::abs(missed[i]) < kLittle) continue;
      out.mm3 += missed[i];
      out.error_mm3 += kUnsure * std::abs(missed[i]);
      if (std::abs(missed[i]) >= kMuch && !isThin(grid, cells[i])) ++out.thin_cells;
      if (std::abs(missed[i]) >= kSpreads) addBeside(cells[i], seen, next);
    }
    cells = std::move(next);
  }
  out.looked_at = work.cells;
  out.mm3 *= cell;
  out.error_mm3 *= cell;
  return out;
}

void append(const std::vector<Coord>& more, std::vector<Coord>& to) {
  to.insert(to.end(), more.begin(), more.end());
}

}  // namespace

double unknownBesideEdges(const SurfaceGrid& grid) {
  std::size_t edges = 0;
  for (const SurfaceLeaf& leaf : grid.leaves()) {
    for (int rank = 0; !leaf.all_level && rank < leaf.cells; ++rank) {
      const std::uint16_t traits = grid.traits(leaf.base + static_cast<std::uint32_t>(rank));
      edges += (traits & CellTraits::kSmooth) == 0 ? 1 : 0;
    }
  }
  return kOfUnknownEdge * static_cast<double>(edges) * std::pow(grid.impl().h, 3);
}

UnseenVolume unseenVolume(const SurfaceGrid& grid, Progress& progress) {
  const Stock::Impl& impl = grid.impl();
  if (impl.cut == nullptr) return {};
  const bool known = impl.cut_blank != nullptr;
  const Doubtful doubtful = doubtfulCells(grid);
  std::optional<UnseenVolume> found;
  std::vector<Coord> cells = doubtful.misses;
  double left = kOfStep * static_cast<double>(doubtful.steps.size()),
         thin = kUnknown * static_cast<double>(doubtful.thin.size());
  if (known && grid.cellCount() <= kSmallGrid) {
    std::vector<Coord> all = cells;
    for (const auto* more : {&doubtful.thin, &doubtful.steps, &doubtful.edges}) append(*more, all);
    found = missedAround(std::move(all), grid, kAskedSmall, progress);
    if (found) {
      left = kOfLook * static_cast<double>(found->looked_at);
      thin = 0.0;
    }
  }
  if (!found && known && cells.size() <= kMostDoubtful) {
    const bool few_thin = doubtful.thin.size() <= kFewThin;
    if (few_thin) append(doubtful.thin, cells);
    found = missedAround(std::move(cells), grid, kMostAsked, progress);
    if (found && few_thin) thin = 0.0;
  }
  if (progress.cancelled()) return {};
  if (!found) left += kUnknown * static_cast<double>(doubtful.misses.size());
  UnseenVolume out = found.value_or(UnseenVolume{});
  out.error_mm3 += (left + thin) * std::pow(impl.h, 3);
  return out;
}

}  // namespace proveout
