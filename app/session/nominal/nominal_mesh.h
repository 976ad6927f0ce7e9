// The nominal, blanks and fixtures, as files bring them.
#pragma once

#include <string>
#include <vector>

#include "core/base/diagnostics.h"
#include "io/job/job.h"
#include "removal/compare/nominal.h"

namespace proveout {

/// Adds warnings of one code: what was repaired in a mesh or is doubtful about it, one sentence each.
void addMeshWarnings(const std::vector<std::string>& texts, const std::string& code,
                     Diagnostics& diagnostics);

/// Reads the nominal mesh, puts it where the job says and makes a solid of it; what was repaired becomes
/// warnings.
Result<PreparedMesh> loadNominal(const NominalSpec& nominal);

/// A blank or a fixture.
struct LoadedSolid {
  StockShape shape;
  std::vector<std::string> repairs;  ///< of a mesh, one sentence each, for a warning
};
/// Reads what the shape is from; a mesh becomes a solid as the nominal does.
Result<LoadedSolid> loadSolid(const StockSpec& spec);

}  // namespace proveout
