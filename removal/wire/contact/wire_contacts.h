// Rapid motions of a wire through what is held, places where it cannot be threaded, and what each motion
// takes.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "removal/grid/stock.h"
#include "removal/wire/falls/wire_falls.h"
#include "removal/wire/falls/wire_holding.h"
#include "removal/wire/falls/wire_work.h"
#include "removal/wire/section/prism_blank.h"

namespace proveout {

/// A contact for each rapid that meets what is held then. Touches thinner than 0.001 mm are left out.
std::vector<Contact> rapidContacts(const PrismBlank& blank, const WireWork& work, const WireHolding& holding,
                                   Progress& progress);

/// A place where the wire is threaded.
struct ThreadingPlace {
  Vec2 at = Vec2::Zero();
  double wire_mm = 0.0;     ///< diameter of the wire
  std::uint32_t after = 0;  ///< stretches of `cuts` that come before it
  MotionId next = kNoMotion;
};
/// Those where the wire, without its sparks, touches what is held then.
std::vector<ThreadingFault> threadingFaults(const PrismBlank& blank, const WireWork& work,
                                            const std::vector<ThreadingPlace>& places,
                                            const WireHolding& holding, Progress& progress);

/// What each stretch of `cuts` takes of the blank that none before it took, mm2: from stations along it and
/// across, good to some percent where walls are passed. Nothing is taken of pieces that had fallen.
std::vector<double> removedAreas(const PrismBlank& blank, const std::vector<WireStretch>& cuts,
                                 const std::vector<FreePiece>& fallen);

}  // namespace proveout
