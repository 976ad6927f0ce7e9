// The moves of a template's roughing and contour blocks (digest flexnc, 7 and 8).
#pragma once

#include "core/nc/flexnc/cycles/cycle_call.h"
#include "core/nc/flexnc/template/template_profile.h"

namespace proveout::nc {

/// Passes of depth P parallel to Z from the end diameter to the start diameter, zone by zone, then once along
/// the profile. `answer`: alarm, warnings and moves are added.
void roughTemplate(const CycleCall& call, const TemplateInput& input, const TemplateProfile& profile,
                   CycleAnswer& answer);
/// Once along the profile, from a start point of its own (K=1), from where an approach led to, or, going on
/// with a chain (K=0), by the profile's increments. `goes_on`: K=0.
void cutTemplateContour(const CycleCall& call, const TemplateInput& input, const TemplateProfile& profile,
                        bool goes_on, CycleAnswer& answer);

}  // namespace proveout::nc
