// Profiles of templates that are arcs alone (digest flexnc, 6.1 and 6.2).
#pragma once

#include <optional>

#include "core/nc/flexnc/template/template_profile.h"

namespace proveout::nc {

/// An arc of a profile, at most half a turn. `convex`: material lies on the side of its center. `side`: +1
/// shaft, -1 hole.
ContourElement templateArc(const Vec2& center, const Vec2& from, const Vec2& to, bool convex, double side);

/// G3.1: between two points. G12, G13: a quarter. G8.1: convex and concave. Why there is none, or nothing.
std::optional<CycleNote> partArcProfile(const TemplateInput& in, PlaneContour& elements);
std::optional<CycleNote> quarterProfile(const TemplateInput& in, PlaneContour& elements);
std::optional<CycleNote> twoArcsProfile(const TemplateInput& in, PlaneContour& elements);

}  // namespace proveout::nc
