// The nominal, as a file brings it.
#pragma once

#include <string>

#include "core/base/diagnostics.h"
#include "io/job.h"
#include "removal/compare/nominal.h"

namespace proveout {

/// Adds what was repaired in a mesh as warnings with the given code.
void noteRepairs(const PreparedMesh& mesh, const std::string& code, Diagnostics& diagnostics);

/// Reads the nominal mesh and makes a solid of it; what was repaired becomes warnings.
Result<PreparedMesh> loadNominal(const NominalSpec& nominal);

}  // namespace proveout
