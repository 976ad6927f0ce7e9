#include "core/nc/flexnc/template/template_arcs.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace proveout::nc {

namespace {

constexpr double kFits = 1e-9;  ///< mm; rounding of radii that just fit

}  // namespace

ContourElement templateArc(const Vec2& center, const Vec2& from, const Vec2& to, bool convex, double side) {
  const double sense = convex == (side > 0.0) ? 1.0 : -1.0;
  ContourElement arc = arcElement(center, from, to, sense);
  arc.sweep = sense * sweepUntil(arc, to);
  return arc;
}

std::optional<CycleNote> partArcProfile(const TemplateInput& in, PlaneContour& elements) {
  const double d = in.x - in.a, q2 = in.z * in.z + d * d;
  const double least = q2 / (2.0 * std::min(d, in.z));
  if (!(in.r >= least - kFits)) {
    return CycleNote{"fnc-tangent",
                     fmt::format("G3.1: an arc of radius {:.3f} between diameters {:.3f} and {:.3f} over "
                                 "{:.3f} mm turns back: R at least {:.4f}",
                                 in.r, 2.0 * in.a, 2.0 * in.x, in.z, least)};
  }
  const Vec2 from(-in.v, in.a), to(-in.v - in.z, in.x);
  const double q = std::sqrt(q2), h = std::sqrt(std::max(in.r * in.r - q2 / 4.0, 0.0));
  const Vec2 outside(d / q, in.z / q);  // off the material
  const Vec2 center = 0.5 * (from + to) + (in.convex ? -h : h) * outside;
  elements.push_back(templateArc(center, from, to, in.convex, in.side));
  return std::nullopt;
}

std::optional<CycleNote> quarterProfile(const TemplateInput& in, PlaneContour& elements) {
  const double start = in.x - in.side * in.r, z0 = -(in.v + in.z);
  const Vec2 from(z0, start), to(z0 - in.r, in.x);
  const Vec2 center = in.convex ? Vec2(to.x(), from.y()) : Vec2(from.x(), to.y());
  elements.push_back(templateArc(center, from, to, in.convex, in.side));
  return std::nullopt;
}

std::optional<CycleNote> twoArcsProfile(const TemplateInput& in, PlaneContour& elements) {
  const double d = in.x - in.a, radii = in.r + in.u;
  if (!(d > 0.0) || d > radii + kFits) {
    return CycleNote{"fnc-tangent",
                     fmt::format("G8.1: radii {:.3f} and {:.3f} do not touch between diameters {:.3f} and "
                                 "{:.3f}: half their difference has to be above 0 and at most the sum of "
                                 "the radii",
                                 in.r, in.u, 2.0 * in.a, 2.0 * in.x)};
  }
  const double z0 = -(in.v + in.z), along = std::sqrt(std::max(radii * radii - d * d, 0.0));
  const Vec2 first(z0 - in.r, in.a), second = first + Vec2(along, d);
  const Vec2 start(z0, in.a), touch = first + in.r / radii * (second - first);
  const Vec2 end(second.x() - in.u, in.x);
  if (in.r > kFits) elements.push_back(templateArc(first, start, touch, true, in.side));
  if (in.u > kFits) elements.push_back(templateArc(second, touch, end, false, in.side));
  return std::nullopt;
}

}  // namespace proveout::nc
