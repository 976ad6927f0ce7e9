// From the names of a program to the axes that move by them, as a stage of the motion pipe (manual 20.2 to
// 20.7).
#pragma once

#include <optional>

#include "core/nc/control/control_settings.h"
#include "core/nc/stages/motion_pipe.h"

namespace proveout::nc {

/// Linked while the map is not plain. Feeds are speeds along the programmed way: slaves do not count, parked
/// axes do. An arc stays one where the axes that move tool or part go along one; else it goes along chords
/// within kCurveChordMm.
class AxisStage final : public PathStage {
 public:
  /// `map` is the one in force when an item comes.
  AxisStage(const AxisMap& map, const PathEmitter& emitter, const AxisTable& axes,
            const ControlSettings& settings);

  bool push(PathItem& item) override;
  void clear() override { last_.reset(); }

 private:
  bool keepsArc(const PathItem& item) const;
  void putOnAxes(PathItem& item) const;
  bool pushLine(PathItem& item, const AxisPoint& from, const AxisPoint& to);
  bool pushChords(const PathItem& item, const AxisPoint& from, const AxisPoint& to);
  double programmedLength(const AxisPoint& from, const AxisPoint& to) const;

  const AxisMap& map_;
  const PathEmitter& emitter_;
  const AxisTable& axes_;
  AxisSet idle_;                   ///< axes that carry neither tool nor part
  std::optional<AxisPoint> last_;  ///< end of the last item, by name; none: where the axes stand
};

}  // namespace proveout::nc
