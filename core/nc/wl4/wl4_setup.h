// What stays as it is while a program of the WL4 control runs: machine, settings, parameters.
#pragma once

#include "core/nc/control/control_host.h"
#include "core/nc/control/control_settings.h"
#include "core/nc/kinematics/axes.h"
#include "core/nc/wl4/wl4_parameters.h"
#include "core/nc/wl4/wl4_state.h"

namespace proveout::nc {

struct Wl4Setup {
  Wl4Setup(bool is_lathe, const ControlSettings& given, const ControlHost& asked)
      : lathe(is_lathe), settings(given), host(asked), axes(settings) {}
  Wl4Setup(const Wl4Setup&) = delete;
  Wl4Setup& operator=(const Wl4Setup&) = delete;

  /// Words and variables of the axis are diameters.
  bool wantsDiameter(int axis) const { return lathe && axis == 0; }
  /// Whether "clockwise" and "left" of the program are the other way round in the plane (u, v).
  bool flipped(const Wl4State& s) const;
  /// Radius that cutter compensation keeps off the contour, mm; may be below 0.
  double compRadius(const Wl4State& s) const;
  /// Of the touch-off point from the nose centre, (z, x), mm.
  Vec2 tipOf(const Wl4State& s) const;

  const bool lathe;
  const ControlSettings settings;
  const ControlHost host;
  Wl4Parameters parameters;  ///< set once, before the first block
  const AxisTable axes;
};

}  // namespace proveout::nc
