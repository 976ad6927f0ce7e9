#include "core/tool/profile.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/assert.h"

namespace proveout {

void ConvexProfile::extend(double r, double z) {
  max_radius_ = std::max(max_radius_, r);
  z_min_ = std::min(z_min_, z);
  z_max_ = std::max(z_max_, z);
}

void ConvexProfile::start(double r, double z) {
  count_ = 0;
  r_ = r;
  z_ = z;
  max_radius_ = r;
  z_min_ = z_max_ = z;
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
  }
  r_ = r;
  z_ = z;
  extend(r, z);
}

void ConvexProfile::arcTo(double center_r, double center_z, double r, double z) {
  PROVEOUT_ASSERT(count_ < kMaxElements);
  Element& e = elements_[count_++];
  e = Element{};
  e.arc = true;
  e.ar = r_, e.az = z_, e.br = r, e.bz = z;
  e.cr = center_r, e.cz = center_z;
  e.radius = std::hypot(r_ - center_r, z_ - center_z);
  if (center_r == 0.0 && count_ == 1) ball_center_ = center_z;
  extend(r, z);
  r_ = r;
  z_ = z;
}

ProfileSample ConvexProfile::sample(double r, double z) const {
  // Inside, the nearest boundary is the largest of the signed distances to lines and (in their sectors) arcs;
  // outside, the least of the distances to feet and corners.
  ProfileSample in{-std::numeric_limits<double>::infinity(), 0, 1, 0};
  ProfileSample out{std::numeric_limits<double>::infinity(), 0, 1, 0};
  bool outside = false;
  const auto corner = [&](double cr, double cz, int i) {
    const double er = r - cr, ez = z - cz;
    const double distance = std::sqrt(er * er + ez * ez);
    if (distance < out.value && distance > 0.0) out = {distance, er / distance, ez / distance, i};
    if (distance == 0.0) out = {0.0, out.gr, out.gz, i};
  };
  for (int i = 0; i < count_; ++i) {
    const Element& e = elements_[i];
    if (e.arc) {
      const double er = r - e.cr, ez = z - e.cz;
      // Counter-clockwise sector of less than half a turn between the end directions.
      const bool in_sector =
          (e.ar - e.cr) * ez - (e.az - e.cz) * er >= 0.0 && er * (e.bz - e.cz) - ez * (e.br - e.cr) >= 0.0;
      if (!in_sector) {
        corner(e.ar, e.az, i);
        corner(e.br, e.bz, i);
        continue;
      }
      const double distance = std::sqrt(er * er + ez * ez);
      const double s = distance - e.radius;
      const double gr = distance > 0.0 ? er / distance : 0.0;
      const double gz = distance > 0.0 ? ez / distance : -1.0;
      if (s > 0.0) {
        outside = true;
        if (s < out.value) out = {s, gr, gz, i};
      }
      if (s > in.value) in = {s, gr, gz, i};
      continue;
    }
    const double er = r - e.ar, ez = z - e.az;
    const double s = er * e.dz - ez * e.dr;  // outward normal (dz, -dr)
    if (s > in.value) in = {s, e.dz, -e.dr, i};
    const double along = er * e.dr + ez * e.dz;
    if (s > 0.0) outside = true;
    if (along < 0.0) {
      corner(e.ar, e.az, i);
    } else if (along > e.length) {
      corner(e.br, e.bz, i);
    } else if (s > 0.0 && s < out.value) {
      out = {s, e.dz, -e.dr, i};
    }
  }
  return outside ? out : in;
}

namespace {

ConvexProfile frustum(double z0, double r0, double z1, double r1) {
  ConvexProfile p;
  p.start(0.0, z0);
  p.lineTo(r0, z0);
  p.lineTo(r1, z1);
  p.lineTo(0.0, z1);
  return p;
}

/// Ends a profile that has reached (radius, z): up the flank to the end of the flutes and back to the axis.
void closeProfile(ConvexProfile& p, double radius, double flute_end) {
  p.lineTo(radius, flute_end);
  p.lineTo(0.0, flute_end);
}

/// Height at which a point of the given included angle reaches `radius` from `tip_radius`.
double coneHeight(double tip_radius, double radius, double included_deg) {
  return (radius - tip_radius) / std::tan(degToRad(0.5 * included_deg));
}

ConvexProfile cutterProfile(const Tool& tool, double flute_end) {
  const double radius = 0.5 * tool.diameter;
  ConvexProfile p;
  p.start(0.0, 0.0);
  switch (tool.type) {
    case ToolType::kFlat:
      p.lineTo(radius, 0.0);
      break;
    case ToolType::kBall:
      p.arcTo(0.0, radius, radius, radius);
      break;
    case ToolType::kBull:
      p.lineTo(radius - tool.corner_radius, 0.0);
      if (tool.corner_radius > 0.0) {
        p.arcTo(radius - tool.corner_radius, tool.corner_radius, radius, tool.corner_radius);
      }
      break;
    case ToolType::kCone: {
      const double tip = 0.5 * tool.tip_diameter;
      p.lineTo(tip, 0.0);
      const double height = coneHeight(tip, radius, tool.cone_angle_deg);
      if (height >= flute_end) {  // the flutes end on the cone
        const double reached = tip + (radius - tip) * flute_end / height;
        closeProfile(p, reached, flute_end);
        return p;
      }
      p.lineTo(radius, height);
      break;
    }
    case ToolType::kDrill:
      p.lineTo(radius, coneHeight(0.0, radius, tool.point_angle_deg));
      break;
  }
  closeProfile(p, radius, flute_end);
  return p;
}

}  // namespace

ToolSolid makeToolSolid(const Tool& tool) {
  ToolSolid solid;
  double flute_end = tool.flute_length;
  if (flute_end <= 0.0) flute_end = tool.overall_length > 0.0 ? tool.overall_length : kUnlimitedFluteMm;
  solid.cutter = cutterProfile(tool, flute_end);
  if (tool.overall_length > flute_end) {
    const double radius = 0.5 * (tool.shank_diameter > 0.0 ? tool.shank_diameter : tool.diameter);
    solid.shank.push_back(frustum(flute_end, radius, tool.overall_length, radius));
  }
  for (std::size_t i = 1; i < tool.holder.size(); ++i) {
    const Vec2& a = tool.holder[i - 1];
    const Vec2& b = tool.holder[i];
    if (b.x() > a.x()) {  // a step outwards at one height has no volume of its own
      solid.holder.push_back(frustum(tool.overall_length + a.x(), a.y(), tool.overall_length + b.x(), b.y()));
    }
  }
  return solid;
}

}  // namespace proveout
