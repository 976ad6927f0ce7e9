// Named views and the orthographic camera.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/geometry/types.h"
#include "core/mesh/tri_mesh.h"

namespace proveout {

struct ImageSize {
  int width = 1200, height = 900;  ///< pixels, each kMinImageSide..kMaxImageSide
};
inline constexpr int kMinImageSide = 16;
inline constexpr int kMaxImageSide = 8192;

/// Checks the range; the message names it.
Status validateImageSize(ImageSize size);
/// Parses "1200x900".
Result<ImageSize> parseImageSize(const std::string& text);

/// A direction to look from. Workpiece frame: z up, front is seen from -y, left from -x.
struct View {
  std::string name;
  Vec3 back = Vec3::UnitZ();  ///< unit, from the part to the camera
  Vec3 up = Vec3::UnitY();    ///< unit, normal to back; up in the picture
  bool section = false;       ///< a quarter of the part is cut away (SectionCut)
};
/// iso, iso-left, iso-back, iso-below, top, bottom, front, back, left, right, section.
std::vector<std::string> viewNames();
/// The view of that name; the error lists the known names.
Result<View> findView(const std::string& name);
/// The same of a part that turns about Z, as it lies on a drawing: front is seen from +Y, the axis is level
/// in every view but those along it, +Z (away from the chuck) to the right and +X up; views from behind and
/// from the left side show +Z to the left or from its end.
Result<View> findTurnedView(const std::string& name);

/// Part of a picture, pixels from its upper left corner.
struct PixelRect {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  double width() const { return x1 - x0; }
  double height() const { return y1 - y0; }
};

/// Orthographic projection: a point of the workpiece frame (mm) to pixels from the upper left corner, y down.
struct Camera {
  Vec3 right = Vec3::UnitX(), up = Vec3::UnitY(), back = Vec3::UnitZ();  ///< orthonormal
  Vec3 target = Vec3::Zero();                                            ///< mm, shown at `target_pixel`
  Vec2 target_pixel = Vec2::Zero();
  double mm_per_pixel = 1.0;  ///< > 0

  Vec2 project(const Vec3& p) const {
    const Vec3 d = p - target;
    return target_pixel + Vec2(d.dot(right), -d.dot(up)) / mm_per_pixel;
  }
  /// The point of the plane through the target that the pixel position shows, mm.
  Vec3 unproject(const Vec2& pixel) const {
    const Vec2 d = (pixel - target_pixel) * mm_per_pixel;
    return target + right * d.x() - up * d.y();
  }
};

/// Camera whose picture of the mesh's vertices fills `rect` as far as its proportions allow, centred.
/// The mesh must have at least one finite position.
Camera fitCamera(const TriMesh& mesh, const View& view, const PixelRect& rect);

}  // namespace proveout
