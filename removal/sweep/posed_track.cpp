#include "removal/sweep/posed_track.h"

#include <algorithm>
#include <cmath>

#include "core/path/posed_way.h"

namespace proveout {

namespace posed_track_detail {

constexpr int kNodes = PosedStretch::kDegree + 1;
/// A stretch turns by no more, so that bounds of derivatives are near the truth.
const double kMostTurn = degToRad(20.0);
constexpr double kMostStretches = 1e6;
constexpr int kMostPieces = 4096;

/// Chebyshev's nodes, and what gives the coefficients of a polynomial by its values there.
struct Interpolation {
  std::array<double, kNodes> nodes;
  Eigen::Matrix<double, kNodes, kNodes> powers;  ///< row: power, column: node

  Interpolation() {
    Eigen::Matrix<double, kNodes, kNodes> values;
    for (int j = 0; j < kNodes; ++j) {
      nodes[static_cast<std::size_t>(j)] = std::cos((2.0 * j + 1.0) * kPi / (2.0 * kNodes));
      double power = 1.0;
      for (int k = 0; k < kNodes; ++k) {
        values(j, k) = power;
        power *= nodes[static_cast<std::size_t>(j)];
      }
    }
    powers = values.inverse();
  }
};

inline const Interpolation& interpolation() {
  static const Interpolation of;
  return of;
}

/// Most length of a derivative of x, y, z from row `first` on.
inline double mostOf(const PosedStretch& s, int first, int derivative) {
  double most = 0.0;
  for (int k = derivative; k < kNodes; ++k) {
    double factor = 1.0;
    for (int i = 0; i < derivative; ++i) factor *= k - i;
    most += factor * s.rows[static_cast<std::size_t>(k)].segment<3>(first).matrix().norm();
  }
  return most;
}

inline PosedStretch stretchOf(const PosedWay& way, double from, double to) {
  const Interpolation& by = interpolation();
  PosedStretch s;
  s.from = from, s.to = to;
  s.rows.fill(PosedStretch::Row::Zero());
  for (int j = 0; j < kNodes; ++j) {
    const ToolPose pose = way.at(s.shareAt(by.nodes[static_cast<std::size_t>(j)]));
    PosedStretch::Row value;
    value << pose.tip.array(), pose.axis.array();
    for (int k = 0; k < kNodes; ++k) s.rows[static_cast<std::size_t>(k)] += by.powers(k, j) * value;
  }
  for (int d = 1; d <= 3; ++d) {
    s.tip[static_cast<std::size_t>(d - 1)] = mostOf(s, 0, d);
    s.axis[static_cast<std::size_t>(d - 1)] = mostOf(s, 3, d);
  }
  return s;
}

/// Turns of the axis, and of the tip about an arc's axis, on all of the motion, rad.
inline double turnOf(const MotionWay& way, const PosedWay& posed) {
  const double sweep = way.arc != nullptr ? std::abs(way.arc->sweep_rad) : 0.0;
  return std::max(posed.boundsOn(0.0, 1.0).axis.velocity, sweep);
}

/// Whether polynomials serve between two shares. Every law is a product of turns at constant rates with what
/// is linear in the share: the derivative with the number n of the axis is no longer than the nth power of
/// the rate, that of the tip than n / 2 times the power of n - 2 times the bound of its second one.
inline bool isShort(const PosedWay& posed, double rate, double from, double to, double longest) {
  const PosedWay::Bounds bounds = posed.boundsOn(from, to);
  const double seventh = 0.5 * kNodes * std::pow(rate, kNodes - 2) * bounds.tip.acceleration +
                         kTrackReachMm * std::pow(rate, kNodes);
  // An interpolation at Chebyshev's nodes is off by that derivative by t, over n! 2^(n - 1).
  double off = seventh * std::pow(0.5 * (to - from), kNodes) / 64.0;
  for (int k = 2; k <= kNodes; ++k) off /= k;
  return off <= kTrackMm && bounds.tip.velocity * (to - from) <= longest;
}

}  // namespace posed_track_detail

using namespace posed_track_detail;

PosedStretch::Pose PosedStretch::poseAt(double t) const {
  Row r = rows[kDegree];
  for (int k = kDegree; k-- > 0;) r = r * t + rows[static_cast<std::size_t>(k)];
  return {r.head<3>().matrix(), r.tail<3>().matrix().normalized()};
}

PosedTrack::PosedTrack(const MotionWay& way, double longest) {
  const PosedWay posed(way.motion, way.arc, *way.axis);
  const double rate = turnOf(way, posed);
  const auto count = static_cast<std::size_t>(std::clamp(std::ceil(rate / kMostTurn), 1.0, kMostStretches));
  for (std::size_t i = 0; i < count; ++i) {
    const double from = static_cast<double>(i) / static_cast<double>(count),
                 to = static_cast<double>(i + 1) / static_cast<double>(count);
    int pieces = 1;
    while (pieces < kMostPieces && !isShort(posed, rate, from, from + (to - from) / pieces, longest))
      pieces *= 2;
    for (int k = 0; k < pieces; ++k)
      stretches_.push_back(
          stretchOf(posed, from + (to - from) * k / pieces, from + (to - from) * (k + 1) / pieces));
  }
  stretches_.shrink_to_fit();
}

}  // namespace proveout
