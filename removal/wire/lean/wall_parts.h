// A wall between sections at two heights: which parts of it sections between them agree with.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

#include "removal/wire/lean/level_match.h"

namespace proveout {

/// Part of a wall: the points between which it goes at both heights.
struct WallPart {
  LoopSpan lower, upper;
};

/// A part that has to be halved, with its points half way up.
struct OpenPart {
  LoopSpan lower, middle, upper;
};

/// A rung at the end of an open part: a point of the section half way up is on it, for both sides.
struct SplitRung {
  std::uint32_t lower = 0, middle = 0, upper = 0;
};

/// A rung that is no straight line, or has points of its own because the wall beside it is twisted: the
/// parabola through its ends and a place half way up.
struct CurvedRung {
  std::uint32_t lower = 0, upper = 0;
  Vec2 middle = Vec2::Zero();  ///< mm
  std::uint32_t rows = 1;      ///< parts of equal height
  /// Its points lie half way between those of its neighbours: that halves what triangles leave a twisted wall
  /// by.
  bool between = false;
};

struct WallVerdict {
  std::vector<Ribbon> settled;  ///< whose triangles are true; loops are to be set
  std::vector<CurvedRung> curved;
  std::vector<OpenPart> open;
  std::vector<SplitRung> splits;
  bool failed = false;  ///< the sections have no place for the ends of a part, or it cannot be joined
};

/// A loop, and the points of it where edges with a name begin: told when it is first asked for. Not for
/// several threads.
class RunStarts {
 public:
  /// The loop must outlive it.
  explicit RunStarts(const LevelLoop& loop) : loop_(&loop) {}

  const LevelLoop& loop() const { return *loop_; }
  /// The nearest to a place; none: the name begins nowhere.
  std::optional<std::uint32_t> at(WallName name, const Vec2& p) const;

 private:
  const LevelLoop* loop_;
  mutable bool told_ = false;
  mutable std::unordered_map<WallName, std::vector<std::uint32_t>> of_;
};

/// One wall at two heights and half way up.
struct WallLoops {
  const LevelLoop& lower;
  const RunStarts& middle;
  const LevelLoop& upper;
  /// A quarter up, made when it is first asked for; null: there is none that belongs to the wall.
  std::function<const RunStarts*()> quarter;
};

/// Of a whole wall. Settled: its triangles leave the sections by no more than `tolerance` mm. With `parts` it
/// may have curved rungs, and what is true is parted from the rest where edges of one name begin at all
/// heights; without, or if nothing is true, the verdict is empty.
WallVerdict judgeWall(const WallLoops& wall, double tolerance, bool parts);
enum class PartWish {
  kTrue,    ///< settled if it is true
  kHalved,  ///< not settled
  kLast     ///< settled in any case: the heights are that near
};
/// Of a part.
WallVerdict judgePart(const WallLoops& wall, const WallPart& part, double tolerance, PartWish wish);

}  // namespace proveout
