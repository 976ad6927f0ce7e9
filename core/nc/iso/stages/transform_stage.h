// From the programmed space to work space, as a stage of the motion pipe.
#pragma once

#include "core/nc/iso/model/alarm_reporter.h"
#include "core/nc/kinematics/program_transforms.h"
#include "core/nc/stages/motion_pipe.h"

namespace proveout::nc {

/// Takes what the program wrote through mirroring, scaling, rotation and the local shift. Under reflection
/// arcs turn the other way and cutter compensation changes its side; its radius stays.
class TransformStage final : public PathStage {
 public:
  /// `chain` and `map` are those in force when an item comes.
  /// `scales_centres`: see IsoRules.
  TransformStage(const CoordinateChain& chain, const ProgramMap& map, AlarmReporter& alarms,
                 bool scales_centres)
      : PathStage(StageSlot::kTransform),
        chain_(chain),
        map_(map),
        alarms_(alarms),
        scales_centres_(scales_centres) {}
  bool push(PathItem& item) override;

 private:
  void transform(PathItem& item) const;
  bool transformArc(PathItem& item);
  bool rebuildArc(PathItem& item, double radius, const Vec3& center);
  void scaleCentre(PathItem& item, const Vec3& center) const;

  const CoordinateChain& chain_;
  const ProgramMap& map_;
  AlarmReporter& alarms_;
  bool scales_centres_;
};

}  // namespace proveout::nc
