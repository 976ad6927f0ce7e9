#include "app/page/measured_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/mesh/level_cut.h"

namespace proveout {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Share of a triangle where a value that goes linearly from corner to corner lies below `level`.
double shareBelow(std::array<double, 3> at, double level) {
  std::sort(at.begin(), at.end());
  const auto [a, b, c] = at;
  if (level <= a) return level < a ? 0.0 : (a == c ? 0.5 : 0.0);
  if (level >= c) return 1.0;
  if (level <= b) return (level - a) * (level - a) / ((b - a) * (c - a));
  return 1.0 - (c - level) * (c - level) / ((c - b) * (c - a));
}

/// From red by grey to blue, the band that holds zero in grey.
std::string bandColour(std::size_t index, std::size_t count, double from, double to) {
  if (from <= 0.0 && to >= 0.0) return "#e6e6e0";
  const bool above = from >= 0.0;
  // The outermost is the darkest: 0 there, 1 beside zero.
  const double t =
      count < 2 ? 0.0
                : 1.0 - std::abs(2.0 * static_cast<double>(index) / static_cast<double>(count - 1) - 1.0);
  const auto mix = [&](int dark, int light) {
    return static_cast<int>(std::lround(dark + t * (light - dark)));
  };
  return above ? fmt::format("#{:02x}{:02x}{:02x}", mix(150, 253), mix(20, 205), mix(30, 180))
               : fmt::format("#{:02x}{:02x}{:02x}", mix(12, 175), mix(50, 212), mix(130, 245));
}

/// With the axis of the plane as z.
TriMesh alongAxis(const TriMesh& mesh, int axis) {
  TriMesh turned;
  turned.triangles = mesh.triangles;
  for (const Eigen::Vector3f& p : mesh.positions)
    turned.positions.emplace_back(axis == 0 ? p.y() : p.x(), axis == 2 ? p.y() : p.z(), p[axis]);
  // (x, z, y) is a mirror image.
  if (axis == 1) {
    for (auto& triangle : turned.triangles) std::swap(triangle[1], triangle[2]);
  }
  return turned;
}

}  // namespace

std::vector<DeviationBand> deviationBands(const ViewMesh& view, const std::vector<double>& edges_mm) {
  std::vector<DeviationBand> bands;
  for (std::size_t i = 0; i <= edges_mm.size(); ++i) {
    DeviationBand band;
    band.from_mm = i == 0 ? -kInfinite : edges_mm[i - 1];
    band.to_mm = i == edges_mm.size() ? kInfinite : edges_mm[i];
    band.colour = bandColour(i, edges_mm.size() + 1, band.from_mm, band.to_mm);
    bands.push_back(std::move(band));
  }
  double total = 0.0;
  for (const auto& t : view.mesh.triangles) {
    const auto place = [&](std::size_t k) { return view.mesh.positions[t[k]].cast<double>().eval(); };
    const double area = 0.5 * (place(1) - place(0)).cross(place(2) - place(0)).norm();
    const std::array<double, 3> at{static_cast<double>(view.deviation_mm[t[0]]),
                                   static_cast<double>(view.deviation_mm[t[1]]),
                                   static_cast<double>(view.deviation_mm[t[2]])};
    if (!std::isfinite(at[0] + at[1] + at[2])) continue;
    total += area;
    double below = 0.0;
    for (DeviationBand& band : bands) {
      const double up_to = std::isinf(band.to_mm) ? 1.0 : shareBelow(at, band.to_mm);
      band.area_mm2 += area * (up_to - below);
      below = up_to;
    }
  }
  for (DeviationBand& band : bands) band.share = total > 0.0 ? band.area_mm2 / total : 0.0;
  return bands;
}

ViewScale scaleOf(const std::vector<DeviationBand>& bands) {
  ViewScale scale;
  const auto rgb = [](const std::string& hex) {
    std::array<float, 3> out{};
    for (std::size_t k = 0; k < 3; ++k)
      out[k] = static_cast<float>(std::stoi(hex.substr(1 + 2 * k, 2), nullptr, 16)) / 255.0F;
    return out;
  };
  const double first = bands.front().to_mm, last = bands.back().from_mm, wide = 0.15 * (last - first);
  for (const DeviationBand& band : bands) {
    scale.stops.push_back({std::isinf(band.from_mm) ? first - wide : band.from_mm, rgb(band.colour)});
    scale.stops.push_back({std::isinf(band.to_mm) ? last + wide : band.to_mm, rgb(band.colour)});
  }
  scale.ticks_mm = {first, last};
  for (const DeviationBand& band : bands) {
    if (!std::isinf(band.to_mm)) scale.ticks_mm.push_back(band.to_mm);
  }
  return scale;
}

std::vector<PageSection> pageSections(const TriMesh& part, const TriMesh* nominal,
                                      const std::vector<SectionPlane>& planes) {
  std::vector<PageSection> sections;
  for (const SectionPlane& plane : planes) {
    PageSection section;
    section.plane = plane;
    section.machined = cutAtHeight(alongAxis(part, plane.axis), plane.at_mm);
    section.machined_mm2 = areaOf(section.machined);
    if (nominal != nullptr) {
      section.nominal = cutAtHeight(alongAxis(*nominal, plane.axis), plane.at_mm);
      section.nominal_mm2 = areaOf(section.nominal);
    }
    sections.push_back(std::move(section));
  }
  return sections;
}

}  // namespace proveout
