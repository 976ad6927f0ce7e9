// What the page tells of the part's surface besides its picture: bands of deviation and sections.
#pragma once

#include <vector>

#include "io/job/job.h"
#include "io/report/report_page.h"
#include "io/report/view/scene_data.h"

namespace proveout {

/// Bands between `edges_mm` (ascending), and below and above them, with their areas on the mesh: the
/// deviation goes linearly over each triangle. Vertices that were not measured (NaN) take their triangles
/// out.
std::vector<DeviationBand> deviationBands(const ViewMesh& view, const std::vector<double>& edges_mm);

/// The colours of the bands for the 3-D view.
ViewScale scaleOf(const std::vector<DeviationBand>& bands);

/// Sections of closed meshes. `nominal`: null: none.
std::vector<PageSection> pageSections(const TriMesh& part, const TriMesh* nominal,
                                      const std::vector<SectionPlane>& planes);

}  // namespace proveout
