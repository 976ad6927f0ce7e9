// Offsets by the names that programs call them by: keys of `[offsets.work]`, and those of the command line.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/nc/control/control_settings.h"
#include "io/job/job.h"

namespace proveout {

/// Index of "G54" to "G59" (0 to 5), or the P of "G54.1 P7" as a negative number (-1 to -99). Nothing: no
/// such name.
std::optional<int> workOffsetIndex(const std::string& name);

/// Whole number from 1 to `max` without sign or leading zeros.
std::optional<int> plainNumber(std::string_view text, int max);

/// An offset as the operator enters it: its name, and what is entered (mm; RT and TIP as the control has
/// them).
struct OffsetEntry {
  std::string name;  ///< as job and messages write it: "G55", "G54.1 P7", "common", "D1", "H2", "DXW.3"
  std::vector<double> values;  ///< three for a work offset, else one
};

/// Reads "G55=10,0,-5", "D1=5", "H2=0". Letters may be small, and D and H written "D01". `parameters`: those
/// of the control; one with a parameter H (wires) has its offsets there and no D, one with DXW, DZW, RT and
/// TIP (lathes) takes these as "DXW.3=0.5". Errors: a name that the control does not have, with the nearest
/// one; no number, too many or too few of them; out of range.
Result<OffsetEntry> parseOffset(const std::string& text, const std::vector<ParameterRange>& parameters);

/// Puts it in the place of what the settings say: of a row geometry and wear.
void setOffset(const OffsetEntry& entry, const std::vector<ParameterRange>& parameters,
               ControlSettings& settings);

}  // namespace proveout
