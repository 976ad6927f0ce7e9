// What stands for what one convex part of a tool sweeps on a motion, its bodies and its exact field: the one
// place that knows what kinds there are and when each serves.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/path/toolpath.h"
#include "removal/sweep/column_way.h"
#include "removal/sweep/swept_body.h"
#include "removal/sweep/tool_frame.h"

namespace proveout {

/// What the bodies of tools that lean or turn know of one profile.
struct SolidParts {
  PoseSolid poses;
  /// A ball at the tip that lies in the solid: it goes the same way however the tool leans.
  struct Ball {
    ConvexProfile profile;
    ColumnSolid solid;   ///< of the ball
    ConvexProfile rest;  ///< the solid with a disc in place of its end
    PoseSolid rest_poses;
  };
  std::optional<Ball> ball;
};

/// What bodies know by place; all stays where it is.
struct BodyStore {
  std::deque<SweptField> fields;  ///< of motions of which there may be several pieces
  std::deque<CurveWay> ways;
  std::deque<LeanLine> lean_lines;
  std::deque<LeanArc> lean_arcs;
  std::deque<PosedPiece> posed_pieces;
  std::deque<PosePiece> pose_pieces;
  std::unordered_map<const ConvexProfile*, SolidParts> parts;
};

/// The field of a part on a whole motion. `profile` must outlive it.
SweptField motionField(const ConvexProfile& profile, const MotionWay& way);

/// Bounds of a part while its tip is in the box `tip`, on this motion, mm; `slack` mm wider.
Box3 partBounds(const ConvexProfile& profile, const MotionWay& way, const Box3& tip, double slack);

/// A convex part of a tool and what it is for.
struct PartUse {
  const ConvexProfile* profile;
  const ColumnSolid* solid;  ///< columnSolid(*profile); both must outlive the bodies
  bool cuts;                 ///< its chords must lie closer to their curve
  bool takes;  ///< cuts, and contact is no finding: pieces that are covered anyway may be left out
};

struct MotionBody {
  SweptBody body;
  /// Of a helix about z: how far on in the list the body over the same place one turn lower is; 0: there is
  /// none, or it does not cover all that this one does below its own top.
  std::int32_t lower = 0;
};

/// Makes the bodies of a path's motions.
class BodyMaker {
 public:
  /// `h`: spacing of the grid; `blank_top`: height of the blank, mm. `path` and `store` must outlive this.
  BodyMaker(const Toolpath& path, double h, double blank_top, BodyStore& store)
      : path_(path), h_(h), blank_top_(blank_top), store_(store) {}

  /// The bodies of a part on a motion, in their order on the way. The next call overwrites them.
  const std::vector<MotionBody>& make(MotionId id, const PartUse& part);

 private:
  void addLeaning(const MotionWay& way, const PartUse& part);
  void addLeanArc(const MotionWay& way, const ToolFrame& tool, const PartUse& part, const SweptField& curve);
  void addLeanChords(const MotionWay& way, const ToolFrame& tool, const PartUse& part,
                     const SweptField& curve);
  void addPosed(const MotionWay& way, const PartUse& part);
  void addBallChords(const PosedSweep& sweep, const SolidParts::Ball& ball);
  void addStretches(PosedSweep of, const PoseSolid& solid);
  const SolidParts& partsOf(const ConvexProfile& profile);
  bool isLevelArc(const ArcGeometry& arc, const ArcFrame& frame) const;
  bool addTurns(const Motion& m, const ArcFrame& frame, const PartUse& part, const SweptField& curve);
  void addTurnsAboutZ(const Motion& m, const PartUse& part, const SweptField& curve);
  bool addWay(MotionId id, const PartUse& part, const SweptField& curve);
  void addWayChords(const PartUse& part, const WaySweep& columns, const SweptField& curve);
  void addChords(const Motion& m, const ArcFrame& frame, const PartUse& part, const SweptField& curve);

  const Toolpath& path_;
  double h_, blank_top_;
  BodyStore& store_;
  MotionId way_of_ = kNoMotion;  ///< that the last of the ways belongs to
  std::vector<MotionBody> bodies_;
};

}  // namespace proveout
