// Something that happens between the motions of a path: one struct a kind. Who writes or shows events goes
// over their fields with forEachField; no text of a format is made here.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "core/path/source_ref.h"

namespace proveout {

namespace event {

/// Empty texts and values that are not set are not told.
struct ToolChange {
  int tool = 0;
  std::optional<int> row;  ///< of the tool management
};
struct Spindle {
  double rpm = 0.0;  ///< >= 0
  std::string
      direction;  ///< "cw", "ccw", "stop", "oriented", "position loop", "positioned", "synchronous", "axis"
  std::optional<int> spindle;                 ///< number, where there are several
  std::optional<double> angle_deg, turn_deg;  ///< where it stands, and how far it was turned to there
  std::optional<int> to;                      ///< the one that it follows
  std::optional<double> shift_pulses;         ///< of a synchronous one
  std::string axis;                           ///< that it became
  std::string code;                           ///< that the machine is sent
};
struct Coolant {
  std::string code;
  bool on = false;
};
struct Stop {
  std::string code;
  std::string reason;
};
struct OptionalStop {
  std::string code;
  bool active = false;
};
struct Dwell {
  double seconds = 0.0;
};
struct End {
  std::string code;
};
struct Message {
  std::string kind;  ///< "stop", "message", "box"
  int number = 0;
  std::string code;
  std::string text;
  std::optional<int> answer;  ///< to a box
};
/// The wire is cut off, or threaded where it stands.
struct Wire {
  std::string code;
  bool threaded = false;
};
/// An axis beyond its limits, machine frame; the motion follows.
struct Overtravel {
  std::string axis;
  double value = 0.0, limit = 0.0;  ///< mm or degrees
  std::optional<int> alarm;         ///< of the control
};
struct ForbiddenZone {
  int zone = 0;
  int alarm = 0;  ///< of the control
  std::string message;
};
/// A channel waits; without a code for the others to get on.
struct Wait {
  std::string code;
  std::string channels;
};
/// The end of a measuring move.
struct Probe {
  bool contact = false;
};
struct Thread {
  double lead = 0.0;       ///< mm/turn
  double angle_deg = 0.0;  ///< of the spindle at the start
};
struct Smoothing {
  int mode = 0;
  std::optional<std::string> axes;
  std::optional<double> tolerance, longest, shortest, angle, joined, least, any_angle_below;
};
/// A file that the program wrote.
struct Output {
  std::string file;
  std::uint64_t bytes = 0;
};
struct VirtualPlane {
  std::string code;
  bool on = false;
  std::string axes;
  std::optional<double> radius, offset;  ///< mm
};
/// The shape of the tool in the spindle, as its offset row tells.
struct ToolShape {
  int tool = 0;
  std::int64_t d = 0;                          ///< row
  double diameter = 0.0, corner_radius = 0.0;  ///< mm
};
/// Any other function that the machine is sent, or the change of the main spindle.
struct Function {
  std::string code;
  std::optional<int> main_spindle;
};

}  // namespace event

using EventKind =
    std::variant<event::ToolChange, event::Spindle, event::Coolant, event::Stop, event::OptionalStop,
                 event::Dwell, event::End, event::Message, event::Wire, event::Overtravel,
                 event::ForbiddenZone, event::Wait, event::Probe, event::Thread, event::Smoothing,
                 event::Output, event::VirtualPlane, event::ToolShape, event::Function>;

struct PathEvent {
  EventKind what;
  double time_s = 0.0;  ///< time that it takes (dwell, tool change, waiting)
  SourceRef source;
  std::uint8_t channel = 0;  ///< as Motion::channel

  /// The event as one kind; null: it is another.
  template <typename Kind>
  const Kind* as() const {
    return std::get_if<Kind>(&what);
  }
};

/// "tool", "spindle", "dwell", ...: the name of the kind in the path stream.
std::string_view eventName(const EventKind& event);

namespace event_detail {

template <typename Visit>
struct Fields {
  Visit visit;

  template <typename Value>
  void some(const char* key, const std::optional<Value>& value) {
    if (value) visit(key, *value);
  }
  void some(const char* key, const std::string& value) {
    if (!value.empty()) visit(key, value);
  }

  void operator()(const event::ToolChange& e) {
    visit("tool", e.tool);
    some("row", e.row);
  }
  void operator()(const event::Spindle& e) {
    visit("rpm", e.rpm);
    visit("direction", e.direction);
    some("spindle", e.spindle);
    some("angle", e.angle_deg);
    some("turn", e.turn_deg);
    some("to", e.to);
    some("shift_pulses", e.shift_pulses);
    some("axis", e.axis);
    some("code", e.code);
  }
  void operator()(const event::Coolant& e) {
    visit("code", e.code);
    visit("on", e.on);
  }
  void operator()(const event::Stop& e) {
    visit("code", e.code);
    some("reason", e.reason);
  }
  void operator()(const event::OptionalStop& e) {
    visit("code", e.code);
    visit("active", e.active);
  }
  void operator()(const event::Dwell& e) { visit("seconds", e.seconds); }
  void operator()(const event::End& e) { visit("code", e.code); }
  void operator()(const event::Message& e) {
    visit("kind", e.kind);
    visit("number", e.number);
    visit("code", e.code);
    visit("text", e.text);
    some("answer", e.answer);
  }
  void operator()(const event::Wire& e) {
    visit("code", e.code);
    visit("threaded", e.threaded);
  }
  void operator()(const event::Overtravel& e) {
    visit("axis", e.axis);
    visit("value", e.value);
    visit("limit", e.limit);
    some("alarm", e.alarm);
  }
  void operator()(const event::ForbiddenZone& e) {
    visit("zone", e.zone);
    visit("alarm", e.alarm);
    visit("message", e.message);
  }
  void operator()(const event::Wait& e) {
    some("code", e.code);
    some("channels", e.channels);
  }
  void operator()(const event::Probe& e) { visit("contact", e.contact); }
  void operator()(const event::Thread& e) {
    visit("lead", e.lead);
    visit("angle", e.angle_deg);
  }
  void operator()(const event::Smoothing& e) {
    visit("mode", e.mode);
    some("axes", e.axes);
    some("tolerance", e.tolerance);
    some("longest", e.longest);
    some("shortest", e.shortest);
    some("angle", e.angle);
    some("joined", e.joined);
    some("least", e.least);
    some("any_angle_below", e.any_angle_below);
  }
  void operator()(const event::Output& e) {
    visit("file", e.file);
    visit("bytes", e.bytes);
  }
  void operator()(const event::VirtualPlane& e) {
    visit("code", e.code);
    visit("on", e.on);
    visit("axes", e.axes);
    some("radius", e.radius);
    some("offset", e.offset);
  }
  void operator()(const event::ToolShape& e) {
    visit("tool", e.tool);
    visit("d", e.d);
    visit("diameter", e.diameter);
    visit("corner_radius", e.corner_radius);
  }
  void operator()(const event::Function& e) {
    some("code", e.code);
    some("main_spindle", e.main_spindle);
  }
};

}  // namespace event_detail

/// Calls visit(key, value) for each field that is told, in a fixed order. Values: bool, int, std::int64_t,
/// std::uint64_t, double, std::string.
template <typename Visit>
void forEachField(const EventKind& event, Visit visit) {
  std::visit(event_detail::Fields<Visit>{std::move(visit)}, event);
}

}  // namespace proveout
