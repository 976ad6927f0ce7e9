// Modal data of axes and coordinate words: planes by axis, polar data, diameters, virtual axes, threads.
#pragma once

#include <cstdint>

#include "core/machine/axis_point.h"

namespace proveout::nc {

/// A plane one of whose axes is a rotary axis taken for a linear one.
enum class VirtualMode : std::uint8_t {
  kOff,
  kPolar,    ///< G12.1: face of a part, the rotary axis stands for the missing linear one
  kCylinder  ///< G7.1: the surface of a cylinder, unrolled
};

/// The last word of G16, and where it led.
struct PolarData {
  bool known = false;
  double radius = 0.0;      ///< mm, about the origin
  double angle_deg = 0.0;   ///< not reduced to a turn
  double u = 0.0, v = 0.0;  ///< the end point, program coordinates: elsewhere the data are worked out anew
};

/// Owns no memory.
struct AxisModal {
  std::int8_t plane_u = 0, plane_v = 1, plane_w = 2;  ///< axes of the plane; u, v may be parallel or rotary
  AxisSet diameter;                                   ///< axes whose words are diameters
  PolarData polar;
  VirtualMode mode = VirtualMode::kOff;
  std::int8_t linear = -1, rotary = -1;  ///< axes of the virtual plane
  double cylinder_mm = 0.0;              ///< radius of G7.1
  std::int8_t smoothing = 0;             ///< Q of G5.1; 1 is look-ahead alone
  AxisSet smooth_axes;                   ///< that take part; none: all linear ones
  double thread_lead = 0.0;              ///< mm/turn, of G33; 0: none yet
  bool threading = false;  ///< the last block cut a thread: the next one goes on without a new start

  /// The plane by its axes; `w` is across it.
  void setPlane(int u, int v, int w) {
    plane_u = static_cast<std::int8_t>(u);
    plane_v = static_cast<std::int8_t>(v);
    plane_w = static_cast<std::int8_t>(w);
  }
  /// mm of the unrolled cylinder for a degree.
  double mmPerDegree() const { return cylinder_mm * 0.017453292519943295; }
};

}  // namespace proveout::nc
