// A fixture beside a workpiece that a wire cuts: what of a path runs into it.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/mesh/signed_distance.h"
#include "core/path/toolpath.h"
#include "core/tool/tool.h"
#include "removal/grid/stock.h"

namespace proveout {

class WireFixture {
 public:
  /// `solid` must outlive it and be closed, with one triangle or more.
  explicit WireFixture(const SurfaceMesh& solid);

  /// A contact (kWire) for each motion on which the threaded wire, without its sparks, comes into the fixture
  /// at any height, however it leans; none that goes in deeper than 0.001 mm is missed. The wire goes on
  /// straight over the whole height of the fixture. Depths and volumes are those at stations of the motion.
  /// Motions without a wire and tools that are no wires are left out. A cancelled run leaves contacts away.
  std::vector<Contact> touches(const Toolpath& path, const std::vector<Tool>& tools,
                               Progress& progress) const;

 private:
  const SurfaceMesh& solid_;
  SignedDistance distance_;
  Box3 bounds_;
};

}  // namespace proveout
