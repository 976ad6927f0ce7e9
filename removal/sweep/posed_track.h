// The way of a tool whose axis turns, in stretches on which tip and axis are polynomials: what searches on
// that way evaluate, whatever the law of the motion.
//
// Workpiece frame, mm. The polynomials are within kTrackMm of the tip, and so near to the axis that no point
// of a tool is farther off, up to kTrackReachMm from its tip. Searches are about them, so that bounds of
// their derivatives, which follow from their coefficients, prove what is said of them.
#pragma once

#include <array>
#include <vector>

#include "removal/sweep/tool_frame.h"

namespace proveout {

inline constexpr double kTrackMm = 2e-9, kTrackReachMm = 200.0;

/// A stretch, by a parameter t from -1 to 1 that grows linearly with the share of the motion.
struct PosedStretch {
  static constexpr int kDegree = 6;
  /// x, y, z of the tip, then of the axis.
  using Row = Eigen::Array<double, 6, 1>;

  /// Tip and axis with their first two derivatives by t.
  struct Moving {
    Row at, first, second;
  };
  Moving at(double t) const {
    Moving m{rows[kDegree], Row::Zero(), Row::Zero()};
    for (int k = kDegree; k-- > 0;) {
      m.second = m.second * t + m.first;
      m.first = m.first * t + m.at;
      m.at = m.at * t + rows[static_cast<std::size_t>(k)];
    }
    m.second *= 2.0;
    return m;
  }
  struct Pose {
    Vec3 tip, axis;  ///< axis: unit, from the tip to the spindle
  };
  Pose poseAt(double t) const;
  double shareAt(double t) const { return 0.5 * (from + to) + 0.5 * t * (to - from); }
  Vec3 middleTip() const { return rows[0].head<3>(); }
  Vec3 middleAxis() const { return rows[0].tail<3>(); }
  /// No point so far from the tip moves farther than that from where it is at t = 0.
  double mostShift(double reach) const { return tip[0] + axis[0] * reach; }

  double from = 0.0, to = 1.0;          ///< shares of the motion
  std::array<Row, kDegree + 1> rows;    ///< by powers of t
  std::array<double, 3> tip{}, axis{};  ///< most lengths of the first three derivatives by t
};

class PosedTrack {
 public:
  /// `longest`: of the tip's way on one stretch, mm, about.
  PosedTrack(const MotionWay& way, double longest);

  const std::vector<PosedStretch>& stretches() const { return stretches_; }

 private:
  std::vector<PosedStretch> stretches_;
};

}  // namespace proveout
