// What a program may be for: the controls, and flavours of them that programs are written for.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/nc/control/control_info.h"

namespace proveout::nc::guess {

/// Sets of candidates, one bit each.
using Candidates = std::uint16_t;
inline constexpr Candidates kNct = 1, kFanucMill = 2, kHaasMill = 4, kFanucLathe = 8, kHaasLathe = 16,
                            kLinuxCnc = 32, kGrbl = 64, kMach3 = 128, kWl4Mill = 256, kWl4Lathe = 512,
                            kFlexNc = 1024, kWedm = 2048;
inline constexpr Candidates kHaas = kHaasMill | kHaasLathe, kFanucMills = kFanucMill | kHaasMill,
                            kFanucLathes = kFanucLathe | kHaasLathe, kFanuc = kFanucMills | kFanucLathes,
                            kNgc = kLinuxCnc | kGrbl | kMach3, kWl4 = kWl4Mill | kWl4Lathe,
                            kLathes = kFanucLathes | kWl4Lathe | kFlexNc,
                            kMills = kNct | kFanucMills | kNgc | kWl4Mill, kEverybody = 4095;

struct Candidate {
  Candidates bit;
  ControlId control;
  std::string_view flavour;  ///< empty: the default
  /// G codes that it has: "0-4 10 28.1". Machines may have more by their makers: one that is missing only
  /// speaks against it.
  std::string_view codes;
};
/// In the order of the bits.
inline constexpr std::size_t kCandidateCount = 12;
const std::array<Candidate, kCandidateCount>& candidates();

/// Whether a list as Candidate::codes has the code, which is ten times its number.
bool hasCode(std::string_view codes, int tenths);

}  // namespace proveout::nc::guess
