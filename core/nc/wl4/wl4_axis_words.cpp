#include "core/nc/wl4/wl4_axis_words.h"

#include <fmt/core.h>

#include <cmath>
#include <string>
#include <string_view>

namespace proveout::nc {

namespace {

constexpr double kMostTravel = 9999.999;  ///< mm

/// A word of an axis, its value in mm of radius.
struct AxisValue {
  char letter;
  bool step;  ///< U, V, W
  double value;
};

/// The axis' word in the block, the later one of two; the plan names it then. Nothing in `out`: there is
/// none.
bool readAxis(Wl4Context& c, Wl4BlockPlan& p, int axis, std::optional<AxisValue>& out) {
  const Wl4Block& b = c.block;
  const char absolute = c.setup.axes.at(axis).name[0], incremental = axis < 3 ? "UVW"[axis] : '\0';
  const bool first = b.has(absolute), second = incremental != '\0' && b.has(incremental);
  if (!first && !second) return true;
  const char letter = first && (!second || b.later(absolute, incremental)) ? absolute : incremental;
  const double value = b.value(letter) * (c.setup.wantsDiameter(axis) ? 0.5 : 1.0);
  if (!(std::abs(value) <= kMostTravel)) {
    return c.report.fail("wl4-range", fmt::format("{}: the axis travels {} mm at most", letter, kMostTravel),
                         b.at(letter));
  }
  p.named.set(static_cast<std::size_t>(axis));
  out = AxisValue{letter, letter == incremental, value};
  return true;
}

bool planPosition(Wl4Context& c, Wl4BlockPlan& p, int axis) {
  std::optional<AxisValue> word;
  if (!readAxis(c, p, axis, word)) return false;
  if (!word) return true;
  const auto k = static_cast<std::size_t>(axis);
  const bool distance = word->step || p.next.distance == 91;
  const double offset = p.next.offset(axis);
  if (distance && p.next.mirror_changed[k]) {
    return c.report.fail("wl4-mirror",
                         fmt::format("the first motion of {} behind G50 or G51 has to be absolute",
                                     c.setup.axes.at(axis).name[0]),
                         c.block.at(word->letter));
  }
  p.target[axis] = distance
                       ? c.machine[axis] + p.next.sign(axis) * word->value + offset - c.state.acting[axis]
                       : offset + p.next.sign(axis) * word->value;
  p.next.acting[axis] = offset;
  p.next.mirror_changed.reset(k);
  return true;
}

/// A, B, C that are no axes: B is a chamfer.
bool planOtherLetters(Wl4Context& c, Wl4BlockPlan& p) {
  for (const char letter : std::string_view("ABC")) {
    if (!c.block.has(letter) || c.setup.axes.find(std::string_view(&letter, 1)) >= 0) continue;
    if (letter != 'B') {
      return c.report.fail("wl4-axis", fmt::format("there is no axis {} in the job", letter),
                           c.block.at(letter));
    }
    p.chamfer = c.block.value('B');
    if (!(p.chamfer >= 0.0))
      return c.report.fail("wl4-chamfer", "the leg of a chamfer is not negative", c.block.at('B'));
  }
  // A full circle names its centre alone.
  const Wl4Block& b = c.block;
  p.moves = p.named.any() || (p.arc() && (b.has('I') || b.has('J') || b.has('K')));
  return true;
}

/// What programs read of the motion (#130 to #135).
void remember(const Wl4Context& c, Wl4BlockPlan& p) {
  if (!p.moves) return;
  Wl4State& next = p.next;
  for (int axis = 0; axis < 3; ++axis) {
    const double unit = c.setup.wantsDiameter(axis) ? 2.0 : 1.0;
    const auto k = static_cast<std::size_t>(axis);
    next.target[k] = unit * next.sign(axis) * (p.target[axis] - next.acting[axis]);
    next.increment[k] = unit * next.sign(axis) * (p.target[axis] - c.machine[axis]);
  }
}

/// Axes with names of more letters have no words.
bool hasWord(const Wl4Context& c, int axis) { return c.setup.axes.at(axis).name.size() == 1; }

}  // namespace

bool planPositions(Wl4Context& c, Wl4BlockPlan& p) {
  if (p.mirror) return true;
  for (int axis = 0; axis < c.setup.axes.count(); ++axis) {
    if (hasWord(c, axis) && !planPosition(c, p, axis)) return false;
  }
  if (!planOtherLetters(c, p)) return false;
  remember(c, p);
  return true;
}

bool planDwell(Wl4Context&, Wl4BlockPlan&) { return true; }

bool planReference(Wl4Context& c, Wl4BlockPlan& p) {
  if (p.mirror) return true;
  for (int axis = 0; axis < c.setup.axes.count(); ++axis) {
    std::optional<AxisValue> word;
    if (!hasWord(c, axis)) continue;
    if (!readAxis(c, p, axis, word)) return false;
    if (word) p.target[axis] = 0.0;
  }
  return planOtherLetters(c, p);
}

bool planSystem(Wl4Context& c, Wl4BlockPlan& p) {
  bool any = false;
  for (int axis = 0; axis < c.setup.axes.count(); ++axis) {
    const std::string& name = c.setup.axes.at(axis).name;
    if (!hasWord(c, axis) || !c.block.has(name[0])) continue;
    any = true;
    const double value = c.block.value(name[0]) * (c.setup.wantsDiameter(axis) ? 0.5 : 1.0);
    const double length = p.next.offset(axis) - p.next.system_offset[axis];
    p.next.system_offset[axis] = c.machine[axis] - length - p.next.sign(axis) * value;
    p.next.acting[axis] = p.next.offset(axis);
  }
  p.next.system = 92;
  return any || c.report.fail("wl4-g92", "G92 needs the coordinates of the position: G92 X0 Y0 Z100");
}

bool planContourCycle(Wl4Context& c, Wl4BlockPlan& p) { return p.contour || planPositions(c, p); }

}  // namespace proveout::nc
