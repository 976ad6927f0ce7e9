// What plan functions do with words: numbers, axis targets, feeds.
#pragma once

#include <cstdint>
#include <string>

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// "G54.1" of 541.
std::string gName(int code10);
/// G codes as they count for a code table: 54.1 -> 541; -1 if there is more than one decimal. A computed
/// value is rounded to one decimal.
std::int32_t code10Of(const Word& w);
/// The number of an M word, rounded where it was computed; -1: it is no integer.
std::int32_t mNumber(const Word& w);
/// A length of the block in mm.
inline double lengthOf(const BlockPlan& plan, const Word& w) { return w.value * plan.next.unitScale(); }
/// The words of the block as the control reads their numbers (IsoDialect::take_words); data blocks are left
/// as they are. False: reported.
bool takeWords(IsoContext& c);
/// The integer that a word must hold. False, with alarm 2002: no integer, or out of range.
bool integerWord(IsoContext& c, const Word& w, std::int64_t min, std::int64_t max, std::int64_t& out);
/// Whether polar data (G16) change the meaning of axis words, and whether coordinates go on with rotary axes.
enum class WordsAre { kModal, kRectangular, kReference };
/// End point of the axis words, in the plan's chain, mm; marks the named axes in plan.motion.named. False: an
/// axis is given twice, or cannot go there.
bool axisTarget(IsoContext& c, BlockPlan& plan, AxisPoint& target, WordsAre words = WordsAre::kModal);
/// Whether the program may move the axis of that name: it is no slave (manual 20.2). False: reported.
bool mayMove(IsoContext& c, const Word& w, int axis);
/// Way of a rotary axis to the absolute position `value`, or by the step `value`: turns count as N0107 says.
double rotaryTravel(const IsoContext& c, int axis, double from, double value, bool step);
/// Position of an axis, mm or degrees, as the control tells it: rotary axes with N0107.REN within one turn, 0
/// to below N0108 (manual 5.6).
double shownPosition(const IsoContext& c, int axis, double value);
/// Is there but the G code and axis words in the block? False: reported.
bool ownBlock(IsoContext& c, std::string_view name);
/// The same with the words of the code beside it; axes other than X, Y and Z are none of them.
bool ownBlockOf(IsoContext& c, std::string_view name, AddressSet words);
/// Axes whose words are diameters at power-on.
AxisSet diameterAxes(const IsoContext& c);

/// The plane of arcs and compensation.
inline WorkPlane planeOf(const IsoState& state) { return state.workPlane(); }

/// What an axis word names.
struct AxisWord {
  int axis = 0;           ///< index
  bool step = false;      ///< counts from where the tool is: G91, operator I, or U V W for X Y Z
  bool own_step = false;  ///< incremental by its own address or operator, whatever G90 and G91 say
};
/// Is it the word of an axis? U V W are X Y Z incrementally unless axes of these names are configured.
inline bool axisWord(const BlockPlan& plan, const Word& w, AxisWord& out) {
  const bool secondary = w.axis < 0 && w.address >= 'U' && w.address <= 'W';
  if (w.axis < 0 && !secondary) return false;
  out.axis = secondary ? w.address - 'U' : w.axis;
  out.own_step = secondary || w.incremental;
  out.step = out.own_step || plan.next.incremental();
  return true;
}
/// Value of an axis word in mm or degrees: units count for linear axes only, diameters are halved. In a
/// virtual plane its rotary axis counts in mm.
inline double axisValue(const IsoContext& c, const BlockPlan& plan, const AxisWord& word, const Word& w) {
  const AxisModal& modal = plan.next.axes;
  if (word.axis >= kMainAxes && c.axes.at(word.axis).rotary()) {
    if (modal.mode == VirtualMode::kOff || word.axis != modal.rotary) return w.value;
    return modal.mode == VirtualMode::kPolar ? lengthOf(plan, w) : w.value * modal.mmPerDegree();
  }
  return modal.diameter[static_cast<std::size_t>(word.axis)] ? 0.5 * lengthOf(plan, w) : lengthOf(plan, w);
}

/// False: a word of the block stands there twice, or has a minus sign, where it may not; reported.
bool checkRepeats(IsoContext& c);

}  // namespace proveout::nc
