#include "removal/surface/cell/cell_cycles.h"

#include <numeric>

namespace proveout {

namespace {

struct Tables {
  std::array<std::array<int, 8>, 3> edge_at{};  // [axis][corner]
  std::array<int, 12> start{};
};

constexpr Tables makeTables() {
  Tables t;
  for (int axis = 0; axis < 3; ++axis) {
    int k = 0;
    for (int corner = 0; corner < 8; ++corner) {
      if (corner >> axis & 1) {
        t.edge_at[axis][corner] = -1;
        continue;
      }
      t.edge_at[axis][corner] = axis * 4 + k;
      t.start[axis * 4 + k] = corner;
      ++k;
    }
  }
  return t;
}

constexpr Tables kTables = makeTables();

/// The edge between two neighbouring corners.
int edgeBetween(int a, int b) {
  const int axis = (a ^ b) == 1 ? 0 : ((a ^ b) == 2 ? 1 : 2);
  return kTables.edge_at[axis][a & b];
}

/// Joins crossed edges pairwise across one face; `parent` is a union-find forest.
class Joiner {
 public:
  explicit Joiner(CellShape shape) : shape_(shape) { std::iota(parent_.begin(), parent_.end(), 0); }

  void joinFace(int axis, int side) {
    const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3, base = side << axis;
    const int ring[4] = {base, base | u, base | u | v, base | v};
    int crossed[4], count = 0;
    for (int i = 0; i < 4; ++i) {
      if (inside(ring[i]) != inside(ring[(i + 1) % 4]))
        crossed[count++] = edgeBetween(ring[i], ring[(i + 1) % 4]);
    }
    if (count == 2) {
      join(crossed[0], crossed[1]);
    } else if (count == 4) {
      const bool joined = isJoined(shape_, axis, side);
      for (int i = 0; i < 4; ++i) {
        if (inside(ring[i]) != joined)
          join(edgeBetween(ring[(i + 3) % 4], ring[i]), edgeBetween(ring[i], ring[(i + 1) % 4]));
      }
    }
  }

  CellCycles cycles() {
    CellCycles result;
    std::array<int, 12> number;
    number.fill(-1);
    for (int e = 0; e < 12; ++e) {
      const int start = kTables.start[e];
      if (inside(start) == inside(start | 1 << e / 4)) {
        result.cycle_of_edge[e] = -1;
        continue;
      }
      int& n = number[find(e)];
      if (n < 0) n = result.count++;
      result.cycle_of_edge[e] = static_cast<std::int8_t>(n);
    }
    return result;
  }

 private:
  bool inside(int corner) const { return (shape_ >> corner & 1) != 0; }
  int find(int e) const { return parent_[e] == e ? e : find(parent_[e]); }
  void join(int a, int b) { parent_[find(a)] = find(b); }

  CellShape shape_;
  std::array<int, 12> parent_{};
};

CellCycles findCycles(CellShape shape) {
  Joiner joiner(shape);
  for (int axis = 0; axis < 3; ++axis) {
    joiner.joinFace(axis, 0);
    joiner.joinFace(axis, 1);
  }
  return joiner.cycles();
}

std::uint8_t findDoubtfulFaces(CellShape shape) {
  std::uint8_t out = 0;
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2, u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3, base = (face & 1) << axis;
    const int a = shape >> base & 1, b = shape >> (base | u) & 1, c = shape >> (base | u | v) & 1,
              d = shape >> (base | v) & 1;
    if (a == c && b == d && a != b) out |= static_cast<std::uint8_t>(1 << face);
  }
  return out;
}

}  // namespace

CellCycles cellCycles(CellShape shape) {
  static const auto kCycles = tableOfPatterns<CellCycles>(findCycles);
  return shape < kPatterns ? kCycles[shape] : findCycles(shape);
}

const std::array<std::uint8_t, kPatterns>& doubtfulFaces() {
  static const auto kFaces = tableOfPatterns<std::uint8_t>(findDoubtfulFaces);
  return kFaces;
}

int edgeStartCorner(int edge) { return kTables.start[edge]; }
int edgeAt(int axis, int corner) { return kTables.edge_at[axis][corner]; }

}  // namespace proveout
