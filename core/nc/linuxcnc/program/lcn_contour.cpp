// The sub that G70, G71 and G72 name: it is run for its motions alone, and then the line itself.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/nc/iso/context/words.h"
#include "core/nc/linuxcnc/flavours/flavours.h"
#include "core/nc/linuxcnc/model/channel.h"
#include "core/nc/linuxcnc/program/lcn_language.h"

namespace proveout::nc {

bool LinuxCncLanguage::inContour() const {
  return std::any_of(open_.begin(), open_.end(), [](const Open& o) { return o.contour; });
}

/// The line that opened the sub is in hand once more: its words are those of the first time. False: another
/// line.
bool LinuxCncLanguage::contourDone() {
  if (!contour_ || !contour_->done) return false;
  const CallFrame& top = c_.calls.top();
  if (top.run != contour_->run || top.block != contour_->line) return false;
  c_.block = std::move(contour_->block);
  linuxCncChannel(c_).contour = std::move(contour_->lines);
  linuxCncChannel(c_).contour_at.reset();
  contour_.reset();
  return true;
}

/// Opens the sub of the contour, if the line has one. Nothing: it has none, or is in error, which its plan
/// tells.
std::optional<Go> LinuxCncLanguage::openContour(StatementFlow& flow) {
  if (!c_.block.present.has('Q') || isGrbl(c_) || linuxCncFlavour(c_) == LinuxCncFlavour::kMach3) return {};
  const auto named = [](const Word& w) {
    const std::int32_t code10 = w.address == 'G' ? code10Of(w) : -1;
    return code10 == 700 || (code10 >= 710 && code10 <= 712) || (code10 >= 720 && code10 <= 722);
  };
  if (std::none_of(c_.block.words.begin(), c_.block.words.end(), named)) return {};
  std::int64_t number = 0;
  CallFrame frame;
  if (!lcnInteger(c_.block.find('Q')->value, number) || !findProgram(fmt::format("{}", number), true, frame))
    return {};
  if (c_.calls.depth() >= kLcnLevels) return oWordFails(flow, "levels", "Too many subroutine levels");
  CallFrame& top = c_.calls.top();
  const double unit = c_.state.unitScale();
  contour_.emplace(Contour{.run = top.run, .line = top.block, .block = c_.block});
  contour_->unit = unit;
  contour_->x_unit = c_.state.axes.diameter[0] ? 0.5 * unit : unit;
  contour_->steps = c_.state.incremental();
  linuxCncChannel(c_).contour_at = c_.position;
  contourGoesTo();
  top.next = top.block;  // comes back to the line
  variables_.enter({});
  open_.push_back({.sub = true, .contour = true});
  return flow.openCall(frame, 1);
}

/// #<_x> and #<_z> follow the words of the line in hand.
void LinuxCncLanguage::contourGoesTo() {
  AxisPoint& at = *linuxCncChannel(c_).contour_at;
  for (const auto& [letter, step, axis, unit] :
       {std::tuple{'X', 'U', 0, contour_->x_unit}, std::tuple{'Z', 'W', 2, contour_->unit}}) {
    if (const Word* w = c_.block.find(letter))
      at[axis] = w->value * unit + (contour_->steps ? at[axis] : 0.0);
    if (const Word* w = c_.block.find(step)) at[axis] += w->value * unit;
  }
}

/// A line of the contour.
void LinuxCncLanguage::takeContourLine() {
  contourGoesTo();
  if (!c_.block.words.empty()) contour_->lines.push_back({c_.block.words, c_.calls.lineIndex()});
}

}  // namespace proveout::nc
