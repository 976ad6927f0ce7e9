// What a picture shows.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/diagnostics.h"
#include "core/mesh/tri_mesh.h"
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
  /// A close-up: the picture shows so much around this place. None: all of the part.
  struct Focus {
    Vec3 at = Vec3::Zero();
    double width_mm = 0.0;  ///< > 0
  };
  std::optional<Focus> focus;
};

struct RenderOptions {
  int threads = 0;     ///< 0: all cores
  int samples = 8;     ///< rays through each pixel that an edge crosses, 1..64
  bool ground = true;  ///< draw the shadow on a plane under the part, where the view looks down on it
  Rgb background{0.955F, 0.960F, 0.968F};  ///< sRGB, 0..1
};

}  // namespace proveout
