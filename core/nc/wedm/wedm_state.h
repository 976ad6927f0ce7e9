// Modal state of the wire EDM control (digest wedm, D4).
#pragma once

#include <array>

#include "core/geometry/types.h"

namespace proveout::nc {

inline constexpr double kInchMm = 25.4;

/// Copied for every block: the copy is committed when the block is good. Codes by their numbers.
struct WedmState {
  int motion = 0, upper_motion = 0;          ///< G00 to G03; of the upper shape
  int mirror_x = 0, mirror_y = 0, swap = 0;  ///< G05, G06, G08: 1 on
  int skip = 12;
  int units = 21;
  int corner = 28;
  int slow = 35;
  int offset = 40;
  int taper = 50;
  int system = 54;
  int shape = 60;
  int four_axis = 75;
  int distance = 90;
  double extension = 0.0;        ///< G31, mm
  double overcut = 0.0;          ///< G37, mm
  double overcut_dwell = 0.0;    ///< T of G37, s
  int overcut_on = 0;            ///< G37 not yet cancelled
  int h = -1;                    ///< number of the H of the offset, -1: none yet
  double radius = 0.0;           ///< its value when the code was executed, mm
  double angle_deg = 0.0;        ///< A
  int condition = 0;             ///< C, 0: none yet
  int fluid = 0, wire_runs = 0;  ///< T84, T86: 1 on
  int threaded = 1;
  int by_hand = 0;  ///< M00 was there, and no cut since: the operator may cut and thread the wire

  Vec2 main = Vec2::Zero();    ///< programmed point in the main plane, workpiece frame, mm
  Vec2 second = Vec2::Zero();  ///< in the secondary plane
  Vec2 uv = Vec2::Zero();      ///< way of U and V so far, as programmed, mm
  std::array<Vec2, 6> origin{Vec2::Zero(), Vec2::Zero(), Vec2::Zero(),
                             Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};  ///< G54 to G59, workpiece frame, mm
  std::array<Vec2, 6> uv_origin = origin;
  int placed = 0;  ///< a G92 was there
  int moved = 0;

  std::size_t systemIndex() const { return static_cast<std::size_t>(system - 54); }
  /// An odd number of reflections turns arcs round.
  bool reflected() const { return (mirror_x + mirror_y + swap) % 2 != 0; }
  /// A programmed vector as the machine goes: first mirrored, then swapped.
  Vec2 turned(const Vec2& v) const {
    const Vec2 mirrored(mirror_x != 0 ? -v.x() : v.x(), mirror_y != 0 ? -v.y() : v.y());
    return swap != 0 ? Vec2(mirrored.y(), mirrored.x()) : mirrored;
  }
  /// Signed to the left of the way, mm.
  double offsetToLeft() const { return offset == 41 ? radius : offset == 42 ? -radius : 0.0; }
};

}  // namespace proveout::nc
