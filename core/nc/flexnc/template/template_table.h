// The templates of the FlexNC control: which letters each has, and of what its profile is made (digest
// flexnc, 5 and 6).
#pragma once

#include <span>

#include "core/nc/flexnc/cycles/cycle_call.h"
#include "core/nc/text/block.h"

namespace proveout::nc {

/// What a profile is made of, from its start (small diameter of a shaft, large one of a hole) on.
enum class TemplateShape {
  kPartArc,  ///< one arc between two points
  kQuarter,  ///< a quarter of a circle
  kTwoArcs,  ///< a convex arc and a concave one, tangent to each other
  kCone      ///< a cone, with arcs tangent to it before and behind
};
/// The arc before the cone.
enum class TemplateHead {
  kNone,
  kNose,  ///< convex, tangent to the plane of the start
  kRoot   ///< concave, tangent to the cylinder before the start
};
/// The arc behind the cone.
enum class TemplateTail {
  kNone,
  kCrest,    ///< convex, tangent to the cylinder behind the end
  kShoulder  ///< concave, tangent to the plane of the end
};
/// Which diameters a cone template is given.
enum class TemplateGiven {
  kEnd,        ///< X, of the end
  kStart,      ///< A, of the start
  kLineStart,  ///< A, where the line of the cone meets the plane of the start
  kLineEnd,    ///< X, where the line of the cone meets the plane of the end
  kBoth        ///< X and A, and Y or G but not both
};

struct TemplateRow {
  CycleCode code;
  TemplateShape shape;
  AddressSet shape_letters;  ///< all of them have to be there; besides Z
  AddressSet zero_letters;   ///< of those, the ones that a shaft may have 0
  bool convex_down = false;  ///< kPartArc, kQuarter: convex with ArcView::kXDown, else with kXUp
  TemplateHead head = TemplateHead::kNone;
  TemplateTail tail = TemplateTail::kNone;
  TemplateGiven given = TemplateGiven::kEnd;
  bool z_to_end = false;    ///< Z counts to the end of the profile, not to its start
  bool shaft_only = false;  ///< there is no form for holes
};

std::span<const TemplateRow> templateRows();
/// Null of a code that is none of a template.
const TemplateRow* findTemplate(CycleCode code);

/// Letters of the roughing block: those of the shape, Z, P, C, B; V may be left out.
AddressSet roughingLetters(const TemplateRow& row);
/// Letters of the contour block that have to be there: those of the shape, and Z where it is the length of
/// the profile itself, and C.
AddressSet contourLetters(const TemplateRow& row);

}  // namespace proveout::nc
