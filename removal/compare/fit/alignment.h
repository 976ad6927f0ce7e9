// How a nominal is brought to where the part lies, and what that came to.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/geometry/rigid_transform.h"

namespace proveout {

/// `align` of [nominal].
enum class AlignKind : std::uint8_t {
  kNone,    ///< the nominal lies where the job says
  kFit,     ///< least squares over all of the surface, robust against what is missing or wrong
  kDatums,  ///< by datum features, 3-2-1 (ISO 5459): a plane, then a hole, then a hole
};

struct AlignWish {
  AlignKind kind = AlignKind::kNone;
  double limit_mm = 1.0;  ///< no point of the nominal moves farther, > 0
  /// On the datum features, in their order, in the frame of the placed nominal; of kDatums.
  std::vector<Vec3> datums = {};
};

/// What an alignment came to.
struct Alignment {
  AlignKind kind = AlignKind::kNone;
  RigidTransform motion;     ///< takes the nominal, as it was placed, onto the part
  std::size_t points = 0;    ///< that it rests on
  std::size_t left_out = 0;  ///< points that the fit found to be wrong or missing
  double rms_mm = 0.0;       ///< root mean square of what is left at the points that it rests on
  double moved_mm = 0.0;     ///< the farthest that a point of the nominal was moved
  double turned_rad = 0.0;   ///< by how much it was turned
  /// Directions that the surface does not settle (a round part turns freely): they were left as they were.
  int free_directions = 0;
};

}  // namespace proveout
