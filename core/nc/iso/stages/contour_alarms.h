// Errors of the contour stages as alarms of the channel.
#pragma once

#include <string_view>

#include "core/nc/iso/model/alarm_reporter.h"
#include "core/nc/iso/stages/stage_recovery.h"
#include "core/nc/stages/contour_stage.h"

namespace proveout::nc {

/// Errors of the contour stages become alarms.
class ContourAlarms final : public ContourReport {
 public:
  ContourAlarms(AlarmReporter& alarms, StageRecovery& recovery) : alarms_(alarms), recovery_(recovery) {}
  bool contourError(SharedAlarm alarm, std::string_view subject, std::string_view detail,
                    const PathItem& at) override {
    alarms_.sendLate(Severity::kError, alarm, alarms_.table().message(alarm, subject, detail), at.source,
                     at.record);
    recovery_.recover();
    return false;
  }

 private:
  AlarmReporter& alarms_;
  StageRecovery& recovery_;
};

}  // namespace proveout::nc
