// Blocks of LinuxCNC: order of execution, who owns the axis words, and what its plan functions share.
#pragma once

#include <cmath>
#include <string>

#include "core/nc/iso/context/words.h"
#include "core/nc/linuxcnc/model/channel.h"

namespace proveout::nc {

/// Plans the block in hand in the order in which LinuxCNC executes the parts of a line. False: reported.
bool planLinuxCncBlock(IsoContext& c, BlockPlan& plan);
/// The state of power-on where it is not that of the family.
void powerOnLinuxCnc(const IsoContext& c, IsoState& state);

/// M2, M30: G54 G17 G90 G94 G40 M5 M9 G1 and no feed; all else stays, the shift of G92 and the tool offset
/// too.
void endStateOfLinuxCnc(IsoContext& c, const IsoState& fresh);

/// An error by the interpreter's own text; `name` stands behind "linuxcnc-". Always false.
bool lcnFail(IsoContext& c, const char* name, std::string message, const Word* at = nullptr);

/// Is compensation on in the block or before it?
inline bool lcnCompOn(const IsoContext& c, const BlockPlan& plan) {
  return c.state.compOn() || plan.next.compOn();
}
/// Any word of an axis, or of a polar point.
bool lcnAnyAxis(const IsoContext& c);
/// The end of the axis words in program coordinates, with G53, polar words and diameters. False: reported.
bool lcnTarget(IsoContext& c, BlockPlan& plan, AxisPoint& target);
/// The point that @ and ^ name, seen from `from`, in the plane's coordinates of `target`.
void lcnPolarFrom(IsoContext& c, const BlockPlan& plan, const AxisPoint& from, AxisPoint& target);
/// An arc by radius may miss half its chord by so much, and one of a smaller radius is none, mm.
inline constexpr double kLcnReachMm = 0.00127;
/// May an arc have those radii at its start and its end, mm? By the tolerance of the program's units.
bool lcnRadiiAgree(const IsoContext& c, const BlockPlan& plan, double r1, double r2);
/// The polar point of radius and angle, seen from `from`, into the plane's coordinates of `target`; null: as
/// `from` has it.
void lcnPolarPoint(const BlockPlan& plan, const Word* radius, const Word* angle, const AxisPoint& from,
                   AxisPoint& target);
/// The integer of a word, within 0.0001. False: it is none, reported.
bool lcnInteger(IsoContext& c, const Word& w, std::int64_t& out);
/// Feed of a motion of `length` mm in X, Y, Z and of `turn` degrees; `code` for messages. False: reported.
bool lcnFeed(IsoContext& c, BlockPlan& plan, double length, double turn, const char* code, FeedStyle& style);
/// The same for a straight motion from the plan's start to `to`.
bool lcnLineFeed(IsoContext& c, BlockPlan& plan, const AxisPoint& to, const char* code, FeedStyle& style);
/// Turns a minute that the program gives; 0: none.
double lcnRpm(const IsoContext& c, const BlockPlan& plan);
/// Does the spindle turn behind the M codes of the block?
bool lcnSpindleTurns(const IsoContext& c, const BlockPlan& plan);
/// Way of the degrees in all rotary axes, and length in X, Y, Z.
double lcnTurnOf(const IsoContext& c, const AxisPoint& a, const AxisPoint& b);

/// The program goes on from where the tool really stands, whatever compensation has left over. False:
/// reported.
bool lcnTakeStanding(IsoContext& c);

/// Perform function of blocks with steps; makes `next` of the channel its state.
bool performLinuxCncSteps(IsoContext& c, BlockPlan& plan);
/// Steps that a plan function adds.
void lcnRapid(LinuxCncChannel& own, const AxisPoint& to);
void lcnFeedTo(LinuxCncChannel& own, const AxisPoint& to);

// Plan functions of the code table.
bool planLcnNothing(IsoContext& c, BlockPlan& plan);
bool planLcnRapid(IsoContext& c, BlockPlan& plan);
bool planLcnLine(IsoContext& c, BlockPlan& plan);
bool planLcnArc(IsoContext& c, BlockPlan& plan);
bool planLcnDwell(IsoContext& c, BlockPlan& plan);
bool planLcnCubic(IsoContext& c, BlockPlan& plan);
bool planLcnQuadratic(IsoContext& c, BlockPlan& plan);
bool planLcnNurbs(IsoContext& c, BlockPlan& plan);
bool planLcnNurbsEnd(IsoContext& c, BlockPlan& plan);
bool planLcnKnots(IsoContext& c, BlockPlan& plan);
bool planLcnThread(IsoContext& c, BlockPlan& plan);
bool planLcnTap(IsoContext& c, BlockPlan& plan);
bool planLcnProbe(IsoContext& c, BlockPlan& plan);
bool planLcnCycle(IsoContext& c, BlockPlan& plan);
bool planLcnThreadCycle(IsoContext& c, BlockPlan& plan);
bool planLcnRough(IsoContext& c, BlockPlan& plan);
bool planLcnData(IsoContext& c, BlockPlan& plan);
bool planLcnSetPosition(IsoContext& c, BlockPlan& plan);
bool planLcnShiftOff(IsoContext& c, BlockPlan& plan);
bool planLcnHome(IsoContext& c, BlockPlan& plan);
bool planLcnStoreHome(IsoContext& c, BlockPlan& plan);
/// Modal parts, in their turn.
bool planLcnLength(IsoContext& c, BlockPlan& plan);
bool planLcnFrame(IsoContext& c, BlockPlan& plan);
bool planLcnComp(IsoContext& c, BlockPlan& plan);

}  // namespace proveout::nc
