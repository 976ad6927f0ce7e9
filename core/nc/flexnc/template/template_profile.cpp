#include "core/nc/flexnc/template/template_profile.h"

#include <fmt/core.h>

#include <cmath>
#include <string>
#include <utility>

#include "core/geometry/plane.h"
#include "core/nc/flexnc/template/template_arcs.h"

namespace proveout::nc {

namespace {

constexpr double kLeastCone = -1e-6;   ///< mm; rounding of a length that is 0
constexpr double kNoElement = 1e-9;    ///< mm; shorter elements are left out
constexpr double kLeastRadius = 1e-9;  ///< mm

/// Extent of an arc beside the cone, and how far the line of the cone passes from its outer end at the plane
/// that is perpendicular to the axis there.
struct ConeArc {
  double axial = 0.0, rise = 0.0, line = 0.0;
};

ConeArc headOf(const TemplateInput& in) {
  const double n = std::sin(in.angle), c = std::cos(in.angle);
  switch (in.row.head) {
    case TemplateHead::kNone:
      break;
    case TemplateHead::kNose:
      return {in.r * (1.0 - n), in.r * c, in.r * (1.0 - n) / c};
    case TemplateHead::kRoot:
      return {in.r * n, in.r * (1.0 - c), 0.0};
  }
  return {};
}

ConeArc tailOf(const TemplateInput& in) {
  const double n = std::sin(in.angle), c = std::cos(in.angle);
  switch (in.row.tail) {
    case TemplateTail::kNone:
      break;
    case TemplateTail::kCrest:
      return {in.u * n, in.u * (1.0 - c), 0.0};
    case TemplateTail::kShoulder:
      return {in.u * (1.0 - n), in.u * c, in.u * (1.0 - n) / c};
  }
  return {};
}

/// Axial lengths and radii of a cone template.
struct ConeMeasures {
  double cone = 0.0, all = 0.0;   ///< along z: of the cone, of the whole profile
  double start = 0.0, end = 0.0;  ///< radii
};

ConeMeasures coneMeasures(const TemplateInput& in, const ConeArc& head, const ConeArc& tail) {
  const double arcs = head.axial + tail.axial, rises = head.rise + tail.rise, s = in.side;
  ConeMeasures m;
  if (in.row.given == TemplateGiven::kBoth) {
    m.start = in.a;
    m.end = in.x;
    m.cone = in.row.shape_letters.has('Y') ? in.y - arcs : (s * (in.x - in.a) - rises) / std::tan(in.angle);
    m.all = m.cone + arcs;
    return m;
  }
  m.all = in.y;
  m.cone = in.y - arcs;
  const double rise = rises + std::tan(in.angle) * std::max(m.cone, 0.0);
  if (in.row.given == TemplateGiven::kEnd || in.row.given == TemplateGiven::kLineEnd) {
    m.end = in.row.given == TemplateGiven::kEnd ? in.x : in.x + s * tail.line;
    m.start = m.end - s * rise;
  } else {
    m.start = in.row.given == TemplateGiven::kStart ? in.a : in.a - s * head.line;
    m.end = m.start + s * rise;
  }
  return m;
}

/// z of the start; profiles whose Z counts to the end begin at the face where it is 0.
double startOf(const TemplateInput& in, double all) {
  if (in.row.z_to_end) return in.z != 0.0 ? all - (in.v + in.z) : -in.v;
  return -(in.v + in.z);
}

PlaneContour coneElements(const TemplateInput& in, const ConeArc& head, const ConeArc& tail,
                          const ConeMeasures& m) {
  const double s = in.side, z0 = startOf(in, m.all);
  const Vec2 start(z0, m.start), end(z0 - m.all, m.end);
  const Vec2 cone_start = start + Vec2(-head.axial, s * head.rise);
  const Vec2 cone_end = end + Vec2(tail.axial, -s * tail.rise);
  PlaneContour elements;
  if (head.axial > kNoElement) {
    const bool nose = in.row.head == TemplateHead::kNose;
    const Vec2 center = nose ? Vec2(z0 - in.r, m.start) : Vec2(z0, m.start + s * in.r);
    elements.push_back(templateArc(center, start, cone_start, nose, s));
  }
  if ((cone_end - cone_start).norm() > kNoElement) elements.push_back(lineElement(cone_start, cone_end));
  if (tail.axial > kNoElement) {
    const bool crest = in.row.tail == TemplateTail::kCrest;
    const Vec2 center = crest ? Vec2(end.x(), m.end - s * in.u) : Vec2(end.x() + in.u, m.end);
    elements.push_back(templateArc(center, cone_end, end, crest, s));
  }
  return elements;
}

std::optional<CycleNote> coneProfile(const TemplateInput& in, PlaneContour& elements) {
  const ConeArc head = headOf(in), tail = tailOf(in);
  const ConeMeasures m = coneMeasures(in, head, tail);
  if (m.cone < kLeastCone) {
    return CycleNote{
        "fnc-tangent",
        fmt::format("{}: the radii do not fit between start and end, {:.3f} mm are missing along "
                    "Z: smaller radii, or a longer profile",
                    cycleName(in.row.code), -m.cone)};
  }
  elements = coneElements(in, head, tail, m);
  return std::nullopt;
}

/// May the profile begin on the axis?
bool mayStartOnAxis(const TemplateRow& row) {
  return row.shape == TemplateShape::kQuarter || row.zero_letters.has('A');
}

std::optional<CycleNote> checkRadii(const TemplateInput& in, const TemplateProfile& profile) {
  const double start = profile.start().y(), end = profile.end().y();
  const std::string name = cycleName(in.row.code);
  const double least = in.side > 0.0 && mayStartOnAxis(in.row) ? -kLeastRadius : kLeastRadius;
  if (start < least || end < kLeastRadius) {
    return CycleNote{"fnc-dia-neg",
                     fmt::format("{}: the profile would go from diameter {:.3f} to {:.3f}: it has to stay "
                                 "above the axis; look at diameters, lengths and angle",
                                 name, 2.0 * start, 2.0 * end)};
  }
  if (in.side < 0.0 && !(end + in.c > 0.0)) {
    return CycleNote{"fnc-dia-neg",
                     fmt::format("{}: the start point at X{:.3f} is not inside the hole of diameter {:.3f}: "
                                 "C nearer to 0",
                                 name, 2.0 * (end + in.c), 2.0 * end)};
  }
  if (in.row.z_to_end && !(profile.end().x() < -in.v)) {
    return CycleNote{"fnc-z-front", name + ": the profile ends in front of the face: Z has to be above 0"};
  }
  return std::nullopt;
}

std::optional<CycleNote> elementsOf(const TemplateInput& in, PlaneContour& elements) {
  switch (in.row.shape) {
    case TemplateShape::kPartArc:
      return partArcProfile(in, elements);
    case TemplateShape::kQuarter:
      return quarterProfile(in, elements);
    case TemplateShape::kTwoArcs:
      return twoArcsProfile(in, elements);
    case TemplateShape::kCone:
      return coneProfile(in, elements);
  }
  return std::nullopt;
}

}  // namespace

TemplateResult templateProfile(const TemplateInput& input) {
  TemplateResult result;
  TemplateProfile& profile = result.profile;
  result.alarm = elementsOf(input, profile.elements);
  if (result.alarm) return result;
  if (profile.elements.empty()) {
    result.alarm = CycleNote{"fnc-tangent", cycleName(input.row.code) + ": nothing is left of the profile"};
    return result;
  }
  result.alarm = checkRadii(input, profile);
  int number = 0;
  for (ContourElement& e : profile.elements) e.source = number++;
  for (std::size_t k = profile.elements.size() - 1; k > 0; --k) {
    profile.junctions.push_back(profile.elements[k].from.y());
  }
  profile.before_face = profile.start().x() > -input.v + kNoElement;
  return result;
}

}  // namespace proveout::nc
