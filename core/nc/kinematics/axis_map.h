// Which axes move by the words of a program: exchanged, reversed, coupled and parked ones (manual of the nct
// control, 20.2 to 20.7). Plain data. Axes by index, positions in machine coordinates, mm or deg.
//
// A name is what programs say, an axis is what moves. Points "by name" hold under each name the machine
// position of the axis that moves by it now; points "by axis" hold under each axis where it is.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/machine/axis_point.h"

namespace proveout::nc {

/// A slave and its master: slave = sign * master + shift.
struct AxisFollow {
  int slave = 0, master = 0;
  double sign = 1.0, shift = 0.0;
  bool always = false;  ///< gantry or tandem: nothing releases it
};

class AxisMap {
 public:
  AxisMap();

  /// Does every axis move by its own name and by nothing else?
  bool plain() const { return named() && follows_.empty() && parked_.none(); }
  /// Is there nothing but what never parts: drives of one axis?
  bool onlyDrives() const;
  /// plain() of names and directions alone.
  bool named() const { return own_names_ && reversed_.none(); }
  int axisOf(int name) const { return axis_of_[static_cast<std::size_t>(name)]; }
  int nameOf(int axis) const;
  /// Whether the axis of a name goes against its direction: -1, else 1.
  double signOf(int name) const {
    return reversed_.test(static_cast<std::size_t>(axisOf(name))) ? -1.0 : 1.0;
  }
  /// Whether programs must leave the name alone, as its axis is a slave.
  bool isSlave(int name) const { return slaves_.test(static_cast<std::size_t>(axisOf(name))); }
  /// Slaves, by axis.
  const AxisSet& slaves() const { return slaves_; }
  const AxisSet& parked() const { return parked_; }
  const AxisFollow* followOf(int slave) const;
  bool exchanged() const { return !own_names_; }
  const AxisSet& reversed() const { return reversed_; }

  /// The same point by axis; of slaves and parked axes what their own names say.
  AxisPoint byAxis(const AxisPoint& names) const;
  /// Where the axes are for a point by name.
  AxisPoint axesAt(const AxisPoint& names) const;
  /// The point by name for axes that stand there.
  AxisPoint namesAt(const AxisPoint& axes) const;
  /// A point by name with the slaves where their masters take them; parked axes count as if they moved.
  AxisPoint followed(const AxisPoint& names) const;

  // Switching. `at`: where the axes stand, by axis.
  /// The slave must be no slave yet, and no master of its master (canFollow()).
  void couple(int master, int slave, bool opposite, const AxisPoint& at, bool always = false);
  /// Whether that leads round in no circle.
  bool canFollow(int master, int slave) const;
  void uncouple();
  void exchange(int first, int second);
  void unexchange();
  void reverse(int axis) { reversed_.set(static_cast<std::size_t>(axis)); }
  void unreverse() { reversed_.reset(); }
  void unreverse(int axis) { reversed_.reset(static_cast<std::size_t>(axis)); }
  void park(int axis, const AxisPoint& at);
  /// Slaves go on from where they stand: nothing brings them up with their masters.
  void unpark(const AxisPoint& at);

 private:
  void order();
  void follow(AxisPoint& axes) const;

  std::array<std::int8_t, kMaxAxes> axis_of_{};  ///< by name
  bool own_names_ = true;
  AxisSet reversed_, parked_, slaves_;  ///< by axis
  std::vector<AxisFollow> follows_;     ///< masters before their slaves
  AxisPoint parked_at_;
};

}  // namespace proveout::nc
