// What the control took a lathe tool for, held against the insert of the job, and what that did to the part.
#pragma once

#include <optional>
#include <vector>

#include "app/session/run/run_result.h"

namespace proveout {

/// Two kinds of findings. `nose_deviation`: slopes and arcs of the part's surface that an insert left without
/// compensation of its nose; one warning an insert, for the block with the largest deviation above
/// `least_mm`. `tool_data`: nose radius, tip and corrector that the control used for an insert and that are
/// not the insert's, one an insert and set of data: an error where surfaces of the part are off by more than
/// `least_mm` because of it (a warning where that is the allowance of a corrector), else a note. The largest
/// error is in closed form: the control lays the circle of its nose against the contour, the insert's own
/// circle stands where the touch-off point does.
void addNoseFindings(const SetupRun& setup, double least_mm, const RecordingSource& texts,
                     std::vector<Finding>& findings);

/// What of these data is wrong behind a surface that `motion` left `beyond_mm` too deep (below 0: too high)
/// at `where`, `outward` being its unit normal, and how much of that it explains. Nothing: all is right.
std::optional<Cause> noseCause(const SetupRun& setup, MotionId motion, const Vec3& where, const Vec3& outward,
                               double beyond_mm);

/// What a comparison with nothing to object says of such findings: uncompensated noses are in the program's
/// coordinates and no longer told, wrong data of tools have done no harm and are warnings.
void dropRefuted(const Comparison& comparison, std::vector<Finding>& findings);

}  // namespace proveout
