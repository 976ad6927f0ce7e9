// Cutter compensation of nct as a stage of the motion pipe.
#pragma once

#include <string>

#include "core/nc/iso/model/alarm_reporter.h"
#include "core/nc/iso/parameters/parameters.h"
#include "core/nc/iso/stages/stage_recovery.h"
#include "core/nc/stages/compensation_stage.h"

namespace proveout::nc {

/// Says what is wrong, and slows feeds at arcs inside. With a tip code (manual 15.1) the path is told of that
/// point of the tool, with 0 and 9 of the centre of its nose.
class CompStage final : public CompensationStage {
 public:
  CompStage(MotionPipe& pipe, const IsoParameters& parameters, AlarmReporter& alarms, StageRecovery& recovery)
      : CompensationStage(pipe), parameters_(parameters), alarms_(alarms), recovery_(recovery) {}

  /// Compensation begins with the next item; the last one ended at `start`, (u, v, w).
  /// `maker`: changes the rules, may be null.
  void engage(const Vec3& start, void (*maker)(const IsoParameters&, CutterCompPolicy&));

 private:
  void note(const CompNote& told) override;
  void failed(const CompStatus& status) override;
  bool send(const CompPiece& piece, const PathItem& item, PathItem& out) override;
  bool toTip(const CompPiece& piece, const PathItem& item, PathItem& out);
  void report(Severity severity, const DiagnosticName& code, const std::string& message, std::uint64_t tag);

  const IsoParameters& parameters_;
  AlarmReporter& alarms_;
  StageRecovery& recovery_;
  Vec2 tip_ = Vec2::Zero();  ///< (u, v), from the nose centre to the point that the last piece was told of
};

}  // namespace proveout::nc
