// Speeds along a path: look-ahead over stretches with limits of speed and acceleration (manual chapter 7).
#pragma once

#include <span>
#include <vector>

namespace proveout::nc {

/// A stretch of path with constant limits. Lengths mm (degrees of rotary axes count as mm), seconds.
struct SpeedElement {
  double length = 0.0;        ///< > 0
  double speed = 0.0;         ///< the highest inside, > 0
  double acceleration = 0.0;  ///< along the path, > 0; infinite: speeds jump
  double entry = 0.0;         ///< the highest where it begins, >= 0
};

/// Fastest speeds at the ends of the elements that respect all limits: `entry` at the start (it must allow
/// the path to stop within the elements), 0 behind the last one. Fills elements.size() + 1 speeds.
void planSpeeds(std::span<const SpeedElement> elements, double entry, std::vector<double>& speeds);

/// Time of an element between two speeds of planSpeeds(), s: constant acceleration up to the element's speed
/// or as near as its length allows, and down again.
double elementTime(const SpeedElement& element, double from, double to);

}  // namespace proveout::nc
