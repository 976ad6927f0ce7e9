// Findings of a run held against those of a baseline.
#pragma once

#include <vector>

#include "io/report.h"

namespace proveout {

/// By how much a finding may go beyond what the baseline has, mm, beside a tenth of it.
struct KnownSlack {
  double gouge_mm = 0.02, excess_mm = 0.05;  ///< of deviations: the tolerances
  double other_mm = 0.01;
};

/// Marks what the baseline has as known, each of its entries once, and says of what would be but for its size
/// by what it is worse (Finding::worse). One finding is another's where kind, clamping, file and text of the
/// block are the same and the place is within 1 mm, or, of what has an area, within its extent; lines may
/// differ. One that stands for several blocks is met by its first or last one, at any place. It is worse
/// where depth (or else volume, or area) has grown beyond a tenth and the slack, area or volume to more than
/// half as much again, where more places are told as one, or its severity has risen. Binding kinds are never
/// known. Returns the entries that no finding stands for, those of worse ones not among them.
std::vector<KnownFinding> markKnown(const std::vector<KnownFinding>& baseline, const KnownSlack& slack,
                                    std::vector<Finding>& findings);

}  // namespace proveout
