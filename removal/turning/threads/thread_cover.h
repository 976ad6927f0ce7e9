// Passes of a thread that a deeper one leaves nothing of.
#pragma once

#include <vector>

#include "removal/turning/section/section.h"

namespace proveout {

/// Whether the groove of `shallow` lies in that of `deep` all along, between the radii `low` and `high` of
/// the material. True only for passes on the same helix along Z.
bool coversThread(const ThreadSweep& deep, const ThreadSweep& shallow, double low, double high);

/// `threads` in their order without those that another covers in the bodies' material; of equal ones the
/// first stays.
std::vector<ThreadSweep> withoutCovered(const std::vector<ThreadSweep>& threads,
                                        const std::vector<SectionBody>& bodies);

}  // namespace proveout
