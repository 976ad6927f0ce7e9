// Errors of the contour stages as alarms of the channel.
#pragma once

#include "core/nc/contour_stage.h"
#include "core/nc/nct/motion/stage_recovery.h"
#include "core/nc/nct/program/alarms.h"

namespace proveout::nc {

/// Errors of the contour stages become alarms.
class ContourAlarms final : public ContourReport {
 public:
  ContourAlarms(AlarmReporter& alarms, StageRecovery& recovery) : alarms_(alarms), recovery_(recovery) {}
  bool contourError(const char* code, const char* message, const PathItem& at) override {
    alarms_.sendLate(Severity::kError, code, message, at.source, at.record);
    recovery_.recover();
    return false;
  }

 private:
  AlarmReporter& alarms_;
  StageRecovery& recovery_;
};

}  // namespace proveout::nc
