#include "removal/sweep/kinds/pose_run_body.h"

#include <algorithm>
#include <cmath>

#include "removal/sweep/leaning_sweep.h"

namespace proveout {

int PosePiece::posesOn(const PosedSweep& sweep, const PosedStretch& stretch) {
  const double turn = 2.0 * stretch.axis[0];
  if (std::abs(stretch.middleAxis().z()) - turn < kLeastAxisRise) return 0;
  const double way = 2.0 * stretch.mostShift(farthestFromTip(sweep.profile()));
  const double count = std::ceil(way / posesApart(sweep.profile()));
  return count <= kMostOnStretch ? std::max(1, static_cast<int>(count)) : 0;  // 0 of a point as well
}

bool PosePiece::serves(const PosedSweep& sweep) {
  return std::all_of(sweep.stretches().begin(), sweep.stretches().end(),
                     [&](const PosedStretch& stretch) { return posesOn(sweep, stretch) > 0; });
}

void PosePiece::cut(const PosedSweep& sweep, const PosedStretch& stretch, const PoseSolid& solid,
                    std::deque<PosePiece>& out) {
  const int count = posesOn(sweep, stretch);
  for (int first = 0; first < count; first += kMostSteps)
    out.emplace_back(sweep, stretch, solid, first, std::min(first + kMostSteps, count), count);
}

PosePiece::PosePiece(const PosedSweep& sweep, const PosedStretch& stretch, const PoseSolid& solid, int first,
                     int last, int count)
    : bounds_(boundsBetween(sweep.profile(), stretch, 2.0 * first / count - 1.0, 2.0 * last / count - 1.0)),
      between_(stretch.mostShift(farthestFromTip(sweep.profile())) * static_cast<double>(last - first) /
               count),
      solid_(&solid),
      share_(stretch.shareAt(static_cast<double>(first + last) / count - 1.0)) {
  poses_.reserve(static_cast<std::size_t>(last - first + 1));
  for (int i = first; i <= last; ++i) {
    const PosedStretch::Pose pose = stretch.poseAt(2.0 * i / count - 1.0);
    poses_.push_back(poseAt(pose.tip, pose.axis));
  }
}

}  // namespace proveout
