// What M codes of the machine builder do to the axes: coupled, parked, exchanged and reversed ones, a head
// that is turned (manual of the nct control, 20.2 to 20.5); axes of two drives (20.6, 20.7). Plain data.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/types.h"

namespace proveout {

struct ControlSettings;

/// Two axes by name; of coupled ones the first is the master.
struct AxisPair {
  std::string first, second;
};

/// How the head of the machine stands.
enum class HeadPosition { kVertical, kHorizontal };

/// What events switch on, and release.
enum class AxisMode { kCouple, kPark, kExchange, kReverse, kHead };

/// What one M code does. It releases first.
struct MachineEvent {
  int code = 0;                       ///< M number, 1 to 99999999
  std::vector<AxisMode> release;      ///< these end, whichever event has switched them on
  std::vector<AxisPair> couple;       ///< master, slave: the slave makes the master's increments (20.2)
  std::vector<std::string> opposite;  ///< slaves of `couple` that go the other way (N2102 MSY)
  std::vector<std::string> park;      ///< computed, but not moved (20.2)
  std::optional<AxisPair> exchange;   ///< each moves by the other one's words (20.3)
  std::vector<std::string> reverse;   ///< programmed motions go the other way (20.4, N2105 MMI)
  std::optional<HeadPosition> head;   ///< 20.5; horizontal: Y and Z exchanged, X reversed, tool along Y
  std::optional<Vec3> gauge;          ///< of the horizontal head, as that of the spindle, mm
};

/// Something in the events or pairs of drives that cannot be.
struct EventFault {
  enum class Where { kEvent, kGantry, kTandem } where = Where::kEvent;
  std::size_t index = 0;  ///< of the event or the pair
  std::string key;        ///< "couple", "code": what is wrong
  std::string text;       ///< with what to do
};

/// All faults of `events`, `gantry` and `tandem` against each other and the axes of the settings.
std::vector<EventFault> eventFaults(const ControlSettings& settings);

/// "couple", as a job names it.
std::string_view axisModeName(AxisMode mode);

}  // namespace proveout
