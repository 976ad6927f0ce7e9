#include "core/tool/profile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "core/base/assert.h"

namespace proveout {

namespace {

/// Share of the products that rounding may shift a point across the border of an arc's sector.
constexpr double kSectorSlack = 1e-14;

}  // namespace

void ConvexProfile::extend(double r, double z) {
  max_radius_ = std::max(max_radius_, r);
  z_min_ = std::min(z_min_, z);
  z_max_ = std::max(z_max_, z);
}

void ConvexProfile::start(double r, double z) {
  count_ = 0;
  cylinder_ = false;
  r_ = r;
  z_ = z;
  max_radius_ = r;
  z_min_ = z_max_ = z;
}

bool ConvexProfile::isCylinder() const {
  const auto& [bottom, flank, top] = std::tie(elements_[0], elements_[1], elements_[2]);
  return !bottom.arc && bottom.ar == 0.0 && bottom.dr == 1.0 && !flank.arc && flank.dz == 1.0 && !top.arc &&
         top.br == 0.0 && top.dr == -1.0;
}

void ConvexProfile::lineTo(double r, double z) {
  const double length = std::hypot(r - r_, z - z_);
  if (length > 0.0) {
    PROVEOUT_ASSERT(count_ < kMaxElements);
    Element& e = elements_[count_++];
    e = Element{};
    e.ar = r_, e.az = z_, e.br = r, e.bz = z;
    e.length = length;
    e.dr = (r - r_) / length;
    e.dz = (z - z_) / length;
    const Element& end = elements_[0];
    const bool half_sphere =
        end.arc && end.cr == 0.0 && end.az == 0.0 && end.br == end.radius && end.bz == end.cz;
    if (count_ == 2 && half_sphere && e.dr == 0.0) ball_center_ = end.cz;
    cylinder_ = count_ == 3 && isCylinder();
  }
  r_ = r;
  z_ = z;
  extend(r, z);
}

/// What sample finds for a cylinder from the axis out, up and back, to the last bit.
ProfileSample ConvexProfile::sampleCylinder(double r, double z) const {
  enum { kBottom, kFlank, kTop };
  const double below = z_min_ - z, beyond = r - max_radius_, above = z - z_max_;
  if (below <= 0.0 && beyond <= 0.0 && above <= 0.0) {
    ProfileSample in{below, 0.0, 0.0, -1.0, first_id_ + kBottom};
    if (beyond > in.value) in = {beyond, 0.0, 1.0, 0.0, first_id_ + kFlank};
    if (above > in.value) in = {above, 0.0, 0.0, 1.0, first_id_ + kTop};
    return in;
  }
  if (beyond <= 0.0) {
    if (below > 0.0) return {below, 0.0, 0.0, -1.0, first_id_ + kBottom};
    return {above, 0.0, 0.0, 1.0, first_id_ + kTop};
  }
  if (below <= 0.0 && above <= 0.0) return {beyond, 0.0, 1.0, 0.0, first_id_ + kFlank};
  const double up = above > 0.0 ? above : -below, distance = std::sqrt(beyond * beyond + up * up);
  return {distance, distance, beyond / distance, up / distance, first_id_ + (above > 0.0 ? kFlank : kBottom)};
}

void ConvexProfile::addArc(double center_r, double center_z, double r, double z) {
  PROVEOUT_ASSERT(count_ < kMaxElements);
  cylinder_ = false;
  Element& e = elements_[count_++];
  e = Element{};
  e.arc = true;
  e.ar = r_, e.az = z_, e.br = r, e.bz = z;
  e.cr = center_r, e.cz = center_z;
  e.radius = std::hypot(r_ - center_r, z_ - center_z);
  extend(r, z);
  r_ = r;
  z_ = z;
}

void ConvexProfile::arcTo(double center_r, double center_z, double r, double z) {
  if (z_ < center_z && z > center_z) {
    addArc(center_r, center_z, center_r + std::hypot(r_ - center_r, z_ - center_z), center_z);
  }
  addArc(center_r, center_z, r, z);
}

double ConvexProfile::lowerHeight(double r) const {
  double height = z_min_;
  for (int i = 0; i < count_; ++i) {
    const Element& e = elements_[i];
    if (e.ar > r || e.br <= e.ar) break;  // beyond r, or on the flank or above
    if (e.arc && e.az >= e.cz) break;
    const double at = std::min(r, e.br);
    height = e.arc ? e.cz - std::sqrt(std::max(0.0, (e.radius - (at - e.cr)) * (e.radius + (at - e.cr))))
                   : e.az + (at - e.ar) * (e.dz / e.dr);
  }
  return height;
}

double ConvexProfile::upperHeight(double r) const {
  double height = z_max_;
  for (int i = count_ - 1; i >= 0; --i) {
    const Element& e = elements_[i];
    if (e.br > r || e.ar <= e.br) break;
    const double at = std::min(r, e.ar);
    height = e.arc ? e.cz + std::sqrt(std::max(0.0, (e.radius - (at - e.cr)) * (e.radius + (at - e.cr))))
                   : e.bz + (at - e.br) * (e.dz / e.dr);
  }
  return height;
}

ProfileSample ConvexProfile::sample(double r, double z) const {
  if (cylinder_) return sampleCylinder(r, z);
  // Inside, the nearest boundary is the largest of the signed distances to lines and (in their sectors) arcs;
  // outside, the least of the distances to feet and corners.
  ProfileSample in{-std::numeric_limits<double>::infinity(), 0.0, 0, 1, 0};
  ProfileSample out{std::numeric_limits<double>::infinity(), 0.0, 0, 1, 0};
  bool outside = false;
  double corner_r = 0.0, corner_z = 0.0, corner2 = std::numeric_limits<double>::infinity();
  int corner_id = 0;
  const auto corner = [&](double cr, double cz, int id) {
    const double er = r - cr, ez = z - cz, distance2 = er * er + ez * ez;
    if (distance2 >= corner2) return;
    corner2 = distance2;
    corner_r = er;
    corner_z = ez;
    corner_id = id;
  };
  for (int i = 0; i < count_; ++i) {
    const Element& e = elements_[i];
    const int id = first_id_ + i;
    if (e.arc) {
      const double er = r - e.cr, ez = z - e.cz;
      // Counter-clockwise sector of less than half a turn between the end directions. Its slack lets the
      // sectors of two arcs that follow one another overlap.
      const double slack = kSectorSlack * e.radius * (std::abs(er) + std::abs(ez) + e.radius);
      const double nar = e.ar - e.cr, naz = e.az - e.cz, nbr = e.br - e.cr, nbz = e.bz - e.cz;
      const bool in_sector = nar * ez - naz * er >= -slack && er * nbz - ez * nbr >= -slack;
      if (!in_sector) {
        // Beyond the tangent at an end, the point is in front of a corner.
        const double limit = e.radius * e.radius + slack;
        if (er * nar + ez * naz > limit || er * nbr + ez * nbz > limit) outside = true;
        corner(e.ar, e.az, id);
        corner(e.br, e.bz, id);
        continue;
      }
      const double distance = std::sqrt(er * er + ez * ez);
      const double s = distance - e.radius;
      const double gr = distance > 0.0 ? er / distance : 0.0;
      const double gz = distance > 0.0 ? ez / distance : -1.0;
      if (s > 0.0) {
        outside = true;
        if (s < out.value) out = {s, distance, gr, gz, id};
      }
      if (s > in.value) in = {s, distance, gr, gz, id};
      continue;
    }
    const double er = r - e.ar, ez = z - e.az;
    const double s = er * e.dz - ez * e.dr;  // outward normal (dz, -dr)
    if (s > in.value) in = {s, 0.0, e.dz, -e.dr, id};
    const double along = er * e.dr + ez * e.dz;
    if (s > 0.0) outside = true;
    if (along < 0.0) {
      corner(e.ar, e.az, id);
    } else if (along > e.length) {
      corner(e.br, e.bz, id);
    } else if (s > 0.0 && s < out.value) {
      return {s, 0.0, e.dz, -e.dr, id};  // a convex region has one nearest point
    }
  }
  if (!outside) return in;
  if (const double distance = std::sqrt(corner2); distance < out.value) {
    if (distance == 0.0) return {0.0, 0.0, 0.0, 1.0, corner_id};
    return {distance, distance, corner_r / distance, corner_z / distance, corner_id};
  }
  return out;
}

}  // namespace proveout
