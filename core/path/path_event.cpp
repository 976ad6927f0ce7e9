#include "core/path/path_event.h"

#include <array>

namespace proveout {

std::string_view eventName(const EventKind& event) {
  constexpr std::array<std::string_view, std::variant_size_v<EventKind>> kNames = {
      "tool",      "spindle", "coolant",       "stop",           "optional_stop", "dwell", "end",
      "message",   "wire",    "overtravel",    "forbidden_zone", "wait",          "probe", "thread",
      "smoothing", "output",  "virtual_plane", "tool_shape",     "function"};
  return kNames[event.index()];
}

}  // namespace proveout
