#include "removal/surface/unseen_volume.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "core/base/parallel_for.h"
#include "removal/surface/cell_shares.h"

namespace proveout {

namespace {

constexpr std::uint16_t kThin = CellTraits::kOff | CellTraits::kManySheets;
/// Parts of a cell: what the rules on crossings may leave; what may go on beside it; what is told of as thin.
constexpr double kLittle = 0.005, kSpreads = 0.01, kMuch = 0.05;
/// Of what is missed it is known but for this part; where nothing is known this part of a cell is missed.
constexpr double kUnsure = 0.05, kUnknown = 0.1;
/// A part with more doubtful cells than this, or in which bodies have to be asked for their distance more
/// often than so often and by cell, is too fine for its grid in many places: it is told of alone. Some cells
/// looked at and others not would be no better than none. Asking takes some 0.1 microseconds.
constexpr std::size_t kMostDoubtful = 300, kMostAsked = 5'000'000, kAskedFirst = 600'000, kAskedACell = 1000;
/// Cells between two looks at what was asked.
constexpr std::size_t kBatch = 16;
/// More thin cells than this are a part that is too thin for its grid in many places: they are told of alone.
constexpr std::size_t kFewThin = 10;

struct ByPlace {
  bool operator()(const Coord& a, const Coord& b) const {
    return std::tuple(a.z(), a.y(), a.x()) < std::tuple(b.z(), b.y(), b.x());
  }
};
using Places = std::set<Coord, ByPlace>;

/// Where to start. `known`: not only the path, but also what it cut; a blank may be thin before it and after.
std::vector<Coord> doubtfulCells(const SurfaceGrid& grid, bool known) {
  std::vector<Coord> misses, thin;
  for (const SurfaceLeaf& leaf : grid.leaves()) {
    if (leaf.all_level) continue;
    for (int rank = 0; rank < leaf.cells; ++rank) {
      const std::uint16_t traits = grid.traits(leaf.base + static_cast<std::uint32_t>(rank));
      if ((traits & (CellTraits::kMisses | kThin)) == 0) continue;
      const int at = leaf.placeOf(rank);
      const Coord cell = leaf.stock->origin.offsetBy(at >> 3 & 7, at & 7, at >> 6);
      ((traits & CellTraits::kMisses) != 0 ? misses : thin).push_back(cell);
    }
  }
  if (known && thin.size() <= kFewThin) misses.insert(misses.end(), thin.begin(), thin.end());
  return misses;
}

bool isThin(const SurfaceGrid& grid, const Coord& at) {
  const std::optional<std::uint32_t> cell = grid.cellAt(at);
  return cell && (grid.traits(*cell) & kThin) != 0;
}

/// What cells took.
struct Work {
  std::size_t cells = 0, asked = 0;
  bool tooMuch() const { return asked > std::min(kMostAsked, kAskedFirst + cells * kAskedACell); }
};

/// What cells are beyond what is under the surface, in parts of a cell. Empty where it takes too much.
/// `work`: what others took, and receives this.
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
    // What all will take, if the others take as much as these.
    if (Work{work.cells + cells.size(), work.asked + sum * cells.size() / end}.tooMuch()) return std::nullopt;
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

void count(const SurfaceGrid& grid, const Coord& cell, ThinCells& thin) {
  if (isThin(grid, cell) || thin.count++ > 0) return;
  thin.first = grid.impl().position(cell) + Vec3::Constant(0.5 * grid.impl().h);
}

}  // namespace

UnseenVolume unseenVolume(const SurfaceGrid& grid, Progress& progress) {
  const Stock::Impl& impl = grid.impl();
  const double cell = impl.h * impl.h * impl.h;
  const bool known = impl.cut != nullptr && impl.cut_blank != nullptr;
  std::vector<Coord> cells = doubtfulCells(grid, known);
  const UnseenVolume unknown{.error_mm3 = kUnknown * cell * static_cast<double>(cells.size())};
  if (!known || cells.size() > kMostDoubtful) return unknown;
  UnseenVolume out;
  Places seen(cells.begin(), cells.end());
  Work work;
  while (!cells.empty()) {
    const std::optional<std::vector<double>> found = missedIn(cells, grid, work, progress);
    if (!found) return unknown;
    const std::vector<double>& missed = *found;
    std::vector<Coord> next;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (std::abs(missed[i]) < kLittle) continue;
      out.mm3 += missed[i];
      out.error_mm3 += kUnsure * std::abs(missed[i]);
      if (std::abs(missed[i]) >= kMuch) count(grid, cells[i], out.thin);
      if (std::abs(missed[i]) >= kSpreads) addBeside(cells[i], seen, next);
    }
    cells = std::move(next);
  }
  if (progress.cancelled()) return {};
  out.mm3 *= cell;
  out.error_mm3 *= cell;
  return out;
}

}  // namespace proveout
