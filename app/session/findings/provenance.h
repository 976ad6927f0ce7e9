// Which clamping left a surface of the part.
#pragma once

#include <optional>

#include "app/session/run/run_result.h"

namespace proveout {

struct MadeBy {
  std::size_t setup = 0;  ///< index into RunResult::setups
  MotionId motion = kNoMotion;
};

/// The motion of an earlier clamping that left the surface nearest to `where` (last clamping's frame, mm),
/// not farther off than `within_mm`. None where that is the blank's own surface, or nothing is that near. A
/// stock that is moved forgets its motions; the surfaces of the clampings before still know them.
std::optional<MadeBy> madeEarlier(const RunResult& run, const Vec3& where, double within_mm);

/// A place of clamping `from` in the last clamping's frame.
Vec3 inLastFrame(const RunResult& run, std::size_t from, const Vec3& where);

}  // namespace proveout
