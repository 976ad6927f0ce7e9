// Rapid motions of a wire through what is held, and what each motion takes.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "removal/grid/stock.h"
#include "removal/wire/wire_stock.h"
#include "removal/wire/wire_work.h"

namespace proveout {

/// The body that is still held when others have fallen: the largest that has some of the blank's own border;
/// without one the largest. Requires bodies.
std::size_t heldBody(const std::vector<PlaneBody>& bodies);

/// A contact for each rapid that meets the held body, as it is then. Touches thinner than 0.001 mm are left
/// out.
std::vector<Contact> rapidContacts(const PrismBlank& blank, const WireWork& work, Progress& progress);

/// What each stretch of `cuts` takes of the blank that none before it took, mm2: from stations along it and
/// across, good to some percent where walls are passed.
std::vector<double> removedAreas(const PrismBlank& blank, const std::vector<WireStretch>& cuts);

}  // namespace proveout
