// Numbers by which the rules speak of the codes of lathes. What programs write depends on the system of G
// codes: the rows of tables/lathe.cpp say it.
#pragma once

#include <cstdint>

namespace proveout::nc::lathe_code {

/// Beyond every G code: the numbers of system A tenfold, and 100000.
inline constexpr std::int32_t kTurning = 100900, kThreading = 100920, kFacing = 100940;
inline constexpr std::int32_t kVaryingThread = 100340;
inline constexpr std::int32_t kFinish = 100700, kRoughTurning = 100710, kRoughFacing = 100720,
                              kPattern = 100730, kFacePeck = 100740, kGroove = 100750, kThreadCycle = 100760;

}  // namespace proveout::nc::lathe_code
