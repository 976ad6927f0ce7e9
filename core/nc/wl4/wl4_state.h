// What the WL4 control keeps from block to block. Lengths mm; X is a radius here, on lathes too.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/nc/kinematics/axes.h"
#include "core/nc/services/plane_frame.h"

namespace proveout::nc {

/// Modal codes and values; copied for each block and put back if the block is good.
struct Wl4State {
  int motion = 0, plane = 17, radius = 40, length = 49, system = 53, stop = 64, cycle = 80, distance = 90,
      feed_mode = 94, speed_mode = 97;
  int spindle = 5, coolant = 9, gear = 40;  ///< M functions in force
  double feed = 0.0;                        ///< mm/min or mm/rev
  double pitch = 0.0;                       ///< of the thread in hand, mm
  double speed = 0.0;                       ///< 1/min or m/min
  double speed_limit = 0.0;                 ///< G51 S; 0: none
  int selected_tool = 0;                    ///< last T
  int tool = 0;                             ///< in the spindle
  int d = 0, h = 0;
  AxisPoint system_offset;                      ///< of the selected system
  std::array<double, 3> length_offset{};        ///< selected by G43 and G44, on X, Y, Z
  std::array<double, 3> tool_offset{};          ///< dXw, dZw of the selected tool; lathes
  AxisPoint acting;                             ///< offset of each axis that acts: since its last move
  AxisSet mirrored, mirror_changed;             ///< changed: not moved absolutely since
  double i = 0.0, j = 0.0, k = 0.0, p = 0.0;    ///< last words
  int open_cycle = 0;                           ///< #108
  std::array<double, 3> target{}, increment{};  ///< #130 to #135, X in diameter on lathes

  PlaneFrame frame() const {
    return PlaneFrame(plane == 17 ? Plane::kXY : plane == 18 ? Plane::kZX : Plane::kYZ);
  }
  bool turns() const { return spindle == 3 || spindle == 4; }
  double sign(int axis) const { return mirrored[static_cast<std::size_t>(axis)] ? -1.0 : 1.0; }
  double offset(int axis) const {
    if (axis >= 3) return system_offset[axis];
    const auto of_axis = static_cast<std::size_t>(axis);
    return system_offset[axis] + length_offset[of_axis] + tool_offset[of_axis];
  }
};

}  // namespace proveout::nc
