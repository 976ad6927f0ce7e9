// Cutter compensation that looks ahead over one motion: arcs about outside corners, inside corners cut where
// both offset paths meet, corners that turn by little left as they are. In plane coordinates (u, v, w), mm.
//
// The way in is a motion of its own: it ends beside its programmed end, square to its direction. Motions
// behind the last one in the plane that only lift or turn, and functions, wait with it.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/types.h"

namespace proveout {

enum class ArcCornerFault : std::uint8_t {
  kNone,
  kEntryTooShort,  ///< the way in is not longer than the radius
  kArcTooSmall,    ///< an inside arc with no larger radius than the tool's
  kLineGouges,     ///< a line in an inside corner is shorter than the tool needs
  kArcGouges,      ///< an arc likewise
  kNoMeeting,      ///< the offset paths of an inside corner do not meet
  kNotFinite
};

struct ArcCornerMove {
  bool arc = false;
  Vec3 to = Vec3::Zero();      ///< programmed end
  Vec2 center = Vec2::Zero();  ///< of arcs
  double sweep = 0.0;          ///< of arcs, > 0 counter-clockwise
  double offset = 0.0;         ///< > 0 left of the path, < 0 right
  std::uint64_t tag = 0;       ///< the caller's
};

struct ArcCornerPiece {
  enum class Kind : std::uint8_t { kOwn, kCorner, kFollower };
  Kind kind = Kind::kOwn;  ///< kFollower: the caller's function or motion beside the plane; only `to` counts
  bool arc = false;
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
  Vec2 center = Vec2::Zero();
  double sweep = 0.0;
  std::uint64_t tag = 0;
};

/// Appends pieces in order to `out`. After a fault only reset() makes sense.
class ArcCornerComp {
 public:
  /// Compensation begins; the tool stands at `start`.
  void reset(const Vec3& start);
  ArcCornerFault push(const ArcCornerMove& move, std::vector<ArcCornerPiece>& out);
  /// Something that waits behind the last motion. `w`: height behind it.
  void follow(std::uint64_t tag, double w, std::vector<ArcCornerPiece>& out);
  /// Compensation ends, or nothing may wait.
  ArcCornerFault flush(std::vector<ArcCornerPiece>& out);

  const Vec3& center() const { return center_; }  ///< end of what was pushed, beside the programmed one
  bool first() const { return first_; }           ///< nothing has moved in the plane yet

 private:
  struct Held {
    bool any = false;
    ArcCornerPiece piece;
    Vec2 direction = Vec2::UnitX();  ///< of lines, as programmed
    double full_sweep = 0.0;         ///< of arcs: as long as the motion may be
    std::vector<ArcCornerPiece> followers;
  };
  ArcCornerFault enter(const ArcCornerMove& move);
  ArcCornerFault corner(const Vec2& tangent, const ArcCornerPiece& next, double offset,
                        std::vector<ArcCornerPiece>& out);
  ArcCornerFault moveEnd(const Vec2& to, std::vector<ArcCornerPiece>& out);
  bool meeting(const ArcCornerPiece& next, const Vec2& direction, double offset, Vec2& at) const;
  void release(std::vector<ArcCornerPiece>& out);
  void hold(const ArcCornerPiece& piece, const Vec2& direction);

  bool first_ = true;
  Vec3 programmed_ = Vec3::Zero(), center_ = Vec3::Zero();
  Held held_;
};

}  // namespace proveout
