// Calls of FlexNC cycles for tests, from the text of a block, and what their moves make of a bar or a bore.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <vector>

#include "core/geometry/types.h"
#include "core/nc/flexnc/cycles/cycle_call.h"

namespace proveout::test {

/// "G12X60R20Z10P1.5C2B2V0": the first number is the code, every further letter an argument.
inline nc::CycleCall flexncCall(const std::string& block, const Vec2& at = Vec2(100.0, 150.0)) {
  const char *text = block.data(), *const end = text + block.size();
  const auto number = [&] {
    double value = 0.0;
    text = std::from_chars(text + 1, end, value).ptr;
    return value;
  };
  nc::CycleCall call;
  call.at = at;
  call.code = nc::cycleCode(number()).value();
  while (text != end) {
    const char letter = *text;
    call.arguments.set(letter, number());
  }
  return call;
}

inline nc::CycleAnswer flexncAnswer(const std::string& block) { return performCycle(flexncCall(block)); }

/// What moves along the contour, without leads: the elements of the profile that are cut.
inline PlaneContour contourOf(const nc::CycleAnswer& answer) {
  PlaneContour contour;
  for (const nc::CycleMove& move : answer.moves) {
    if (move.role == nc::CycleMove::Role::kContour && move.element.source >= 0) {
      contour.push_back(move.element);
    }
  }
  return contour;
}

/// Antiderivative of r^2 over z on the circle r = rc + sign * sqrt(R^2 - (z - zc)^2).
inline double arcMoment(double z, const Vec2& center, double radius, double sign) {
  const double w = z - center.x(), root = std::sqrt(std::max(radius * radius - w * w, 0.0));
  const double area = 0.5 * (w * root + radius * radius * std::asin(std::clamp(w / radius, -1.0, 1.0)));
  return center.y() * center.y() * w + radius * radius * w - w * w * w / 3.0 + 2.0 * center.y() * sign * area;
}

/// Integral of r^2 dz over what of the element lies behind the plane z = face.
inline double momentOf(const ContourElement& e, double face) {
  const double from = std::min(e.from.x(), face), to = std::min(e.to.x(), face), length = from - to;
  if (!(length > 0.0)) return 0.0;
  if (!e.arc) {
    const double slope = (e.to.y() - e.from.y()) / (e.to.x() - e.from.x());
    const double a = e.from.y() + slope * (from - e.from.x()), b = e.to.y();
    return length * (a * a + a * b + b * b) / 3.0;
  }
  const double sign = 0.5 * (e.from.y() + e.to.y()) > e.center.y() ? 1.0 : -1.0;
  const double radius = (e.from - e.center).norm();
  return arcMoment(from, e.center, radius, sign) - arcMoment(to, e.center, radius, sign);
}

/// Volume behind the face between the profile, led on to the face as a cylinder, and the cylinder of the
/// end's diameter.
inline double removedVolume(const PlaneContour& profile, double face) {
  const double stock = profile.back().to.y(), start = profile.front().from.y();
  double moment = std::max(face - profile.front().from.x(), 0.0) * start * start;
  for (const ContourElement& e : profile) moment += momentOf(e, face);
  return kPi * std::abs(stock * stock * (face - profile.back().to.x()) - moment);
}

}  // namespace proveout::test
