// Spindles of a channel: what they do beside turning the cutter (manual chapter 11).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/nc/control/control_settings.h"
#include "core/nc/kinematics/axes.h"

namespace proveout::nc {

inline constexpr int kMaxSpindles = kSpindleNames;

/// How a spindle is controlled.
enum class SpindleMode : std::uint8_t {
  kSpeed,     ///< turns, or stands
  kLoop,      ///< position loop closed where it stood
  kOriented,  ///< position loop closed at angle 0
  kSlave,     ///< follows another spindle
  kAxis       ///< is an axis of the channel
};

/// One spindle. The speed and direction of the main one are those of the modal state.
struct SpindleRecord {
  double rpm = 0.0;
  int direction = 0;  ///< +1 M3, -1 M4, 0
  SpindleMode mode = SpindleMode::kSpeed;
  double angle_deg = 0.0;  ///< from the zero pulse; known with a closed loop
  int gear = 0;            ///< range 1 to 8; 0: none chosen yet
};

/// All spindles of a channel by index.
struct Spindles {
  std::array<SpindleRecord, kMaxSpindles> record;
  int programmed = 0;      ///< the last one that S named: M3, M4, M5, M19 are for it
  int main = 0;            ///< the one of feeds per turn, surface speed and threads
  bool has_axes = false;   ///< one of them can become an axis
  bool has_codes = false;  ///< one of them has codes of its own to turn and to stop
};

}  // namespace proveout::nc
