// OpenVDB's tools on the tree and the level set of a saved stock: vdb STOCK.vdb prints the volume by voxels,
// by the level set and by the crossings, and the area by the level set and by the mesh.
#include <openvdb/tools/Count.h>
#include <openvdb/tools/LevelSetMeasure.h>

#include <cstdio>

#include "removal/vdb/vdb_grids.h"

int main(int, char** argv) {
  proveout::Progress progress;
  const auto stock = proveout::Stock::create(proveout::SavedStock{argv[1]}, {}, progress);
  if (!stock) return std::fprintf(stderr, "%s\n", stock.error().message.c_str()), 1;
  const double voxels = static_cast<double>(openvdb::tools::countActiveVoxels(proveout::vdbTree(*stock)));
  const double h = stock->resolution();
  const auto level_set = proveout::levelSet(*stock, 3.0, progress).value();
  const auto surface = stock->surface(0, progress).value();
  std::printf("%.1f;%.1f;%.1f;%.1f;%.1f\n", voxels * h * h * h, openvdb::tools::levelSetVolume(*level_set),
              surface.volume_mm3, openvdb::tools::levelSetArea(*level_set), proveout::meshArea(surface.mesh));
}
