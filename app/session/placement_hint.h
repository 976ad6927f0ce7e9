// Meshes in the wrong unit or at the wrong place: what would bring them right.
#pragma once

#include <optional>
#include <string>

#include "core/geometry/types.h"
#include "io/mesh_io.h"

namespace proveout {

/// A change of a mesh: scaled about the origin, then moved.
struct Placement {
  double scale = 1.0;
  Vec3 shift = Vec3::Zero();  ///< mm
};

/// The change that brings bounds onto others, where it is evident: the sizes along X, Y and Z agree within 1
/// % as they are or times 25.4, 1/25.4, 1000 or 1/1000. None where they do not, and where the bounds agree
/// already (to 1 % of the longest side).
std::optional<Placement> evidentPlacement(const Box3& body, const Box3& wanted);

/// "scaled by 25.4 (unit \"inch\") it would agree with WANTED", "moved by X.. Y.. Z.. ..."; `unit`: that the
/// mesh was read with.
std::string placementText(const Placement& placement, MeshUnit unit, const std::string& wanted);

}  // namespace proveout
