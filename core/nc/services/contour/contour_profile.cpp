#include "core/nc/services/contour/contour_profile.h"

#include <algorithm>
#include <cmath>

namespace proveout {

namespace {

constexpr double kSameLevel = 1e-6;  ///< mm; levels nearer to each other are one

}  // namespace

ContourProfile::ContourProfile(const PlaneContour& contour, int depth_axis, double side)
    : contour_(contour), depth_axis_(depth_axis), side_(side) {
  for (std::size_t k = 0; k < contour.size(); ++k) split(k);
}

void ContourProfile::split(std::size_t k) {
  const ContourElement& e = contour_[k];
  std::vector<double> cuts = {0.0};
  if (e.arc) {
    const Vec2 arm = e.from - e.center;
    const double from = std::atan2(arm.y(), arm.x());
    for (int quarter = -12; quarter <= 12; ++quarter) {
      const double t = (quarter * kPi / 2.0 - from) / e.sweep;
      if (t > 1e-9 && t < 1.0 - 1e-9) cuts.push_back(t);
    }
    std::sort(cuts.begin(), cuts.end());
  }
  cuts.push_back(1.0);
  for (std::size_t i = 1; i < cuts.size(); ++i) stretches_.push_back({k, cuts[i - 1], cuts[i]});
}

std::size_t ContourProfile::stretchAt(double t) const {
  return std::min(static_cast<std::size_t>(t), stretches_.size() - 1);
}

/// Part of the way of the stretch's element.
double ContourProfile::partAt(double t, std::size_t stretch) const {
  const Monotone& m = stretches_[stretch];
  return m.t0 + (t - static_cast<double>(stretch)) * (m.t1 - m.t0);
}

Vec2 ContourProfile::at(double t) const {
  const std::size_t k = stretchAt(t);
  return pointOn(contour_[stretches_[k].element], partAt(t, k));
}

int ContourProfile::sourceAt(double t) const { return contour_[stretches_[stretchAt(t)].element].source; }

/// Where the contour crosses the level within a stretch between a and b.
double ContourProfile::crossing(double a, double b, double height) const {
  const bool falls = level(at(a)) > level(at(b));
  for (int step = 0; step < 60; ++step) {
    const double middle = 0.5 * (a + b);
    ((level(at(middle)) > height) == falls ? a : b) = middle;
  }
  return 0.5 * (a + b);
}

std::vector<ContourProfile::Zone> ContourProfile::zonesBelow(const Zone& zone, double height) const {
  std::vector<Zone> found;
  const auto add = [&](double a, double b) {
    if (!found.empty() && a - found.back().b < 1e-9) {
      found.back().b = b;
    } else {
      found.push_back({a, b});
    }
  };
  for (double a = zone.a; a < zone.b - 1e-12;) {
    const double b = std::min(zone.b, std::floor(a + 1e-12) + 1.0);
    const double ha = level(at(a)), hb = level(at(b));
    const bool below_a = ha < height - kSameLevel, below_b = hb < height - kSameLevel;
    if (below_a && below_b) add(a, b);
    if (below_a != below_b) {
      const double c = crossing(a, b, height);
      below_a ? add(a, c) : add(c, b);
    }
    a = b;
  }
  return found;
}

double ContourProfile::lowest(const Zone& zone) const {
  double least = std::min(level(at(zone.a)), level(at(zone.b)));
  for (double t = std::ceil(zone.a); t <= zone.b; t += 1.0) least = std::min(least, level(at(t)));
  return least;
}

PlaneContour ContourProfile::between(double a, double b) const {
  PlaneContour pieces;
  while (a < b - 1e-12) {
    const std::size_t k = stretchAt(a + 1e-12), element = stretches_[k].element;
    std::size_t last = k;
    while (last + 1 < stretches_.size() && stretches_[last + 1].element == element &&
           static_cast<double>(last + 1) < b - 1e-12) {
      ++last;
    }
    const double until = std::min(b, static_cast<double>(last + 1));
    pieces.push_back(partOf(contour_[element], partAt(a, k), partAt(until, last)));
    a = until;
  }
  return pieces;
}

}  // namespace proveout
