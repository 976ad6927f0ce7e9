// The contour of a leaning wire in its secondary plane: that of the main plane, shifted element by element by
// what the wire leans there. Rules: wire EDM manual 7 (digest wedm, D7).
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/nc/services/contour/contour_corner.h"

namespace proveout {

/// An element of the main contour without rounded corners. Lengths mm.
struct TaperPiece {
  ContourElement element;
  bool on = false;                ///< taper mode, maybe without lean
  double lean = 0.0;              ///< the secondary plane to the left of the way of the main one
  bool rounded = false;           ///< the corner behind it is rounded
  double round = 0.0;             ///< radius in the main plane, with `rounded`
  std::optional<double> round_2;  ///< radius in the secondary plane; none: an arc about the same centre
};

/// An element of the secondary contour.
struct TaperedElement {
  ContourElement element;
  std::size_t piece = 0;
  bool corner = false;      ///< stands between the piece and the next one
  bool transition = false;  ///< an arc about the corner of the main contour, which that contour lacks
};

struct TaperFailure {
  enum class Kind {
    kArcStart,        ///< taper begins on an arc
    kArcCancel,       ///< taper ends on an arc
    kProcessing,      ///< the change of lean cannot be made here
    kRadius,          ///< the lean is larger than the radius of an inner arc
    kNoIntersection,  ///< elements of an inner corner do not meet
    kReversed,        ///< nothing of the element is left
    kMiter,           ///< the point of an outer corner is too far away
    kRound            ///< a rounded corner does not fit
  } kind = Kind::kArcStart;
  std::size_t piece = 0;
};

struct TaperedContour {
  std::vector<TaperedElement> elements;
  std::vector<std::size_t> tilts_in_place;  ///< pieces at whose end the wire tilts without moving on
  std::optional<TaperFailure> failure;
};

struct TaperRules {
  double tangent_mm = 0.002;  ///< ends nearer than this are joined
  bool arc_corners = false;   ///< outer corners of two lines get an arc as well
};

TaperedContour taperContour(const std::vector<TaperPiece>& pieces, const TaperRules& rules);

}  // namespace proveout
