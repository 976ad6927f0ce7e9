// Offsets the contour of a wire to one side: start-up, corners, cancel, and the places where it cannot be
// done. Rules: wire EDM manual 5.5.2, 5.5.3, 5.5.5, 5.6 (digest wedm, D6 and D9).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/nc/services/contour/contour_corner.h"

namespace proveout {

/// How the wire goes round an outer corner. All ways leave the same part.
enum class OuterJoin {
  kArc,     ///< about the corner
  kMiter,   ///< straight, to the intersection; past a right angle cut off at one offset from the ends
  kTangent  ///< three straight segments, the middle one tangent to the arc
};

/// An element of the contour and how the wire runs along it. Lengths mm, offsets signed: above 0 to the left
/// of the way.
struct OffsetPiece {
  ContourElement element;
  double offset = 0.0;
  bool starts = false;  ///< the start-up block: from the contour to where the offset of the next one begins
  OuterJoin outer = OuterJoin::kArc;
  double extension = 0.0;  ///< lines: past the end and straight back, >= 0
  double overcut = 0.0;    ///< corner overcut, >= 0: into inner corners, past the ends at outer ones
};

/// What became of a piece.
struct OffsetTrack {
  ContourElement track;
  bool slanted = false;               ///< start-up, cancel, change of side: not parallel to the contour
  std::vector<ContourElement> spike;  ///< out and back behind the end
  std::vector<ContourElement> join;   ///< on to the start of the next track
};

struct OffsetFailure {
  enum class Kind {
    kArcStart,        ///< start-up on an arc
    kArcCancel,       ///< cancel on an arc
    kArcChange,       ///< change of side on an arc
    kRadius,          ///< the offset is larger than the radius of an inner arc
    kNoIntersection,  ///< the offset elements of an inner corner do not meet
    kReversed,        ///< nothing of the element is left
    kTooNear          ///< the wire would cut another element of the contour
  } kind = Kind::kArcStart;
  std::size_t piece = 0;      ///< that cannot be run
  Vec2 where = Vec2::Zero();  ///< mm
};

struct OffsetContour {
  std::vector<OffsetTrack> tracks;  ///< of the pieces in front of the failure, or of all
  std::optional<OffsetFailure> failure;
};

/// `tangent_mm`: ends of offset elements that are nearer than this are joined, > 0.
OffsetContour offsetContour(const std::vector<OffsetPiece>& pieces, double tangent_mm);

}  // namespace proveout
