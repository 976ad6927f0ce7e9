// The pictures of a run: named views, the deviation map, the findings.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/tri_mesh.h"
#include "io/report.h"
#include "removal/compare/compare.h"
#include "render/render.h"

namespace proveout {

struct Picture {
  std::string file;   ///< "iso.png"
  std::string title;  ///< "iso", "deviation", "findings"
  std::string png;    ///< bytes of the file
};

struct PictureRequest {
  std::string name;  ///< of the part, for captions
  std::vector<std::string> views = {"iso"};
  ImageSize size;
  int threads = 0;
  std::optional<Vec2> turned_axis;              ///< (x, y) of a turned part's axis, mm: sections cut about it
  const Comparison* comparison = nullptr;       ///< null: no deviation map
  const std::vector<TriMesh>* freed = nullptr;  ///< pieces beside the mesh, which may hold them; null: none
  const std::vector<Finding>* findings = nullptr;  ///< numbered from 1 as in the report; null: none
};

/// One picture a view; apart.png where pieces came free: the part with them above it, or below if they are
/// larger; deviation.png where there is a comparison; findings.png where findings have a place. A mesh
/// without triangles (everything was cut away) gives no picture. What cannot be drawn goes to `failures` with
/// its file, and the others are there; errors: interrupted.
Result<std::vector<Picture>> drawPictures(const TriMesh& mesh, const PictureRequest& request,
                                          std::vector<Error>& failures, Progress& progress);

/// Puts the deviations and their legend into the scene.
void addHeatMap(const Comparison& comparison, RenderScene& scene);

}  // namespace proveout
