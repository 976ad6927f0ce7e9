#include "app/session/findings/spindle_watch.h"

namespace proveout {

const PathEvent* SpindleWatch::before(MotionId id) {
  for (; next_ < path_.events.size() && path_.events[next_].before <= id; ++next_) {
    const PathEvent& event = path_.events[next_].event;
    const auto* spindle = event.as<event::Spindle>();
    if (spindle == nullptr) continue;
    Last& last = last_[event.channel];
    if (last.direction == spindle->direction) continue;  // another speed
    last = {spindle->direction, &event};
  }
  return last_[path_.motions[id].channel].event;
}

bool letsTurn(const event::Spindle& spindle) {
  return spindle.direction == "cw" || spindle.direction == "ccw";
}

}  // namespace proveout
