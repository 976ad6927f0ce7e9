// Tool offsets of Fanuc-like mills (iso-fanuc, sections 6 to 8).
//
// The offset tables hold radii whatever the control holds: with `d_is = "diameter"` G10 and the system
// variables of D are twice what is in the table. In memory A and B a number has one row for H and D: what
// sets it sets both columns.
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// 6000 family of option, `offset_memory`.
enum class FanucMemory { kA, kB, kC };
FanucMemory fanucOffsetMemory(const IsoContext& c);
/// What the control writes for a radius of 1: 2 where D holds diameters, else 1.
double fanucRadiusFactor(const IsoContext& c);

/// In memory A and B the job's rows of H and D are one table. Before the first program.
void fanucJoinOffsets(IsoContext& c);

/// H and D of a block: IsoDialect::offsets.
bool fanucOffsets(IsoContext& c, BlockPlan& plan);
/// Axes of G43 and G44 by `length_type`: IsoDialect::length_axes.
bool fanucLengthAxes(IsoContext& c, const BlockPlan& plan, AxisSet& axes);
/// G10 L1, L10 to L13.
bool planFanucToolOffset(IsoContext& c, BlockPlan& plan);
/// G45 to G48.
bool planFanucPositionOffset(IsoContext& c, BlockPlan& plan);
/// Cutter compensation (section 8): IsoDialect::compensation.
void fanucCompensation(const IsoParameters& parameters, CutterCompPolicy& policy);

}  // namespace proveout::nc
