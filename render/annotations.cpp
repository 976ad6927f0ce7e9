#include "render/annotations.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/assert.h"

namespace proveout::render_detail {
namespace {

constexpr Rgb kInk{0.13F, 0.14F, 0.16F};
constexpr Rgb kPaper{1.0F, 1.0F, 1.0F};

Rgb severityColor(Severity severity) {
  switch (severity) {
    case Severity::kError:
      return {0.78F, 0.05F, 0.13F};
    case Severity::kWarning:
      return {0.80F, 0.47F, 0.0F};
    case Severity::kNote:
      break;
  }
  return {0.12F, 0.36F, 0.62F};
}

double tickValue(const PixelRect& bar, const DeviationScale& scale, double mm) {
  const double t = std::clamp(0.5 - 0.5 * mm / scale.limit, 0.0, 1.0);
  return bar.y0 + t * bar.height();
}

void drawLegend(const RenderScene& scene, const PageLayout& page, Canvas& canvas) {
  const DeviationScale& scale = scene.field.scale;
  PROVEOUT_ASSERT(scale.limit > 0.0);
  const PixelRect& bar = page.bar;
  const int rows = std::max(1, static_cast<int>(bar.height()));
  for (int i = 0; i < rows; ++i) {
    const double y0 = bar.y0 + bar.height() * i / rows, y1 = bar.y0 + bar.height() * (i + 1) / rows;
    const double mm = scale.limit * (1.0 - (2.0 * i + 1.0) / rows);
    canvas.box({bar.x0, y0, bar.x1, y1}, deviationColor(scale, mm));
  }
  const Vec2 corners[] = {{bar.x0, bar.y0}, {bar.x1, bar.y0}, {bar.x1, bar.y1}, {bar.x0, bar.y1}};
  for (int i = 0; i < 4; ++i) canvas.line(corners[i], corners[(i + 1) % 4], 1.0, kInk);

  const double cell = page.legend_cell, height = Canvas::textHeight(cell);
  std::vector<double> ticks = scene.legend.ticks.empty() ? deviationTicks(scale) : scene.legend.ticks;
  std::sort(ticks.begin(), ticks.end());
  double lowest_free = bar.y1 + 2 * height;
  for (const double mm : ticks) {  // from the bottom up; a number that would touch the last one is left out
    const double y = tickValue(bar, scale, mm);
    canvas.line({bar.x1, y}, {bar.x1 + 3 * page.cell, y}, 1.0, kInk);
    if (y + 0.75 * height > lowest_free) continue;
    const std::string label = mm == 0 ? "0" : fmt::format("{:+.4g}", mm);
    canvas.text({bar.x1 + 5 * page.cell, y - 0.5 * height}, label, cell, kInk);
    lowest_free = y - 0.5 * height;
  }
  const double right = static_cast<double>(bar.x1) + 5 * page.cell + Canvas::textWidth("+0.0000", cell);
  double y = bar.y0 - 3.6 * height;
  for (const std::string& row : {scene.legend.title, "[" + scene.legend.unit + "]"}) {
    canvas.text({right - Canvas::textWidth(row, cell), y}, row, cell, kInk);
    y += 1.4 * height;
  }
}

struct Badge {
  PixelRect box;
  Vec2 center() const { return {0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1)}; }
};

bool overlap(const PixelRect& a, const PixelRect& b, double gap) {
  return a.x0 - gap < b.x1 && b.x0 - gap < a.x1 && a.y0 - gap < b.y1 && b.y0 - gap < a.y1;
}

/// A free place near the point: first outwards from the middle of the picture, then around, then farther
/// away.
Badge placeBadge(const Vec2& at, const Vec2& half, const PageLayout& page, const std::vector<Badge>& taken) {
  const Vec2 middle(0.5 * (page.part.x0 + page.part.x1), 0.5 * (page.part.y0 + page.part.y1));
  const Vec2 away = at - middle;
  const double start = away.norm() > 1 ? std::atan2(away.y(), away.x()) : -0.25 * kPi;
  std::optional<Badge> first;
  for (int ring = 0; ring < 6; ++ring) {
    for (int step = 0; step < 16; ++step) {
      const int turn = step % 2 == 0 ? step / 2 : -(step + 1) / 2;
      const double angle = start + turn * kPi / 8;
      const Vec2 c = at + Vec2(std::cos(angle), std::sin(angle)) * (half.norm() + page.cell * (9 + 9 * ring));
      const Badge badge{{c.x() - half.x(), c.y() - half.y(), c.x() + half.x(), c.y() + half.y()}};
      if (!first) first = badge;
      const bool inside = badge.box.x0 >= 2 && badge.box.y0 >= 2 &&
                          badge.box.x1 <= page.part.x1 + 4 * page.cell &&
                          badge.box.y1 <= page.part.y1 + 4 * page.cell;
      const auto hits = [&](const Badge& other) { return overlap(badge.box, other.box, page.cell); };
      if (inside && std::none_of(taken.begin(), taken.end(), hits)) return badge;
    }
  }
  return *first;
}

void drawMarkers(const RenderScene& scene, const PageLayout& page, const Camera& camera,
                 const std::function<bool(const Vec3&)>& visible, Canvas& canvas) {
  const double cell = page.cell;
  std::vector<Badge> badges;
  for (const Marker& marker : scene.markers) {
    const Vec2 half(std::max(5.5 * cell, 0.5 * Canvas::textWidth(marker.label, cell) + 3 * cell), 5.5 * cell);
    badges.push_back(placeBadge(camera.project(marker.at), half, page, badges));
  }
  for (std::size_t i = 0; i < badges.size(); ++i) {  // leaders under all badges
    const Vec2 at = camera.project(scene.markers[i].at);
    canvas.line(at, badges[i].center(), 2.2 * cell, kPaper, 0.8);
    canvas.line(at, badges[i].center(), 0.8 * cell, severityColor(scene.markers[i].severity));
  }
  for (std::size_t i = 0; i < badges.size(); ++i) {
    const Marker& marker = scene.markers[i];
    const Rgb color = severityColor(marker.severity);
    const Vec2 at = camera.project(marker.at);
    canvas.disc(at, 2.6 * cell, kPaper);
    if (visible(marker.at)) {
      canvas.disc(at, 1.9 * cell, color);
    } else {
      canvas.ring(at, 1.6 * cell, 0.8 * cell, color);
    }
    const PixelRect& box = badges[i].box;
    const double radius = 0.5 * box.height();
    const Vec2 west(box.x0 + radius, box.y0 + radius), east(box.x1 - radius, box.y0 + radius);
    canvas.line(west, east, 2 * radius + 1.6 * cell, kPaper);
    canvas.line(west, east, 2 * radius, color);
    const double width = Canvas::textWidth(marker.label, cell);
    canvas.text(badges[i].center() - Vec2(0.5 * width, 0.5 * Canvas::textHeight(cell)), marker.label, cell,
                kPaper);
  }
}

}  // namespace

