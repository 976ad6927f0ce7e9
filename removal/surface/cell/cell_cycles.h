// How the surface runs through a grid cell: the crossed edges of a cell, joined to closed cycles, one per
// sheet of surface. Each cycle becomes one vertex of the dual mesh, so that sheets that meet in a cell stay
// apart (2-manifold always).
//
// Corner c of a cell is at (c & 1, c >> 1 & 1, c >> 2 & 1). Edge e = axis * 4 + k runs along `axis` from the
// k-th of the four corners that have 0 on that axis, in order of their number. Face f = axis * 2 + side. On a
// face whose four edges are all crossed the material corners are cut off singly, or, where the face is
// joined, the others; both cells of the face see the same.
#pragma once

#include <array>
#include <cstdint>

namespace proveout {

struct CellCycles {
  std::uint8_t count = 0;                       ///< 0..4
  std::array<std::int8_t, 12> cycle_of_edge{};  ///< -1: not crossed
};

/// What is known of a cell's corners and faces. Bit c: corner c is in material; bit kJoinedFaces + f: face f,
/// whose four edges are all crossed, is joined.
using CellShape = std::uint16_t;
inline constexpr int kJoinedFaces = 8;
inline constexpr int kPatterns = 1 << kJoinedFaces;  ///< shapes without joined faces
inline bool isJoined(CellShape shape, int axis, int side) {
  return (shape >> (kJoinedFaces + axis * 2 + side) & 1) != 0;
}
/// find(shape) of all shapes without joined faces.
template <typename Value, typename Find>
std::array<Value, kPatterns> tableOfPatterns(const Find& find) {
  std::array<Value, kPatterns> table;
  for (int pattern = 0; pattern < kPatterns; ++pattern)
    table[pattern] = find(static_cast<CellShape>(pattern));
  return table;
}

CellCycles cellCycles(CellShape shape);
/// Faces whose four edges are all crossed, as bits, for each pattern of material corners.
const std::array<std::uint8_t, kPatterns>& doubtfulFaces();

/// Corner at the start of edge e.
int edgeStartCorner(int edge);
/// The edge along `axis` that starts at `corner` (which has 0 on that axis).
int edgeAt(int axis, int corner);

}  // namespace proveout
