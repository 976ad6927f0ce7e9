// Rapids that overlap: where the axes are while one rapid slows down and the next one begins (NCT manual
// 4.1.2). Every axis speeds up and slows down by itself, so that a rapid of several axes is straight only
// where none of them does, and the corner between two rapids is rounded.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "core/machine/axis_point.h"

namespace proveout::nc {

/// One axis of a rapid, from stand to stand. mm or degrees, s.
class AxisRamp {
 public:
  AxisRamp() = default;
  /// `speed` > 0; `acceleration` 0: the speed is there at once.
  AxisRamp(double way, double speed, double acceleration);

  bool moves() const { return way_ != 0.0; }
  double way() const { return way_; }         ///< signed
  double peak() const { return peak_; }       ///< highest speed, >= 0
  double ramp() const { return ramp_; }       ///< time of speeding up and of slowing down, s
  double duration() const { return total_; }  ///< s
  double wayAt(double time) const;            ///< signed, `time` from its start
  /// The integral of wayAt() from its start.
  double integralAt(double time) const;

 private:
  double way_ = 0.0, peak_ = 0.0, ramp_ = 0.0, total_ = 0.0;
};

/// Of all axes: the highest speeds of rapids, per s, and accelerations, per s^2; 0: at once.
struct RapidAxes {
  int count = kMainAxes;
  std::array<double, kMaxAxes> speed{}, acceleration{};
  double rise_s = 0.0;  ///< time in which the accelerations come up (averages over it); 0: at once
};

/// A rapid whose axes start together.
struct RapidLeg {
  AxisPoint from, to;
  std::array<AxisRamp, kMaxAxes> axes;
  double start = 0.0;  ///< s, on a clock of the caller's
  double end = 0.0;    ///< when the last axis stands
};

/// A rapid at its fastest: while none of its axes speeds up or slows down, they go along the line.
RapidLeg rapidLeg(const AxisPoint& from, const AxisPoint& to, double start, const RapidAxes& axes);

/// When the rapid behind `leg` starts: all axes of `leg` are down to `share` (0 to 1) of the highest speed
/// that they had. Later where an axis of both would have to turn round, or could not keep the speed that it
/// has left in the same direction; then no axis ever accelerates more than it may.
double overlapStart(const RapidLeg& leg, const RapidLeg& next, double share, const RapidAxes& axes);

/// Where the axes are while `leg` goes on and `tail`, the rapid before it, has not ended (null: it has).
AxisPoint overlapPoint(const RapidLeg* tail, const RapidLeg& leg, double time, const RapidAxes& axes);

/// No point of the way is farther than this from its chord; mm, degrees of rotary axes count as mm.
inline constexpr double kOverlapChordMm = 0.001;

/// The way between two times as chords: tells the end of each and how long the axes take to it, s. Straight
/// stretches are one chord.
void overlapChords(const RapidLeg* tail, const RapidLeg& leg, double from, double to, const RapidAxes& axes,
                   const std::function<void(const AxisPoint&, double)>& tell);

}  // namespace proveout::nc
