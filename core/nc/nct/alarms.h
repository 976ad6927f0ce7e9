// The alarms of the nct control: the manual's numbers and texts.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/nc/text/alarms.h"

namespace proveout::nc {

/// An alarm of the control. `text` is the manual's, in English; `{}` is the subject (an address, an axis).
struct Alarm {
  int number;
  std::string_view text;
};
/// Sorted by number.
std::span<const Alarm> nctAlarmTexts();
/// What a block of the control can be refused for.
const AlarmTable& nctAlarms();
/// The text of an alarm with its subject filled in; without a subject the mark and the blank before it go.
/// Numbers that the table lacks give "alarm of the program".
std::string alarmText(int number, std::string_view subject);

}  // namespace proveout::nc
