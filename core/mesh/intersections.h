// Triangles of a mesh that run through each other.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace proveout {

/// Pairs of triangles that meet elsewhere than in their common corners, at least one of them with a corner
/// that is a suspect (a flag for each vertex). Each pair once, the lower number first, in order. In double
/// precision: triangles that touch within rounding may be told either way. Fast where triangles with
/// following numbers are close together.
std::vector<std::array<std::uint32_t, 2>> findIntersections(const TriMesh& mesh,
                                                            std::span<const std::uint8_t> suspect);
/// Those of which at least one triangle has a flag.
std::vector<std::array<std::uint32_t, 2>> findIntersectionsOf(const TriMesh& mesh,
                                                              std::span<const std::uint8_t> triangles);
/// Those among some triangles, given by their numbers: fast where numbers that follow are close together.
std::vector<std::array<std::uint32_t, 2>> findIntersectionsAmong(const TriMesh& mesh,
                                                                 std::span<const std::uint32_t> triangles);

/// Where the triangles of each pair run through each other: the box that both are in, `reach` mm wider.
std::vector<Box3> meetingPlaces(const TriMesh& mesh, const std::vector<std::array<std::uint32_t, 2>>& pairs,
                                double reach);
/// Flags the vertices that are in one of the boxes.
void flagInside(const TriMesh& mesh, const std::vector<Box3>& boxes, std::vector<std::uint8_t>& flags);

/// Corners of a triangle, for exacter sums than its floats allow.
std::array<Vec3, 3> cornersOf(const TriMesh& mesh, std::uint32_t t);
/// Whether two triangles of the mesh meet elsewhere than in their common corners; s < t.
bool trianglesMeet(const TriMesh& mesh, std::uint32_t s, std::uint32_t t);
/// Whether a triangle is a line, as good as.
bool isNeedle(const TriMesh& mesh, std::uint32_t t);

}  // namespace proveout
