// Planes with a rotary axis that stands for a linear one, as a stage of the motion pipe: from the virtual
// point to the axes of the machine.
#pragma once

#include "core/nc/iso/model/axis_modal.h"
#include "core/nc/stages/motion_pipe.h"

namespace proveout::nc {

/// Linked while G12.1 or G7.1 is in force. In front of it the rotary axis counts in mm of the plane.
class VirtualStage final : public PathStage {
 public:
  /// `chain` and `frames` are those in force when an item comes.
  VirtualStage(MotionPipe& pipe, const CoordinateChain& chain, const WorkFrames& frames,
               const AxisTable& axes)
      : PathStage(StageSlot::kVirtual), pipe_(pipe), chain_(chain), frames_(frames), axes_(axes) {}

  /// The mode begins where the machine is: `position` in the chain, and `machine`.
  void begin(const AxisModal& modal, const AxisPoint& position, const AxisPoint& machine);
  void end();
  const PolarPlane& plane() const { return plane_; }
  /// Where the machine's own axes are.
  const AxisPoint& machine() const { return machine_; }
  /// A point of the machine with the rotary axis in mm of the plane, and in G12.1 the linear one in the
  /// plane.
  AxisPoint shown(const AxisPoint& machine) const;
  /// The machine stands there by other means; the point as shown() gives it.
  AxisPoint adopt(const AxisPoint& machine);

  bool push(PathItem& item) override;

 private:
  void place(const AxisPoint& work);
  bool pushPolar(PathItem& item);
  bool pushCylinder(PathItem& item);
  bool sendUnrolled(PathItem& item, double paced);

  MotionPipe& pipe_;
  const CoordinateChain& chain_;
  const WorkFrames& frames_;
  const AxisTable& axes_;
  AxisModal modal_;
  AxisPoint machine_;  ///< end of the last item
  PolarPlane plane_;
  double work_zero_ = 0.0, work_zero_deg_ = 0.0;  ///< the plane's origin in work coordinates
  AxisPoint last_;  ///< end of the last item, work coordinates, rotary axis in mm
};

}  // namespace proveout::nc
