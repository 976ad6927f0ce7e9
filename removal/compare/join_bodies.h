// Solids of one mesh that touch or overlap, made one.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/mesh/shells.h"

namespace proveout {

/// What became of the bodies of a mesh.
struct JoinedBodies {
  TriMesh mesh;
  std::size_t joined = 0;               ///< bodies that were made one with others
  bool changed = false;                 ///< by that, or by cutting voids out that reach the surface
  std::vector<std::string> notes = {};  ///< gaps between bodies, one sentence each
};

/// Models of several bodies have faces where the bodies meet that no part has: a comparison would take them
/// for surface. Joins the shells that share area, run into each other or lie in each other (CGAL's exact
/// booleans), and those whose faces stand no farther apart than 0.005 mm; what touches along an edge or at a
/// vertex stays apart. `name` stands in front of messages. Requires shells that are oriented: outward, voids
/// inward. Errors, kInput: bodies that cannot be joined, faces inside of the material (with their place).
Result<JoinedBodies> joinBodies(const Shells& shells, const std::string& name);

}  // namespace proveout
