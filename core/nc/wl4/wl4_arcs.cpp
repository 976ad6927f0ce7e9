#include "core/nc/wl4/wl4_arcs.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/nc/services/plane_curves.h"

namespace proveout::nc {

namespace {

constexpr double kQuarterTolerance = 0.01;  ///< mm, of the legs of G12 and G13

bool readRadius(Wl4Context& c, ArcRequest& request) {
  const double radius = c.block.value('R');
  const Columns& at = c.block.at('R');
  const double chord = (request.end - request.start).head<2>().norm();
  if (!(radius > 0.0)) return c.report.fail("wl4-radius-word", "R of an arc has to be positive", at);
  if (chord > 2.0 * radius + kQuarterTolerance) {
    return c.report.fail("wl4-arc",
                         fmt::format("the end is {:.3f} mm away: R{} does not reach it", chord, radius), at);
  }
  request.radius = std::max(radius, 0.5 * chord);
  if (request.center_u || request.center_v)
    c.report.warn("wl4-arc", "R and a centre in one block: R counts", at);
  return true;
}

/// Always false.
bool failArc(Wl4Context& c, int motion, const ArcResolution& resolved) {
  switch (resolved.error) {
    case ArcError::kNoDefinition:
      return c.report.fail(
          "wl4-arc", c.block.hasCode(motion)
                         ? std::string("an arc needs its centre (two of I J K) or R")
                         : fmt::format("G{} of an earlier block still holds, and an arc needs its centre "
                                       "(two of I J K) or R; for a line program G1",
                                       motion));
    case ArcError::kCenterOutsidePlane:
      return c.report.fail("wl4-arc", "the centre is given outside the plane of G17, G18 or G19");
    case ArcError::kRadiusDifference:
      return c.report.fail("wl4-arc",
                           fmt::format("the end is off the circle by {:.4f} mm", resolved.radius_difference));
    default:
      return c.report.fail("wl4-arc", "these words give no arc");
  }
}

}  // namespace

bool resolveBlockArc(Wl4Context& c, const Wl4BlockPlan& p, PlaneArc& arc, bool& moves) {
  const Wl4State& s = p.next;
  const PlaneFrame f = s.frame();
  const WorkPlane w(f);
  ArcRequest request;
  request.start = w.of(c.machine);
  request.end = w.of(p.target);
  request.has_plane_end =
      p.named[static_cast<std::size_t>(f.u())] || p.named[static_cast<std::size_t>(f.v())];
  request.has_other_axis = p.named.count() > 0 && !request.has_plane_end;
  request.counter_clockwise = (s.motion == 3) != c.setup.flipped(s);
  constexpr std::string_view kCenters = "IJK";
  const auto center = [&](int axis) -> std::optional<double> {
    const char letter = kCenters[static_cast<std::size_t>(axis)];
    if (!c.block.has(letter)) return std::nullopt;
    return s.sign(axis) * c.block.value(letter);
  };
  request.center_u = center(f.u());
  request.center_v = center(f.v());
  request.center_word_outside_plane = c.block.has(kCenters[static_cast<std::size_t>(f.w())]);
  if (c.block.has('R') && !readRadius(c, request)) return false;
  const ArcResolution resolved = resolveArc(request);
  if (!resolved.ok()) return failArc(c, s.motion, resolved);
  moves = !resolved.no_motion;
  arc = resolved.arc;
  return true;
}

bool resolveQuarter(Wl4Context& c, const Wl4BlockPlan& p, Vec2& center, double& sweep) {
  const WorkPlane w(p.next.frame());
  if (!p.named[static_cast<std::size_t>(w.u)] || !p.named[static_cast<std::size_t>(w.v)] ||
      p.named.count() != 2) {
    return c.report.fail("wl4-corner-arc",
                         "G12 and G13 need the end on both axes of the plane and no other word");
  }
  const Vec2 from = w.of(c.machine).head<2>(), to = w.of(p.target).head<2>(), d = to - from;
  if (std::abs(std::abs(d.x()) - std::abs(d.y())) > kQuarterTolerance || d.norm() < 1e-6) {
    return c.report.fail("wl4-corner-arc",
                         fmt::format("G12 and G13 are quarter circles: the way is {:.3f} and {:.3f} mm",
                                     std::abs(d.x()), std::abs(d.y())));
  }
  const bool ccw = (p.next.motion == 13) != c.setup.flipped(p.next);
  const double turn = ccw ? 1.0 : -1.0;
  center = Vec2(from.x(), to.y());
  const Vec2 arm = from - center, other = to - center;
  if (turn * cross2(arm, other) < 0.0) center = Vec2(to.x(), from.y());
  sweep = turn * kPi / 2.0;
  return true;
}

}  // namespace proveout::nc
