// Points on the command line, and what it says of the nominal: where it lies, which body it is.
#pragma once

#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/geometry/types.h"
#include "io/job/job.h"

namespace proveout {

/// As given: --nominal-at, --nominal-rotate, --nominal-body.
struct NominalOptions {
  std::optional<std::string> at;      ///< "X,Y,Z": where the origin of the nominal's file lies, mm
  std::optional<std::string> rotate;  ///< "A,B,C": turns about fixed X, Y and Z, degrees
  std::optional<std::string> body;    ///< of a STEP file: name or number
  bool given() const { return at || rotate || body; }
};

/// Three finite numbers with commas between, each within `most`. Errors: what is no such text, with the
/// option's name and `what` it should be.
Result<Vec3> parseTriple(const std::string& option, const std::string& text, double most,
                         const std::string& what);

/// Puts what is given in place of what the nominal has. Errors: no such point or angles, a body of a mesh.
Status applyNominal(const NominalOptions& options, NominalSpec& nominal);

}  // namespace proveout
