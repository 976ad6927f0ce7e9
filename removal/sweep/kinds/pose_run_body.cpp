#include "removal/sweep/kinds/pose_run_body.h"

#include <algorithm>
#include <cmath>

#include "removal/sweep/leaning_sweep.h"

namespace proveout {

namespace pose_run_detail {

/// A tool whose axis rises less leaves rims that planes of the grid's columns do not follow.
constexpr double kLeastAxisRise = 0.25;

/// Least radius at which faces of the profile bend along its way, mm; 0: it has a point.
double leastRadius(const ConvexProfile& profile) {
  double least = profile.maxRadius();
  for (int i = 0; i < profile.elementCount(); ++i) {
    const ConvexProfile::Element& e = profile.element(i);
    if (e.arc) {
      least = std::min(least, e.radius);
    } else if (e.dz != 0.0) {
      least = std::min({least, e.ar, e.br});
    }
  }
  return least;
}

double reachOf(const ConvexProfile& profile) {
  return std::hypot(profile.maxRadius(), std::max(std::abs(profile.zMin()), std::abs(profile.zMax())));
}

/// The solid and all that is nearer to it than `by`, in cylinders and spheres.
PoseSolid grown(const PoseSolid& solid, double by) {
  PoseSolid out;
  out.zones = solid.zones;
  for (int i = 0; i < solid.zones; ++i) {
    const PoseSolid::Zone& z = solid.zone[i];
    PoseSolid::Zone& to = out.zone[i];
    to = {z.low - by, z.high + by, 0.0, 0.0, 0.0, false};
    if (z.gamma < 0.0) {  // (alpha, beta, -1): centre at beta / 2
      const double radius = std::sqrt(z.alpha + 0.25 * z.beta * z.beta) + by;
      to.beta = z.beta, to.gamma = -1.0;
      to.alpha = radius * radius - 0.25 * z.beta * z.beta;
    } else {
      const auto radius2 = [&](double h) { return z.alpha + z.beta * h + z.gamma * h * h; };
      const double widest = std::sqrt(std::max({0.0, radius2(z.low), radius2(z.high)})) + by;
      to.alpha = widest * widest;
    }
  }
  return out;
}

}  // namespace pose_run_detail

using namespace pose_run_detail;

std::optional<PoseSolid> poseSolid(const ConvexProfile& profile) {
  PoseSolid solid;
  if (!(leastRadius(profile) > 0.0)) return std::nullopt;
  for (int i = 0; i < profile.elementCount(); ++i) {
    const ConvexProfile::Element& e = profile.element(i);
    if (e.arc && e.cr != 0.0) return std::nullopt;
    if (e.br > 0.0) solid.rim[solid.rims++] = {e.bz, e.br * e.br};
    if (!e.arc && e.dz == 0.0) continue;
    PoseSolid::Zone& zone = solid.zone[solid.zones++];
    zone = {std::min(e.az, e.bz), std::max(e.az, e.bz), 0.0, 0.0, 0.0, false};
    if (e.arc) {
      zone.alpha = e.radius * e.radius - e.cz * e.cz, zone.beta = 2.0 * e.cz, zone.gamma = -1.0;
    } else {
      const double k = e.dr / e.dz, at_tip = e.ar - k * e.az;
      zone.alpha = at_tip * at_tip, zone.beta = 2.0 * at_tip * k, zone.gamma = k * k, zone.widens = k > 0.0;
    }
  }
  return solid;
}

int PosePiece::posesOn(const PosedSweep& sweep, const PosedStretch& stretch) {
  const double turn = 2.0 * stretch.axis[0];
  if (std::abs(stretch.middleAxis().z()) - turn < kLeastAxisRise) return 0;
  const double way = 2.0 * stretch.mostShift(reachOf(sweep.profile()));
  const double step = std::sqrt(8.0 * kPosesMm * leastRadius(sweep.profile()));
  const double count = std::ceil(way / step);
  return count > kMostOnStretch ? 0 : std::max(1, static_cast<int>(count));
}

bool PosePiece::serves(const PosedSweep& sweep) {
  return std::all_of(sweep.stretches().begin(), sweep.stretches().end(),
                     [&](const PosedStretch& stretch) { return posesOn(sweep, stretch) > 0; });
}

PosePiece::PosePiece(const PosedSweep& sweep, const PosedStretch& stretch, const PoseSolid& solid, int first,
                     int last, int count)
    : solid_(&solid), share_(stretch.shareAt(static_cast<double>(first + last) / count - 1.0)) {
  const ConvexProfile& part = sweep.profile();
  for (int i = first; i <= last; ++i) {
    const PosedStretch::Pose pose = stretch.poseAt(2.0 * i / count - 1.0);
    poses_.push_back({pose.tip.x(), pose.tip.y(), pose.tip.z(), pose.axis.x(), pose.axis.y(), pose.axis.z()});
    if (i != first && i != last) continue;
    const Box3 box = leaningBounds(part, ToolFrame(pose.axis));
    bounds_.extend(Vec3(pose.tip + box.min));
    bounds_.extend(Vec3(pose.tip + box.max));
  }
  // What moves between two poses leaves their chord by an eighth of its second derivative.
  const double wide = 2.0 * (last - first) / count, reach = reachOf(part);
  bounds_ = bounds_.inflated((stretch.tip[1] + reach * stretch.axis[1]) * wide * wide / 8.0 + kTrackMm);
  gap_ = stretch.mostShift(reach) * 2.0 / count;
}

/// No point of a square's columns is farther from the middle one, level, than its corners, and none of the
/// tool between two poses farther from one of them than half of its way.
void PosePiece::reach(const FourBlocks& blocks, double* low, double* high) const {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  bool any = false;
  for (int i = 0; i < 4; ++i) {
    low[i] = kNone, high[i] = -kNone;
    any = any || (blocks.x[i] + blocks.half_width >= bounds_.min.x() &&
                  blocks.x[i] - blocks.half_width <= bounds_.max.x() &&
                  blocks.y[i] + blocks.half_width >= bounds_.min.y() &&
                  blocks.y[i] - blocks.half_width <= bounds_.max.y() && blocks.z_high[i] > bounds_.min.z() &&
                  blocks.z_low[i] < bounds_.max.z());
  }
  if (!any) return;
  const int last = static_cast<int>(poses_.size()) - 1;
  const std::array<PoseAt, 2> ends{poses_.front(), poses_.back()};
  const PoseSolid around =
      grown(*solid_, std::sqrt(2.0) * blocks.half_width + 0.5 * gap_ * last + kCullSlackMm);
  double x[8], y[8], from[8], to[8];
  for (int i = 0; i < 8; ++i) x[i] = blocks.x[i % 4], y[i] = blocks.y[i % 4];
  columnKernels().poses({&around, ends.data(), 2}, x, y, 4, from, to);
  for (int i = 0; i < 4; ++i) {
    const double lowest = std::max(from[i], bounds_.min.z()) - kCullSlackMm,
                 highest = std::min(to[i], bounds_.max.z()) + kCullSlackMm;
    if (!(from[i] <= to[i]) || lowest >= blocks.z_high[i] || highest <= blocks.z_low[i]) continue;
    low[i] = lowest, high[i] = highest;
  }
}

void PoseRunBody::leafColumns(LeafColumns& leaf, unsigned quarters) const {
  for (int q = 0; q < 4; ++q) {
    const int from = q * kQuarter;
    while (q < 4 && (quarters >> q & 1) != 0) ++q;
    if (const int count = q * kQuarter - from; count > 0)
      columns(leaf.x + from, leaf.y + from, count, leaf.lo + from, leaf.hi + from);
  }
}

}  // namespace proveout
