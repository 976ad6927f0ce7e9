// The kinds of bodies that there are: the one list to add to. Each is told in its header; what each must
// answer in body_defaults.h.
#pragma once

#include <variant>

#include "removal/sweep/kinds/curve_bodies.h"
#include "removal/sweep/kinds/lean_arc_body.h"
#include "removal/sweep/kinds/lean_line_body.h"
#include "removal/sweep/kinds/level_arc_body.h"
#include "removal/sweep/kinds/line_body.h"
#include "removal/sweep/kinds/pose_run_body.h"
#include "removal/sweep/kinds/posed_body.h"

namespace proveout {

/// A kind of body with its way.
using BodyKind = std::variant<LineBody, ChordBody, LevelArcBody, TurnBody, UprightBody, WayBody, LeanLineBody,
                              LeanChordBody, LeanArcBody, PosedBody, PoseRunBody>;

}  // namespace proveout
