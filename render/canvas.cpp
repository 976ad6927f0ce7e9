#include "render/canvas.h"

#include <algorithm>
#include <cmath>

#include "render/font.h"

namespace proveout::render_detail {
namespace {

/// Share of a pixel covered by a shape whose edge lies `outside` pixels inwards (negative) or outwards of its
/// centre.
double edgeCoverage(double outside) { return std::clamp(0.5 - outside, 0.0, 1.0); }

double distanceToSegment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 d = b - a;
  const double length2 = d.squaredNorm();
  const double t = length2 > 0 ? std::clamp((p - a).dot(d) / length2, 0.0, 1.0) : 0.0;
  return (p - a - d * t).norm();
}

bool dotAt(const Glyph& glyph, int column, int row) {
  if (column < 0 || column >= kGlyphWidth || row < 0 || row >= kGlyphRows) return false;
  return (glyph[static_cast<std::size_t>(row)] >> (kGlyphWidth - 1 - column)) & 1;
}

}  // namespace

template <typename Coverage>
void Canvas::paint(const Vec2& lo, const Vec2& hi, const Rgb& color, double opacity,
                   const Coverage& coverage) {
  const auto clampTo = [](double v, int size) {
    return static_cast<int>(std::clamp(v, 0.0, static_cast<double>(size)));
  };
  const int x0 = clampTo(std::floor(lo.x() - 1), image_.width),
            x1 = clampTo(std::ceil(hi.x() + 1), image_.width);
  const int y0 = clampTo(std::floor(lo.y() - 1), image_.height),
            y1 = clampTo(std::ceil(hi.y() + 1), image_.height);
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) {
      const double share = opacity * coverage(Vec2(x + 0.5, y + 0.5));
      if (share <= 0) continue;
      std::uint8_t* out = &image_.rgb[(static_cast<std::size_t>(y) * image_.width + x) * 3];
      for (std::size_t c = 0; c < 3; ++c) {
        out[c] = static_cast<std::uint8_t>(std::lround(out[c] + (255.0 * color[c] - out[c]) * share));
      }
    }
  }
}

void Canvas::line(const Vec2& a, const Vec2& b, double width, const Rgb& color, double opacity) {
  const Vec2 margin = Vec2::Constant(0.5 * width);
  paint(a.cwiseMin(b) - margin, a.cwiseMax(b) + margin, color, opacity,
        [&](const Vec2& p) { return edgeCoverage(distanceToSegment(p, a, b) - 0.5 * width); });
}

void Canvas::disc(const Vec2& center, double radius, const Rgb& color, double opacity) {
  const Vec2 margin = Vec2::Constant(radius);
  paint(center - margin, center + margin, color, opacity,
        [&](const Vec2& p) { return edgeCoverage((p - center).norm() - radius); });
}

void Canvas::ring(const Vec2& center, double radius, double width, const Rgb& color) {
  const Vec2 margin = Vec2::Constant(radius + 0.5 * width);
  paint(center - margin, center + margin, color, 1.0,
        [&](const Vec2& p) { return edgeCoverage(std::abs((p - center).norm() - radius) - 0.5 * width); });
}

void Canvas::box(const PixelRect& rect, const Rgb& color, double opacity) {
  paint(Vec2(rect.x0, rect.y0), Vec2(rect.x1, rect.y1), color, opacity, [&](const Vec2& p) {
    return std::min({edgeCoverage(rect.x0 - p.x()), edgeCoverage(p.x() - rect.x1),
                     edgeCoverage(rect.y0 - p.y()), edgeCoverage(p.y() - rect.y1)});
  });
}

double Canvas::textWidth(std::string_view text, double cell) {
  return text.empty() ? 0.0 : (static_cast<double>(text.size()) * kGlyphAdvance - 1) * cell;
}
double Canvas::textHeight(double cell) { return kGlyphHeight * cell; }

// Neighbouring dots are joined by round strokes, which reads better at any size than squares do. Diagonals
// are joined only where no stroke goes around the corner already.
void Canvas::text(const Vec2& at, std::string_view text, double cell, const Rgb& color) {
  const double pen = 1.05 * cell;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const Glyph& glyph = glyphOf(text[i]);
    const Vec2 origin =
        at + Vec2(static_cast<double>(i) * kGlyphAdvance * cell, 0) + Vec2::Constant(0.5 * cell);
    const auto center = [&](int column, int row) { return Vec2(origin + Vec2(column, row) * cell); };
    const auto coverage = [&](const Vec2& p) {
      double nearest = 1e9;
      for (int row = 0; row < kGlyphRows; ++row) {
        for (int column = 0; column < kGlyphWidth; ++column) {
          if (!dotAt(glyph, column, row)) continue;
          const Vec2 here = center(column, row);
          nearest = std::min(nearest, (p - here).norm());
          const bool east = dotAt(glyph, column + 1, row), south = dotAt(glyph, column, row + 1);
          if (east) nearest = std::min(nearest, distanceToSegment(p, here, center(column + 1, row)));
          if (south) nearest = std::min(nearest, distanceToSegment(p, here, center(column, row + 1)));
          if (dotAt(glyph, column + 1, row + 1) && !east && !south) {
            nearest = std::min(nearest, distanceToSegment(p, here, center(column + 1, row + 1)));
          }
          if (dotAt(glyph, column - 1, row + 1) && !dotAt(glyph, column - 1, row) && !south) {
            nearest = std::min(nearest, distanceToSegment(p, here, center(column - 1, row + 1)));
          }
        }
      }
      return edgeCoverage(nearest - 0.5 * pen);
    };
    paint(origin, origin + Vec2(kGlyphWidth, kGlyphRows) * cell, color, 1.0, coverage);
  }
}

}  // namespace proveout::render_detail
