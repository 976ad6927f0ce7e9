#include "core/nc/linuxcnc/alarms.h"

namespace proveout::nc {

const AlarmTable& linuxCncAlarms() {
  static const AlarmTable kTable{
      "linuxcnc",
      {
          {SharedAlarm::kNotImplemented, 0, "unknown-code", "Unknown code used: {}"},
          {SharedAlarm::kDuplicateWord, 0, "duplicate-word", "Multiple {} words on one line"},
          {SharedAlarm::kDivision, 0, "divide-by-zero", "Attempt to divide by zero"},
          {SharedAlarm::kRoot, 0, "negative-root", "Negative argument to sqrt"},
          {SharedAlarm::kLogarithm, 0, "logarithm", "Zero or negative argument to ln"},
          {SharedAlarm::kArcFunction, 0, "arc-function", "Argument to acos or asin out of range"},
      }};
  return kTable;
}

}  // namespace proveout::nc
