#include "removal/vdb/vdb_module.h"

#include "removal/vdb/vdb_support.h"

const proveout::VdbSupport* proveoutVdbSupport() {
  static constexpr proveout::VdbSupport kSupport{proveout::writeStockFile, proveout::readStockFile,
                                                 proveout::rasteriseMesh};
  return &kSupport;
}
