// Where the workpiece really lies, against where the operator's offsets say.
//
// A control tells its path in the machine frame moved to the zero that its offsets name (offsetZero). The
// workpiece lies where WorkpiecePlacement says. With both, a wrong offset moves the cuts.
#pragma once

#include <memory>
#include <vector>

#include "core/geometry/rigid_transform.h"
#include "core/nc/control/control_host.h"
#include "core/nc/control/control_settings.h"
#include "core/path/pose_sweep.h"
#include "core/path/toolpath.h"

namespace proveout {

/// From the machine frame into the workpiece frame.
RigidTransform machineIntoWorkpiece(const ControlSettings& settings);
/// From the frame of a control's path into the workpiece frame; exactly the identity where nothing is placed.
RigidTransform pathIntoWorkpiece(const ControlSettings& settings);

/// The same by channel; of a control without channels one, whose number is 0.
struct ChannelPlacement {
  int channel = 0;
  RigidTransform move;
};

/// A machine's chain that was moved last: many motions share one.
struct MovedChain {
  std::shared_ptr<const MachineChain> of;
  RigidTransform move;
  std::shared_ptr<const MachineChain> chain;
};

/// Passes a path on in the workpiece frame.
class PlacedSink : public MotionSink {
 public:
  /// `next` must outlive this. Motions of channels that are not listed go as those of the first.
  PlacedSink(MotionSink& next, std::vector<ChannelPlacement> placements);

  void file(std::uint32_t index, const std::string& name) override { next_.file(index, name); }
  void motion(const Motion& motion, const ArcGeometry* arc, const AxisSweep* axis) override;
  void wireMotion(const Motion& motion, const WireSweep& wire) override;
  void event(const PathEvent& event) override { next_.event(event); }
  void diagnostic(const Diagnostic& diagnostic) override { next_.diagnostic(diagnostic); }
  void originWord(const WordOrigin& word) override { next_.originWord(word); }
  void originData(const DataInForce& data) override { next_.originData(data); }
  void originModal(const ModalOrigins& modal) override { next_.originModal(modal); }
  void originSet(const OriginSet& set) override { next_.originSet(set); }

 private:
  MotionSink& next_;
  std::vector<ChannelPlacement> placements_;
  MovedChain chain_;
};

/// Asks a probe that answers in the workpiece frame.
class PlacedProbe : public Probe {
 public:
  /// `inner` must outlive this.
  PlacedProbe(Probe& inner, const RigidTransform& move) : inner_(inner), move_(move) {}
  Result<std::optional<double>> firstContact(const Motion& move, const ArcGeometry* arc,
                                             const AxisSweep* axis) override;

 private:
  Probe& inner_;
  RigidTransform move_;
};

}  // namespace proveout
