// The surface of a turned part with threads as a triangle mesh, from half section to half section.
#pragma once

#include <optional>

#include "core/base/progress.h"
#include "core/mesh/tri_mesh.h"
#include "removal/turning/section/section.h"

namespace proveout {

struct ThreadedSurface {
  TriMesh mesh;               ///< closed and oriented
  double volume_mm3 = 0.0;    ///< from the half sections, not from the mesh
  double deviation_mm = 0.0;  ///< how far the mesh may be from the surface
};

/// A body turned about Z less what the thread tools sweep through. Edges along the helices and about Z are
/// exact at every half section; between two of them facets are off by at most `tolerance` mm, and so are
/// borders and outlines. Nothing where the sections do not go over into each other, as when a thread cuts a
/// piece free, or would be too many, or the mesh would meet itself at a feather; or the work was cancelled.
std::optional<ThreadedSurface> threadedSurface(const SectionBody& body,
                                               const std::vector<ThreadSweep>& threads, double tolerance,
                                               const Progress& progress);

/// Volume of the same, mm3, whatever its sections do.
double threadedVolume(const SectionBody& body, const std::vector<ThreadSweep>& threads);

}  // namespace proveout
