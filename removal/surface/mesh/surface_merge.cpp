#include "removal/surface/mesh/surface_merge.h"

#include <algorithm>
#include <numeric>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"
#include "core/geometry/to_float.h"
#include "removal/grid/leaf_layers.h"

namespace proveout {

namespace {

constexpr int kLevels = 3;  ///< cubes of 16, 32 and 64 cells
/// Leaves of one cube have their mean normals within 6 degrees of the cube's.
constexpr float kLeafConeCos = 0.9945f;
/// The first of the four cells around the middle of a level leaf.
constexpr std::uint32_t kLevelMiddle = 27;

Coord cubeOrigin(const Coord& at, int level) {
  const int mask = ~((8 << level) - 1);
  return {at.x() & mask, at.y() & mask, at.z() & mask};
}

Coord offset(const Coord& of, const Coord& from) { return of.offsetBy(-from.x(), -from.y(), -from.z()); }

/// Squared distance of a point from the cells of the leaf at `at`, less rounding, in grid steps.
float outOfLeaf2(const Eigen::Vector3f& p, const Coord& at) {
  constexpr float kRounding = 1e-3f, kEdge = 8.0f + kRounding;
  const Eigen::Array3f d = p.array() - Eigen::Array3f(toFloat(at.x()), toFloat(at.y()), toFloat(at.z()));
  return (-kRounding - d).max(d - kEdge).max(0.0f).square().sum();
}

int find(std::vector<int>& parent, int i) {
  while (parent[static_cast<std::size_t>(i)] != i) i = parent[static_cast<std::size_t>(i)];
  return i;
}

/// Calls body(number) for each leaf with surface in the cube of 8 << level cells that holds the leaf at
/// `inside`, in the order of their places, until it returns false.
template <typename Body>
void forEachLeafOfCube(const LeafReader& read, const Coord& inside, int level, Body&& body) {
  const Coord origin = cubeOrigin(inside, level);
  const int side = 1 << level;
  for (int i = 0; i < side * side * side; ++i) {
    const std::int32_t n =
        read.state(origin.offsetBy(i / (side * side) * 8, i / side % side * 8, i % side * 8));
    if (n >= 0 && !body(n)) return;
  }
}

}  // namespace

/// The leaves of the cube of 8 << level cells, in their order, if `leaf` is the first of them and all are
/// merged to cubes of 8 << above; else none.
std::vector<std::int32_t> VertexMerger::leavesOf(const LeafReader& read, const SurfaceLeaf& leaf, int level,
                                                 int above) const {
  std::vector<std::int32_t> found;
  bool all = true;
  forEachLeafOfCube(read, leaf.stock->origin, level, [&](std::int32_t n) {
    const SurfaceLeaf& there = grid_.leaves()[static_cast<std::size_t>(n)];
    if (found.empty() && &there != &leaf) return all = false;
    if (!there.clusters.eight || there.clusters.above != above) return all = false;
    found.push_back(n);
    return true;
  });
  return all ? found : std::vector<std::int32_t>{};
}

/// Whether the leaves of a cube are the square of one level face through it, which is flat and a disk.
bool VertexMerger::isLevelSquare(const std::vector<std::int32_t>& leaves, int level) const {
  const SurfaceLeaf& first = grid_.leaves()[static_cast<std::size_t>(leaves[0])];
  if (leaves.size() != std::size_t{1} << 2 * level || !first.all_level) return false;
  return std::ranges::all_of(leaves, [&](std::int32_t n) {
    const SurfaceLeaf& leaf = grid_.leaves()[static_cast<std::size_t>(n)];
    const Coord d = offset(leaf.stock->origin, first.stock->origin);
    const std::array<int, 3> steps = {d.x(), d.y(), d.z()};
    return leaf.all_level && leaf.level == first.level &&
           steps[static_cast<std::size_t>(first.level.axis)] == 0;
  });
}

bool VertexMerger::isFlat(const std::vector<std::int32_t>& leaves, int level) const {
  const float flat = toFloat(flatness_), span = toFloat(8 << level);
  Eigen::Vector3f n = Eigen::Vector3f::Zero();
  for (const std::int32_t i : leaves) {
    const SurfaceLeaf& leaf = grid_.leaves()[static_cast<std::size_t>(i)];
    n += leaf.clusters.normal * toFloat(leaf.cells);
  }
  n.normalize();
  const Coord first = grid_.leaves()[static_cast<std::size_t>(leaves[0])].stock->origin;
  float low = 1e9f, high = -1e9f;
  for (const std::int32_t i : leaves) {
    const SurfaceLeaf& leaf = grid_.leaves()[static_cast<std::size_t>(i)];
    // Heights alone miss a bow to which the vertices are symmetric; normals show it. 4 * half of the side.
    const float lean2 = (n - leaf.clusters.normal).squaredNorm();
    if (n.dot(leaf.clusters.normal) < kLeafConeCos || lean2 * span * span > 4.0f * flat * flat) return false;
    const Coord d = offset(leaf.stock->origin, first);
    const float base = n.dot(Eigen::Vector3f(toFloat(d.x()), toFloat(d.y()), toFloat(d.z())));
    for (std::uint32_t k = 0; k < leaf.cells; ++k) {
      const float h = base + n.dot(grid_.vertex(leaf.base + k));
      low = std::min(low, h);
      high = std::max(high, h);
    }
    if (high - low > toFloat(flatness_)) return false;
  }
  return true;
}

/// For a disk, cells less connections plus crossed edges inside the cube must be 1, and the leaves must be
/// connected.
bool VertexMerger::isDisk(const std::vector<std::int32_t>& leaves, int level) const {
  std::vector<int> parent(leaves.size());
  std::iota(parent.begin(), parent.end(), 0);
  int euler = 0, parts = static_cast<int>(leaves.size());
  const int last = (1 << level) - 1;
  for (std::size_t k = 0; k < leaves.size(); ++k) {
    const SurfaceLeaf& leaf = grid_.leaves()[static_cast<std::size_t>(leaves[k])];
    const std::array<LeafBits, 3> faces = crossedFaces(grid_.blockBits(leaf));
    const Coord at = offset(leaf.stock->origin, cubeOrigin(leaf.stock->origin, level));
    const int px = at.x() >> 3, py = at.y() >> 3, pz = at.z() >> 3;
    const std::uint64_t low_x = px == last ? ~kColumnX7 : ~0ull, low_y = py == last ? ~kColumnY7 : ~0ull;
    const std::uint64_t high_x = px == 0 ? ~kColumnX0 : ~0ull, high_y = py == 0 ? ~kColumnY0 : ~0ull;
    std::array<std::uint64_t, 3> over{};
    for (int z = 0; z < 8; ++z) {
      euler -= countBits(faces[0][z] & low_x) + countBits(faces[1][z] & low_y);
      if (z < 7 || pz < last) euler -= countBits(faces[2][z]);
      euler += countBits(leaf.edges.crossed[2][z] & high_x & high_y);
      if (z > 0 || pz > 0) {
        euler += countBits(leaf.edges.crossed[0][z] & high_y) + countBits(leaf.edges.crossed[1][z] & high_x);
      }
      over[0] |= faces[0][z] & low_x & kColumnX7;
      over[1] |= faces[1][z] & low_y & kColumnY7;
    }
    over[2] = pz < last ? faces[2][7] : 0;
    euler += leaf.cells;
    for (int axis = 0; axis < 3; ++axis) {
      const auto there = std::lower_bound(leaves.begin(), leaves.end(), leaf.upper[1 << axis]);
      if (over[axis] == 0 || there == leaves.end() || *there != leaf.upper[1 << axis]) continue;
      const int a = find(parent, static_cast<int>(k)),
                b = find(parent, static_cast<int>(there - leaves.begin()));
      if (a == b) continue;
      parent[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
      --parts;
    }
  }
  return euler == 1 && parts == 1;
}

VertexMerger::VertexMerger(SurfaceGrid& grid, double flatness) : grid_(grid), flatness_(flatness) {
  if (!active()) return;
  mergeLeaves();
  partAroundDetails();
  count_ = static_cast<std::uint32_t>(grid_.cellCount());
  stand_in_ = std::make_unique_for_overwrite<std::uint32_t[]>(count_);
  assign(allLeaves());
}

std::vector<std::int32_t> VertexMerger::allLeaves() const {
  std::vector<std::int32_t> all(grid_.leaves().size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

/// Merges whole leaves to larger cubes.
void VertexMerger::mergeLeaves() {
  auto& leaves = grid_.leaves();
  for (int level = 1; level <= kLevels; ++level) {
    std::vector<std::vector<std::int32_t>> cubes(leaves.size());
    parallelFor(std::size_t{0}, leaves.size(), [&](std::size_t i) {
      if (!leaves[i].clusters.eight || leaves[i].clusters.above != level - 1) return;
      const LeafReader read(grid_.impl());
      std::vector<std::int32_t> cube = leavesOf(read, leaves[i], level, level - 1);
      if (cube.empty()) return;
      if (isLevelSquare(cube, level) || (isFlat(cube, level) && isDisk(cube, level)))
        cubes[i] = std::move(cube);
    });
    for (const auto& cube : cubes) {
      for (const std::int32_t n : cube)
        leaves[static_cast<std::size_t>(n)].clusters.above = static_cast<std::uint8_t>(level);
    }
  }
}

void VertexMerger::assignCube(const SurfaceLeaf& leaf, const CellCube& cube) {
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  std::array<std::uint32_t, 512> cells;
  int count = 0;
  for (int z = cube.z0; z < cube.z0 + cube.size; ++z) {
    for (std::uint64_t rest = leaf.mixed[z] & cube.columns; rest != 0; rest &= rest - 1) {
      const std::uint64_t below = (rest & (~rest + 1)) - 1;
      const std::uint32_t cell =
          leaf.base + leaf.first_cell[z] + static_cast<std::uint32_t>(countBits(leaf.mixed[z] & below));
      cells[count++] = cell;
      sum += grid_.vertex(cell);
    }
  }
  if (count < 2) return;
  sum /= toFloat(count);
  const auto* nearest =
      std::min_element(cells.begin(), cells.begin() + count, [&](std::uint32_t a, std::uint32_t b) {
        return (grid_.vertex(a) - sum).squaredNorm() < (grid_.vertex(b) - sum).squaredNorm();
      });
  for (int i = 0; i < count; ++i) stand_in_[cells[i]] = *nearest | kMerged;
}

void VertexMerger::assignLeaf(const SurfaceLeaf& leaf) {
  if (leaf.all_level && leaf.clusters.eight) {
    std::fill_n(stand_in_.get() + leaf.base, leaf.cells, (leaf.base + kLevelMiddle) | kMerged);
    return;
  }
  for (std::uint32_t k = 0; k < leaf.cells; ++k) stand_in_[leaf.base + k] = leaf.base + k;
  if (leaf.clusters.eight) return assignCube(leaf, CellCube{});
  for (int four = 0; four < 8; ++four) {
    const int z4 = (four >> 2) * 4, x4 = (four >> 1 & 1) * 4, y4 = (four & 1) * 4;
    if (leaf.clusters.four >> four & 1) {
      assignCube(leaf, cubeAt(4, x4, y4, z4));
      continue;
    }
    for (int two = 0; two < 8; ++two) {
      const int z = z4 + (two >> 2) * 2, x = x4 + (two >> 1 & 1) * 2, y = y4 + (two & 1) * 2;
      if (leaf.clusters.two >> (z / 2 * 16 + x / 2 * 4 + y / 2) & 1) assignCube(leaf, cubeAt(2, x, y, z));
    }
  }
}

/// The vertex nearest to the middle of all.
std::uint32_t VertexMerger::middleOf(const std::vector<std::int32_t>& leaves) const {
  const auto& all = grid_.leaves();
  const Coord first = all[static_cast<std::size_t>(leaves[0])].stock->origin;
  const auto place = [&](const SurfaceLeaf& leaf, std::uint32_t cell) {
    const Coord d = offset(leaf.stock->origin, first);
    return Eigen::Vector3f(grid_.vertex(cell) +
                           Eigen::Vector3f(toFloat(d.x()), toFloat(d.y()), toFloat(d.z())));
  };
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  float count = 0.0f;
  for (const std::int32_t n : leaves) {
    const SurfaceLeaf& leaf = all[static_cast<std::size_t>(n)];
    sum += place(leaf, stand_in_[leaf.base] & ~kMerged) * leaf.cells;
    count += leaf.cells;
  }
  sum /= count;
  std::uint32_t best = 0;
  float least = std::numeric_limits<float>::infinity(), nearest = least;
  for (const std::int32_t n : leaves) {
    const SurfaceLeaf& leaf = all[static_cast<std::size_t>(n)];
    nearest = std::min(nearest, (place(leaf, stand_in_[leaf.base] & ~kMerged) - sum).squaredNorm());
  }
  for (const std::int32_t n : leaves) {
    const SurfaceLeaf& leaf = all[static_cast<std::size_t>(n)];
    if (outOfLeaf2(sum, offset(leaf.stock->origin, first)) > nearest) continue;
    for (std::uint32_t k = 0; k < leaf.cells; ++k) {
      const float d = (place(leaf, leaf.base + k) - sum).squaredNorm();
      if (d < least) least = d, best = leaf.base + k;
    }
  }
  return best;
}

/// Whether each vertex that stands for others stands for itself as well.
bool VertexMerger::standForThemselves() const {
  for (std::uint32_t cell = 0; cell < count_; ++cell) {
    if (standIn(standIn(cell)) != standIn(cell)) return false;
  }
  return true;
}

/// Chooses the vertex of each cube of these leaves.
void VertexMerger::assign(const std::vector<std::int32_t>& changed) {
  auto& leaves = grid_.leaves();
  const auto eachLeaf = [&](auto&& body) {
    parallelFor(std::size_t{0}, changed.size(),
                [&](std::size_t i) { body(leaves[static_cast<std::size_t>(changed[i])]); });
  };
  eachLeaf([&](const SurfaceLeaf& leaf) { assignLeaf(leaf); });
  eachLeaf([&](const SurfaceLeaf& first) {
    const int level = first.clusters.above;
    if (level == 0) return;
    const std::vector<std::int32_t> cube = leavesOf(LeafReader(grid_.impl()), first, level, level);
    if (cube.empty()) return;
    const std::uint32_t middle = middleOf(cube) | kMerged;
    for (const std::int32_t n : cube) {
      const SurfaceLeaf& leaf = leaves[static_cast<std::size_t>(n)];
      std::fill_n(stand_in_.get() + leaf.base, leaf.cells, middle);
    }
  });
  PROVEOUT_ASSERT_DEAR(standForThemselves());
}

std::vector<std::int32_t> VertexMerger::giveUp() {
  for (SurfaceLeaf& leaf : grid_.leaves()) leaf.clusters = LeafClusters{};
  std::vector<std::int32_t> all = allLeaves();
  assign(all);
  return all;
}

/// Takes the cube of a cell apart to the next smaller ones; adds the leaves that this changed, maybe
/// repeatedly. False: the cell is not merged.
bool VertexMerger::takeCellApart(std::size_t number, int place, std::vector<std::int32_t>& changed) {
  auto& leaves = grid_.leaves();
  SurfaceLeaf& leaf = leaves[number];
  const int x = place >> 3 & 7, y = place & 7, z = place >> 6;
  const int four = 1 << (z / 4 * 4 + x / 4 * 2 + y / 4);
  const std::uint64_t two = 1ull << (z / 2 * 16 + x / 2 * 4 + y / 2);
  if (const int level = leaf.clusters.above; level > 0) {
    forEachLeafOfCube(LeafReader(grid_.impl()), leaf.stock->origin, level, [&](std::int32_t n) {
      leaves[static_cast<std::size_t>(n)].clusters.above = static_cast<std::uint8_t>(level - 1);
      changed.push_back(n);
      return true;
    });
  } else if (leaf.clusters.eight) {
    leaf.clusters.eight = false;
  } else if ((leaf.clusters.four & four) != 0) {
    leaf.clusters.four &= static_cast<std::uint8_t>(~four);
  } else if ((leaf.clusters.two & two) != 0) {
    leaf.clusters.two &= ~two;
  } else {
    return false;
  }
  changed.push_back(static_cast<std::int32_t>(number));
  return true;
}

/// Merges nothing where walls are set in or sheets are parted, so that the mesh there is the same whatever
/// the tolerance.
void VertexMerger::partAroundDetails() {
  for (const SurfaceLeaf& leaf : grid_.leaves()) {
    for (const StepCell& step : leaf.steps) partAround(leaf, leaf.placeOf(step.cell));
    for (const ExtraVertex& extra : leaf.extra) partAround(leaf, leaf.placeOf(extra.cell));
  }
}

/// Merges neither the cell at a place of a leaf nor those beside it.
void VertexMerger::partAround(const SurfaceLeaf& leaf, int place) {
  const LeafReader read(grid_.impl());
  const Coord at = leaf.stock->origin.offsetBy(place >> 3 & 7, place & 7, place >> 6);
  std::vector<std::int32_t> changed;
  for (int k = 0; k < 27; ++k) {
    const Coord beside = at.offsetBy(k / 9 - 1, k / 3 % 3 - 1, k % 3 - 1);
    const std::int32_t n = read.state(beside);
    if (n < 0) continue;
    const int there = (beside.z() & 7) << 6 | leafBit(beside.x() & 7, beside.y() & 7);
    while (takeCellApart(static_cast<std::size_t>(n), there, changed)) {
    }
  }
}

std::vector<std::int32_t> VertexMerger::takeApart(std::vector<std::uint32_t> cells) {
  for (std::uint32_t& cell : cells) cell = standIn(cell);
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  std::vector<std::int32_t> changed;
  for (const std::uint32_t cell : cells) {
    const std::size_t number = grid_.leafOf(cell);
    const SurfaceLeaf& leaf = grid_.leaves()[number];
    PROVEOUT_ASSERT(cell >= leaf.base && cell - leaf.base < leaf.cells);
    takeCellApart(number, leaf.placeOf(static_cast<int>(cell - leaf.base)), changed);
  }
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  assign(changed);
  return changed;
}

}  // namespace proveout
