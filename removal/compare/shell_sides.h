// Which side of a mesh is outside.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/mesh/shells.h"

namespace proveout {

/// What was done to make facets agree.
struct TurnedFacets {
  std::size_t turned = 0;
  /// A flag for each triangle: whether about as much of its sheet was turned as was not, so that it cannot be
  /// told which way the sheet was meant.
  std::vector<char> doubtful;
};

/// Turns facets so that they agree with the larger part, by area, of those that hang together with them.
/// Where solids share an edge, facets that hang together elsewhere belong together. None where a surface has
/// one side only; whether the mesh can be oriented at edges of many facets is not judged.
std::optional<TurnedFacets> makeConsistent(TriMesh& mesh);

/// What was done to turn shells.
struct TurnedShells {
  std::size_t turned = 0;
  std::size_t within = 0;            ///< outward shells inside of the material of others
  Vec3 first_within = Vec3::Zero();  ///< a place of the first of these, mm
};

/// Shells face as they are in the file, as long as each void is in a body: a shell that faces inward where
/// there is no material around it is turned, and all shells in it with it. `doubtful`: a flag for each
/// triangle, or empty. Errors, kInput: a doubtful shell inside of a body, which may be a body or a void.
Result<TurnedShells> orientShells(Shells& shells, const std::vector<char>& doubtful, const std::string& name);

}  // namespace proveout
