// What a block plans for the areas that the axes must not enter.
#pragma once

#include "core/nc/services/zone_check.h"

namespace proveout::nc {

/// Limits of G22; nothing: G23.
struct ZoneChange {
  bool on = false;
  Zone zone;
};

}  // namespace proveout::nc
