// What the program has last said of the spindle, motion by motion.
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "core/path/toolpath.h"

namespace proveout {

/// Follows the spindle events of a path, by channel.
class SpindleWatch {
 public:
  /// `path` must outlive this.
  explicit SpindleWatch(const Toolpath& path) : path_(path) {}

  /// The event that brought the spindle into the state in which the motion finds it: the one that started or
  /// stopped it, not one that changed its speed alone. Null: the program has said nothing of it yet. Motions
  /// are asked for in their order.
  const PathEvent* before(MotionId id);

 private:
  struct Last {
    std::string direction;
    const PathEvent* event = nullptr;
  };
  const Toolpath& path_;
  std::size_t next_ = 0;
  std::map<int, Last> last_;  ///< by channel
};

/// Whether the event lets the spindle turn, at whatever speed: M3 or M4.
bool letsTurn(const event::Spindle& spindle);

}  // namespace proveout
