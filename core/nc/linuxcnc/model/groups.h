// Modal groups that only LinuxCNC has, behind those of the family, and names of its codes.
#pragma once

#include <cstdint>

#include "core/nc/iso/model/codes.h"

namespace proveout::nc {

/// Free numbers of IsoGroup.
inline constexpr std::int8_t kGroupArcCentre = 23;  ///< G90.1 G91.1
inline constexpr std::int8_t kGroupLathe = 24;      ///< G7 G8
static_assert(kGroupLathe < kGroupCount);

/// Codes, the number tenfold. All motions and cycles are of one group here, with G80 as "no motion".
namespace lcn {

inline constexpr std::int32_t kNoMotion = 800;
inline constexpr std::int32_t kCentreAbsolute = 901, kCentreIncremental = 911;
inline constexpr std::int32_t kInverseTime = 930;
inline constexpr std::int32_t kDiameterMode = 70, kRadiusMode = 80;
inline constexpr std::int32_t kDwell = 40, kData = 100;
inline constexpr std::int32_t kLengthByWords = 431, kLengthAdded = 432;
inline constexpr std::int32_t kCompLeftD = 411, kCompRightD = 421;

}  // namespace lcn

}  // namespace proveout::nc
