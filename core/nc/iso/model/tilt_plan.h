// What blocks of G68.2 have told so far: forms P2 and P3 take several.
#pragma once

#include <array>
#include <cstdint>

#include "core/geometry/types.h"

namespace proveout::nc {

struct TiltInput {
  std::int8_t form = 0;        ///< P of the definition in hand, 2 or 3; 0: there is none
  std::uint8_t given = 0;      ///< bits of the Q that have come
  std::array<Vec3, 3> data;    ///< points (P2) or vectors (P3), workpiece coordinates, mm
  Vec3 origin = Vec3::Zero();  ///< P3

  /// Has all come that the form needs?
  bool complete() const { return form == 2 ? given == 7 : form == 3 && given == 3; }
};

}  // namespace proveout::nc
