// Anti-aliased lines, discs, boxes and text drawn over a picture. Positions in pixels from the upper left
// corner (pixel centres at halves), y down. Everything is clipped to the picture.
#pragma once

#include <string_view>

#include "core/geometry/types.h"
#include "core/mesh/image.h"
#include "render/camera.h"
#include "render/color_map.h"

namespace proveout::render_detail {

class Canvas {
 public:
  explicit Canvas(Image& image) : image_(image) {}

  void line(const Vec2& a, const Vec2& b, double width, const Rgb& color, double opacity = 1.0);
  void disc(const Vec2& center, double radius, const Rgb& color, double opacity = 1.0);
  void ring(const Vec2& center, double radius, double width, const Rgb& color);
  void box(const PixelRect& rect, const Rgb& color, double opacity = 1.0);
  /// Text with its upper left corner at `at`; `cell` is the size of a dot of the 5x7 font in pixels.
  void text(const Vec2& at, std::string_view text, double cell, const Rgb& color);

  static double textWidth(std::string_view text, double cell);
  static double textHeight(double cell);

 private:
  /// Blends `color` over every pixel of the box about [lo, hi] by coverage(pixel centre), 0..1.
  template <typename Coverage>
  void paint(const Vec2& lo, const Vec2& hi, const Rgb& color, double opacity, const Coverage& coverage);

  Image& image_;
};

}  // namespace proveout::render_detail
