// What needs OpenVDB: stock files and the rasteriser of mesh blanks. It stands in a module of its own that is
// loaded when it is asked for, because OpenVDB's library alone takes 30 MB and 40 ms of every start.
#pragma once

#include <string>

#include "removal/grid/stock_impl.h"

namespace proveout {

struct VdbSupport {
  /// Writes grid, crossings and provenance; whole file or none.
  Status (*save)(const Stock::Impl& impl, const std::string& path);
  /// Reads what save wrote into an empty Impl. Errors: no such file, damaged, not a stock that save could
  /// have written (says what is wrong), more memory than is allowed.
  Status (*load)(Stock::Impl& impl, const std::string& path, const RemovalOptions& options);
  /// Fills an empty Impl (h, origin and blank set, index made) with a closed mesh. Errors: open, inside out
  /// or empty (names the place), too large.
  Status (*mesh_blank)(Stock::Impl& impl, const MeshShape& shape, const RemovalOptions& options);
};

/// Loads the module on first use. It is looked for beside the program (../lib/proveout) and where it was
/// installed.
Result<const VdbSupport*> vdbSupport();

}  // namespace proveout

/// The module's only symbol.
extern "C" const proveout::VdbSupport* proveoutVdbSupport();
