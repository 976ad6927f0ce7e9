// M70 to M73: the modal state is kept, and comes back by a line of words as the interpreter makes one.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "core/nc/iso/context/words.h"
#include "core/nc/linuxcnc/model/groups.h"
#include "core/nc/linuxcnc/program/lcn_language.h"

namespace proveout::nc {
namespace {

/// Groups whose code comes back, in the order of the line.
constexpr auto kLcnKept =
    std::to_array<int>({kGroupUnits, kGroupPlane, kGroupDistance, kGroupArcCentre, kGroupReturn,
                        kGroupCutting, kGroupLathe, kGroupFeedMode, kGroupWorkSystem});

}  // namespace

bool LinuxCncLanguage::savedState(const Word& m, StatementFlow& flow) {
  const std::size_t level = c_.calls.depth();
  const auto here = [&](const Saved& s) { return s.level == level; };
  switch (static_cast<int>(m.value)) {
    case 71:
      std::erase_if(saved_, here);
      return true;
    case 72: {
      const auto found = std::find_if(saved_.begin(), saved_.end(), here);
      if (found == saved_.end()) {
        return functionFails(m, "no-saved-state",
                             "Cannot restore context from invalid stack frame - missing M70/M73?");
      }
      const Saved saved = *found;
      return restore(saved, flow);
    }
    default:
      std::erase_if(saved_, here);
      saved_.push_back(
          {level, m.value == 73.0, c_.state, run_.mist, run_.flood, linuxCncChannel(c_).shift_on});
      return true;
  }
}

/// The sub in hand is left: M73 has its caller's state come back, and what it saved goes.
bool LinuxCncLanguage::restoreAtReturn(StatementFlow& flow) {
  const std::size_t level = c_.calls.depth();
  const auto here = [&](const Saved& s) { return s.level >= level; };
  const auto found = std::find_if(saved_.begin(), saved_.end(),
                                  [&](const Saved& s) { return s.level == level && s.at_return; });
  bool good = true;
  if (found != saved_.end()) {
    const Saved saved = *found;
    good = restore(saved, flow);
  }
  std::erase_if(saved_, here);
  return good;
}

/// The codes of the groups that have changed.
std::string LinuxCncLanguage::restoringCodes(const IsoState& was) const {
  std::string words;
  const auto back = [&](int group) {
    const auto k = static_cast<std::size_t>(group);
    const std::int32_t code = was.active[k];
    if (code != c_.state.active[k] && code != 0) words += gName(code) + ' ';
  };
  for (const int group : kLcnKept) back(group);
  if (was.active[kGroupSurfaceSpeed] != gcode::kSurfaceSpeed) back(kGroupSurfaceSpeed);
  if (!was.compOn() && c_.state.compOn()) words += "G40 ";
  return words;
}

/// The numbers and functions that have changed, by the units and modes that are in force again.
std::string LinuxCncLanguage::restoringWords(const Saved& saved) const {
  const IsoState &was = saved.state, &is = c_.state;
  // Only what differs: a feed mode that comes back takes an F that was the same along.
  std::string words = was.feed != is.feed ? fmt::format("F{:.9g} ", was.feed) : std::string();
  if (was.active[kGroupSurfaceSpeed] == gcode::kSurfaceSpeed) {
    words += fmt::format("G96 S{:.9g} ", was.surface_speed);
    if (was.speed_limit > 0.0) words += fmt::format("D{:.9g} ", was.speed_limit);
  } else if (was.spindle_rpm != is.spindle_rpm) {
    words += fmt::format("S{:.9g} ", was.spindle_rpm);
  }
  if (was.spindle_direction != is.spindle_direction)
    words += was.spindle_direction == 0 ? "M5 " : was.spindle_direction > 0 ? "M3 " : "M4 ";
  if ((run_.mist && !saved.mist) || (run_.flood && !saved.flood)) words += "M9 ";
  return words;
}

bool LinuxCncLanguage::restore(const Saved& saved, StatementFlow& flow) {
  const IsoState was = saved.state;
  const double scale = was.unitScale();
  const std::string codes = restoringCodes(was), restored = restoringWords(saved);
  if (!runLine(codes, flow) || !runLine(restored, flow)) return false;
  // Whether the shift acts; what it is stays.
  const bool acts = saved.shift_on;
  if (linuxCncChannel(c_).shift_on != acts && !runLine(acts ? "G92.3" : "G92.2", flow)) return false;
  for (const auto& [wanted, is, code] :
       {std::tuple{saved.mist, run_.mist, "M7"}, std::tuple{saved.flood, run_.flood, "M8"}}) {
    if (wanted && !is && !runLine(code, flow)) return false;
  }
  if (was.length == c_.state.length) return true;
  std::string words = "G49";
  if (was.active[kGroupLengthComp] != gcode::kLengthOff) {
    words = "G43.1";
    for (int axis = 0; axis < 3; ++axis)
      words += fmt::format(" {}{:.9g}", "XYZ"[axis], was.length.xyz[axis] / scale);
  }
  return runLine(words, flow);
}

/// Carries out a line that stands in no program, in the place of the one in hand, which comes back.
bool LinuxCncLanguage::runLine(const std::string& words, StatementFlow& flow) {
  if (words.empty()) return true;
  const LcnLine line = std::move(line_);
  Block block = std::move(c_.block);
  own_lines_.push_back(words);  // the block points into it
  c_.block = Block();
  c_.block.text = own_lines_.back();
  c_.block.number = block.number;
  line_ = LcnLine();
  bool good = takeLcnLine(c_.block.text, line_, fault_) && readItems(0, c_.block);
  if (!good) c_.fail(fault_.name, fault_.message);
  c_.block.plain = false;
  good = good && functions(flow) && (c_.block.words.empty() || flow.carryOutWords());
  c_.block = std::move(block);
  line_ = line;
  own_lines_.pop_back();
  return good;
}

}  // namespace proveout::nc
