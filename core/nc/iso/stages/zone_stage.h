// Areas that the axes must not enter: stroke limits, zone 2 (G22, G23, parameters), zone 3 (manual chapter
// 22).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/nc/iso/model/alarm_reporter.h"
#include "core/nc/iso/parameters/parameters.h"
#include "core/nc/iso/stages/stage_recovery.h"
#include "core/nc/services/zone_check.h"
#include "core/nc/stages/motion_pipe.h"

namespace proveout::nc {

/// Watches machine coordinates; linked while there is an area. A motion into one goes up to its border, the
/// alarm follows. On a machine only a person could move the axes out: an area that gave its alarm is not
/// watched any more.
class ZoneStage final : public PathStage {
 public:
  /// What it knows of its channel.
  struct Channel {
    const ControlSettings& settings;
    const AxisTable& axes;
    const IsoParameters& parameters;
    const std::optional<Zone>& program_zone;  ///< of G22
    const CallStack& calls;
    PathEmitter& emitter;
    MotionPipe& pipe;
    AlarmReporter& alarms;
    StageRecovery& recovery;
  };
  explicit ZoneStage(const Channel& channel) : PathStage(StageSlot::kZones), c_(channel) {}
  bool push(PathItem& item) override;

  /// Takes over parameters and the limits of G22. False: they contradict themselves, reported.
  bool configure();
  /// Upper end of an axis in the areas that it must not leave, machine frame, mm; infinite without one.
  double ceiling(int axis) const;

 private:
  enum class Area { kStroke, kSecond, kThird };
  struct Watched {
    Area area;
    Zone zone;
    bool only_before =
        false;  ///< looked at before the motion only (limits of the job, which are told elsewhere)
  };
  struct Found {
    std::size_t watched = 0;
    ZoneHit hit;
    SharedAlarm alarm = SharedAlarm::kCount;
  };

  bool addStroke();
  bool addSecond();
  bool addThird();
  std::optional<Found> before(const ZonePath& path) const;
  std::optional<Found> during(const ZonePath& path) const;
  bool pushPolar(PathItem& item);
  bool pushCurve(PathItem& item, int chords, const std::function<AxisPoint(double)>& at);
  bool stop(PathItem& item, const Found& found, const ZonePath& path, bool moves);
  std::string axisName(const ZoneHit& hit) const;

  Channel c_;
  std::vector<Watched> watched_;
  bool check_before_ = false;  ///< N1001.CBM
};

/// An area without limits yet; with `outside` what lies outside of it is forbidden.
Zone endlessZone(bool outside);
/// Its limits along an axis.
void boundZone(Zone& zone, int axis, double low, double high);
/// Why the choice of stroke ranges cannot be: no such axis, no sign. Empty: it can.
std::string checkRangeB(const ControlSettings& settings, const AxisTable& axes);

}  // namespace proveout::nc
