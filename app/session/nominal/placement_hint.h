// Meshes in the wrong unit or at the wrong place: what would bring them right.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/geometry/types.h"
#include "core/mesh/mesh_placement.h"
#include "io/mesh_io.h"

namespace proveout {

/// Factors by which units are mistaken: 1 first, then 25.4, 1000 and their inverses.
inline constexpr double kUnitFactors[] = {1.0, 25.4, 1.0 / 25.4, 1000.0, 1.0 / 1000.0};

/// The 24 turns that take the axes onto each other, as angles about fixed X, Y and Z; none first, then those
/// about one axis, then the others.
const std::vector<Vec3>& quarterTurns();

/// Whether the sizes along X, Y and Z agree within 1 %, and the places within 1 % of the longest side.
bool boundsAgree(const Box3& body, const Box3& wanted);

/// The change that brings bounds onto others, where it is evident: the sizes along X, Y and Z agree
/// within 1 % as they are, in another unit, or turned by quarters; of several the first in the order of
/// factors and turns. None where they do not, and where the bounds agree already.
std::optional<MeshPlacement> evidentPlacement(const Box3& body, const Box3& wanted);

/// The bounds of what a placement makes of a box.
Box3 placedBounds(const MeshPlacement& placement, const Box3& box);

/// "scaled by 25.4 (unit "inch" in place of "mm")", "turned by 90 about Z and moved by X.. Y.. Z.."; `unit`:
/// that the mesh was read with.
std::string placementText(const MeshPlacement& placement, MeshUnit unit);

/// The keys of [nominal] that put the mesh there, `rotate = [0, 0, 90], move = [40, 0, 0]`, and as options of
/// the command line, `--nominal-rotate 0,0,90 --nominal-at 40,0,0`. `given`: as the mesh was placed;
/// `change`: on top.
std::string placementKeys(const MeshPlacement& given, const MeshPlacement& change, MeshUnit unit);
std::string placementOptions(const MeshPlacement& given, const MeshPlacement& change);

}  // namespace proveout
