// The pictures of a run: named views, the deviation map, the findings.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/page/finding_details.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/image.h"
#include "core/mesh/tri_mesh.h"
#include "io/report.h"
#include "removal/compare/compare.h"
#include "removal/compare/part/part_feature.h"
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
};

/// The picture of deviations in a further view: "deviation-top".
std::string deviationViewName(const std::string& view);

/// Draws the pictures of one mesh, which each call is given: what all of them share is made once. None are
/// drawn of a mesh without triangles (everything was cut away), nor where no view is asked for. What cannot
/// be drawn is kept as failure with its file, and the others are there. Errors of all: interrupted.
class PictureMaker {
 public:
  explicit PictureMaker(PictureRequest request) : request_(std::move(request)) {}

  /// The part is a turned one with its axis at (x, y), mm: it lies as on a drawing, sections cut about the
  /// axis.
  void turnAbout(const Vec2& axis) { turned_axis_ = axis; }

  /// One picture a view.
  Status drawViews(const TriMesh& mesh, Progress& progress);
  /// apart.png, where there are `freed` pieces beside the mesh, which may hold them: the part with them where
  /// they leave it; see takenApart.
  Status drawApart(const TriMesh& mesh, const std::vector<TriMesh>& freed,
                   const std::vector<StockBody>& bodies, Progress& progress);
  /// deviation.png in the first view, deviation-VIEW.png in the others, with the places of deviations among
  /// the findings, numbered from 1 as in the report.
  Status drawDeviation(const TriMesh& mesh, const Comparison& comparison,
                       const std::vector<Finding>& findings, Progress& progress);
  /// scallops.png, where crests were measured: each triangle by the highest near it. `allowed_mm` > 0: higher
  /// ones are red.
  Status drawScallops(const TriMesh& mesh, const std::vector<CrestSample>& crests, double allowed_mm,
                      Progress& progress);
  /// findings.png, where other findings have a place.
  Status drawFindings(const TriMesh& mesh, const std::vector<Finding>& findings, Progress& progress);

  /// Close-ups of findings with the program around their blocks. None where no view is asked for, or pictures
  /// are too small for marks. `comparison`, `run`, `sources`: null: there is none. Errors: interrupted.
  Result<std::vector<FindingDetail>> drawDetails(const TriMesh& mesh, const Comparison* comparison,
                                                 const std::vector<Finding>& findings, const RunResult* run,
                                                 const RunSources* sources, Progress& progress);

  /// Gives back what the pictures share; the next one makes it again.
  void forgetMesh() {
    drawn_.reset();
    first_view_.reset();
  }

  /// In the order in which they were drawn.
  std::vector<Picture> pictures;
  std::vector<Error> failures;

 private:
  RenderScene sceneOf(const TriMesh& mesh);
  RenderOptions options() const;
  /// As it is drawn: turned parts have views and sections of their own.
  Result<View> prepare(RenderScene& scene, const std::string& view_name) const;
  Status add(Result<Image> image, const std::string& file, const std::string& title);
  Result<Image> draw(RenderScene scene, const std::string& view_name, Progress& progress) const;
  /// Without annotations, but with the room for those of findings.png.
  Result<Image> drawBare(const TriMesh& mesh, const std::string& view_name, Progress& progress);
  Result<Image> drawOverFirstView(RenderScene scene, Progress& progress);
  bool drawsOf(const TriMesh& mesh) const { return !mesh.triangles.empty() && !request_.views.empty(); }
  bool annotated() const;
  Result<std::string> drawCloseUp(const TriMesh& mesh, const Comparison* comparison, const Marker& marker,
                                  const Vec3& back, double width_mm, Progress& progress);

  PictureRequest request_;
  std::optional<Vec2> turned_axis_;
  std::shared_ptr<const DrawnMesh> drawn_;  ///< null: not made yet
  std::optional<Image> first_view_;         ///< of the mesh, for findings.png
};

/// Puts the deviations and their legend into the scene.
void addHeatMap(const Comparison& comparison, RenderScene& scene);

}  // namespace proveout
