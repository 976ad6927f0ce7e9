// Where the surface's vertex lies in a cell, from the exact crossings and normals of one sheet.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/geometry/types.h"

namespace proveout {

/// One crossing, in units of the cell (0..1 in every coordinate).
struct SheetPoint {
  Vec3 p;
  Vec3 n;              ///< unit, out of the material
  std::uint64_t face;  ///< equal for crossings of one smooth surface (motion and element)
};

/// A vertex and the normals that the smooth faces meeting in its cell have there.
struct CellVertex {
  static constexpr int kMaxFaces = 4;
  Vec3 p = Vec3::Zero();  ///< units of the cell, inside the room that it was given
  bool smooth = false;    ///< one smooth surface runs through the cell
  bool cramped = false;   ///< no point of the room comes near all faces
  int faces = 0;
  std::array<std::uint64_t, kMaxFaces> face{};
  std::array<Vec3, kMaxFaces> normal{};

  /// Normal of the given face at the vertex; `fallback` where the cell did not see that face.
  const Vec3& normalOf(std::uint64_t id, const Vec3& fallback) const;
};

/// On one smooth face: the mean of the crossings, put onto the surface by the rule that the chord between two
/// points of a sphere or cylinder is at right angles to the sum of their normals (third order on other
/// surfaces). Where faces meet: the point of their tangent planes nearest to the mean (edges and corners stay
/// sharp).
/// `room`, which holds the cell (0..1), bounds the vertex: it may reach into neighbours without surface, so
/// that a tip that pokes through a wall of the cell is not cut off.
CellVertex placeVertex(std::span<const SheetPoint> points, const Box3& room);

}  // namespace proveout
