// Points on the command line, and where the nominal lies as it says.
#pragma once

#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/geometry/types.h"
#include "core/mesh/mesh_placement.h"

namespace proveout {

/// As given: --nominal-at and --nominal-rotate.
struct NominalOptions {
  std::optional<std::string> at;      ///< "X,Y,Z": where the origin of the nominal's file lies, mm
  std::optional<std::string> rotate;  ///< "A,B,C": turns about fixed X, Y and Z, degrees
  bool given() const { return at || rotate; }
};

/// Three finite numbers with commas between, each within `most`. Errors: what is no such text, with the
/// option's name and `what` it should be.
Result<Vec3> parseTriple(const std::string& option, const std::string& text, double most,
                         const std::string& what);

/// Puts what is given in place of what the placement says.
Status applyPlacement(const NominalOptions& options, MeshPlacement& placement);

}  // namespace proveout
