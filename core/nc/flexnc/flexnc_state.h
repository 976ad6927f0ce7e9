// What the FlexNC control keeps from block to block. Lengths mm; X is a radius here.
#pragma once

#include <cstdint>
#include <optional>

#include "core/geometry/types.h"

namespace proveout::nc {

/// Modal codes and values.
struct FlexState {
  int motion = -1;  ///< G00 to G03; -1: the program has named none
  int plane = 18, comp = 40, distance = 90, feed_mode = 98, css = 87;
  int spindle = 5, coolant = 9;    ///< M functions in force
  double feed = 0.0;               ///< mm/min or mm/rev, as `feed_mode` says
  double rpm = 0.0;                ///< 1/min, last S while G87 is on
  double surface = 0.0;            ///< m/min, last S while G86 is on
  std::int32_t selected_tool = 0;  ///< last T
  std::int32_t tool = 0;           ///< in the turret's working place
  std::int32_t d = 0;              ///< corrector in force
  Vec2 shift = Vec2::Zero();       ///< G52: of the local system, (x, z)
  Vec2 corrector = Vec2::Zero();   ///< shift of corrector D, (x, z)
  int feed_unit = 98;              ///< G98 or G99, as it was when F was told
  std::int32_t behind_cycle = 0;   ///< 1: a cycle ran, and no motion code behind it yet

  bool turns() const { return spindle == 3 || spindle == 4; }
};

}  // namespace proveout::nc
