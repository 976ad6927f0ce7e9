#include "core/nc/kinematics/axis_map.h"

#include <algorithm>
#include <utility>

namespace proveout::nc {

AxisMap::AxisMap() { unexchange(); }

bool AxisMap::onlyDrives() const {
  const auto always = [](const AxisFollow& f) { return f.always; };
  return named() && parked_.none() && std::all_of(follows_.begin(), follows_.end(), always);
}

int AxisMap::nameOf(int axis) const {
  const auto found = std::find(axis_of_.begin(), axis_of_.end(), axis);
  return static_cast<int>(found - axis_of_.begin());
}

const AxisFollow* AxisMap::followOf(int slave) const {
  const auto found =
      std::find_if(follows_.begin(), follows_.end(), [&](const AxisFollow& f) { return f.slave == slave; });
  return found == follows_.end() ? nullptr : &*found;
}

AxisPoint AxisMap::byAxis(const AxisPoint& names) const {
  if (own_names_) return names;
  AxisPoint axes;
  for (int name = 0; name < kMaxAxes; ++name) axes[axisOf(name)] = names[name];
  return axes;
}

void AxisMap::follow(AxisPoint& axes) const {
  for (const AxisFollow& f : follows_) axes[f.slave] = f.sign * axes[f.master] + f.shift;
}

AxisPoint AxisMap::axesAt(const AxisPoint& names) const {
  AxisPoint axes = byAxis(names);
  follow(axes);
  for (int axis = 0; parked_.any() && axis < kMaxAxes; ++axis) {
    if (parked_.test(static_cast<std::size_t>(axis))) axes[axis] = parked_at_[axis];
  }
  return axes;
}

AxisPoint AxisMap::namesAt(const AxisPoint& axes) const {
  if (own_names_) return axes;
  AxisPoint names;
  for (int name = 0; name < kMaxAxes; ++name) names[name] = axes[axisOf(name)];
  return names;
}

AxisPoint AxisMap::followed(const AxisPoint& names) const {
  AxisPoint axes = byAxis(names);
  follow(axes);
  return namesAt(axes);
}

bool AxisMap::canFollow(int master, int slave) const {
  for (int at = master; at != slave;) {
    const AxisFollow* up = followOf(at);
    if (up == nullptr) return true;
    at = up->master;
  }
  return false;
}

void AxisMap::couple(int master, int slave, bool opposite, const AxisPoint& at, bool always) {
  const double sign = opposite ? -1.0 : 1.0;
  follows_.push_back({slave, master, sign, at[slave] - sign * at[master], always});
  slaves_.set(static_cast<std::size_t>(slave));
  order();
}

/// Masters before their slaves.
void AxisMap::order() {
  std::vector<AxisFollow> sorted;
  AxisSet waiting = slaves_;
  while (sorted.size() < follows_.size()) {
    for (const AxisFollow& f : follows_) {
      const auto slave = static_cast<std::size_t>(f.slave);
      if (!waiting.test(slave) || waiting.test(static_cast<std::size_t>(f.master))) continue;
      sorted.push_back(f);
      waiting.reset(slave);
    }
  }
  follows_ = std::move(sorted);
}

void AxisMap::uncouple() {
  std::erase_if(follows_, [](const AxisFollow& f) { return !f.always; });
  slaves_.reset();
  for (const AxisFollow& f : follows_) slaves_.set(static_cast<std::size_t>(f.slave));
}

void AxisMap::exchange(int first, int second) {
  std::swap(axis_of_[static_cast<std::size_t>(nameOf(first))],
            axis_of_[static_cast<std::size_t>(nameOf(second))]);
  own_names_ = false;
}

void AxisMap::unexchange() {
  for (int k = 0; k < kMaxAxes; ++k) axis_of_[static_cast<std::size_t>(k)] = static_cast<std::int8_t>(k);
  own_names_ = true;
}

void AxisMap::park(int axis, const AxisPoint& at) {
  parked_.set(static_cast<std::size_t>(axis));
  parked_at_[axis] = at[axis];
}

void AxisMap::unpark(const AxisPoint& at) {
  parked_.reset();
  for (AxisFollow& f : follows_) {
    if (!f.always) f.shift = at[f.slave] - f.sign * at[f.master];
  }
}

}  // namespace proveout::nc