PageLayout layoutPage(const RenderScene& scene, ImageSize size) {
  PageLayout page;
  const double width = size.width, height = size.height;
  page.cell = std::max(1.0, std::min(width, height) / 480.0);
  page.legend_cell = std::max(1.0, std::min(width, height) / 320.0);
  const double margin = 0.05 * std::min(width, height);
  page.part = {margin, margin, width - margin, height - margin};
  if (scene.show_legend) {
    const double room = 9 * page.cell + 5 * page.cell + Canvas::textWidth("+0.0000", page.legend_cell);
    page.part.x1 -= room;
    // On whole pixels: the rows of the bar then cover each other's edges fully.
    page.bar.x0 = std::round(page.part.x1 + 0.6 * margin);
    page.bar.x1 = page.bar.x0 + std::round(9 * page.cell);
    page.bar.y0 = std::round(0.22 * height);
    page.bar.y1 = std::round(0.78 * height);
  }
  if (!scene.caption.empty() || scene.caption_room) {
    page.part.y1 -= 1.4 * Canvas::textHeight(page.cell);
    page.caption = {0.5 * margin, height - 0.5 * margin - Canvas::textHeight(page.cell)};
  }
  return page;
}

void drawAnnotations(const RenderScene& scene, const PageLayout& page, const Camera& camera,
                     const std::function<bool(const Vec3&)>& visible, Image& image) {
  Canvas canvas(image);
  if (scene.show_legend) drawLegend(scene, page, canvas);
  drawMarkers(scene, page, camera, visible, canvas);
  if (!scene.caption.empty()) canvas.text(page.caption, scene.caption, page.cell, kInk);
}

}  // namespace proveout::render_detail
