// Headless pictures of a part: ray traced with a soft key light, ambient occlusion and a ground shadow;
// optionally coloured by deviation, with a legend, numbered findings and a caption.
//
// The same scene, view, size and options give the same bytes for any number of threads.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/diagnostics.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/image.h"
#include "core/mesh/tri_mesh.h"
#include "render/camera.h"
#include "render/color_map.h"

namespace proveout {

/// A number per vertex or per triangle that colours the mesh by `scale`. Empty: not coloured.
/// Values that are not finite mean "not measured" and are drawn in a neutral dark grey.
struct ScalarField {
  enum class Per { kVertex, kTriangle };
  Per per = Per::kVertex;
  std::vector<float> values;  ///< mm
  /// The value at a point of the mesh, mm, workpiece frame. Empty: between the vertices of a triangle it goes
  /// linearly. Asked where their values differ, or where a triangle is so large that they say nothing of its
  /// middle; thread-safe.
  std::function<float(const Vec3&)> at;
  double largest_mm = 0.0;  ///< with `at`: triangles with longer edges are large
  DeviationScale scale;
};

/// A finding to point at.
struct Marker {
  Vec3 at = Vec3::Zero();  ///< mm, workpiece frame
  std::string label;       ///< a number or a few ASCII characters, at most 8
  Severity severity = Severity::kError;
};

/// Colour bar at the right edge, from the scale of the scalar field.
struct Legend {
  std::string title;          ///< ASCII, "deviation"; the unit is added
  std::string unit = "mm";    ///< ASCII
  std::vector<double> ticks;  ///< in `unit`; empty: chosen from the scale
};

/// Cuts a quarter of the part away, so that bores, grooves and walls show: what lies on the given side of
/// both planes through an axis parallel to Z. The solid's cut faces are drawn hatched. The mesh must be
/// closed.
struct SectionCut {
  Vec2 axis = Vec2::Zero();     ///< (x, y), mm, workpiece frame
  int side_x = 1, side_y = -1;  ///< 1 or -1; the quarter where these are the signs of x and y from the axis
};

class DrawnMesh;
/// Of a mesh that several pictures show. `threads` as in RenderOptions. Errors as of renderMesh.
Result<std::shared_ptr<const DrawnMesh>> prepareDrawing(const TriMesh& mesh, int threads);

struct RenderScene {
  explicit RenderScene(const TriMesh& m) : mesh(m) {}
  const TriMesh& mesh;                     ///< must outlive the scene
  std::shared_ptr<const DrawnMesh> drawn;  ///< of this mesh; null: made for the picture alone
  ScalarField field;                       ///< deviation heat map; goes before `triangle_colors`
  std::vector<Rgb> triangle_colors;        ///< empty or one per triangle (tint by tool or motion)
  std::vector<Marker> markers;
  bool show_legend = false;  ///< needs a scalar field
  Legend legend;
  std::string caption;        ///< one ASCII line at the bottom; empty: none
  bool caption_room = false;  ///< the part leaves room for it without one, too
  /// Applies in every view. None: a view with `section` cuts about the middle of the mesh's bounds, the
  /// quarter that faces the camera.
  std::optional<SectionCut> section;
};

struct RenderOptions {
  int threads = 0;     ///< 0: all cores
  int samples = 8;     ///< rays through each pixel that an edge crosses, 1..64
  bool ground = true;  ///< draw the shadow on a plane under the part, where the view looks down on it
  Rgb background{0.955F, 0.960F, 0.968F};  ///< sRGB, 0..1
};

/// Draws the scene. Errors (kInput): empty mesh, positions that are not finite, indices out of range, fields
/// of the wrong length, a section without a quarter, samples or size out of range, annotations on a picture
/// below 160 x 120. kInterrupted when cancelled.
Result<Image> renderMesh(const RenderScene& scene, const View& view, ImageSize size,
                         const RenderOptions& options, Progress& progress);

/// The two halves of renderMesh, for pictures of one view that differ in their annotations alone: the part
/// without legend, markers and caption, at the place that the scene leaves for it, and these over a picture
/// of a scene with the same mesh, section, legend and room. Errors as of renderMesh.
Result<Image> renderPart(const RenderScene& scene, const View& view, ImageSize size,
                         const RenderOptions& options, Progress& progress);
Status annotate(const RenderScene& scene, const View& view, Image& image);

/// The camera that renderMesh uses for this scene, to find where a point of the part lies in the picture.
Camera sceneCamera(const RenderScene& scene, const View& view, ImageSize size);

/// A stable, well separated tint for a tool number (any integer).
Rgb toolTint(int tool);

}  // namespace proveout
