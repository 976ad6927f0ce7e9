// Ways straight up and down in what a tool has cut itself: out of a pocket, in and out of a hole.
#pragma once

#include "core/path/toolpath.h"
#include "removal/cut/cut_record.h"

namespace proveout {

/// Follows a path, motion by motion.
class OwnTrack {
 public:
  /// Whether all that `part` of `tool` sweeps on the next motion has been cut by the motions up to it, below
  /// the height `top`, mm. Never told of what is not so; of ways that are not upright, of tools that lean,
  /// and of those that cut under what they leave, always false.
  bool holds(const MotionWay& next, const ToolParts& tool, const ToolParts::Part& part, double top) const;
  void add(const MotionWay& way);

 private:
  bool isHere(const Vec3& p) const;
  int tool_ = -1;
  Vec2 at_ = Vec2::Zero();
  double low_ = 0.0;  ///< of the tip, mm
};

}  // namespace proveout
