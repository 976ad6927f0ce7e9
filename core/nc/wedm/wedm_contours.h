// The two contours of a chain of motions, offset and paired.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/nc/wedm/wedm_chain.h"

namespace proveout::nc {

/// Where both points of the wire go because of one record. The row behind the way holds spikes, corners and
/// roundings.
struct WedmTracks {
  ContourElement main, second;
  std::vector<ContourElement> main_behind, second_behind;
  std::size_t spikes = 0;  ///< so many of those behind are the way out and back
  bool slanted = false;    ///< start-up, cancel or change of side
};

struct WedmFailure {
  std::size_t record = 0;
  std::string code, message;
};

struct WedmContours {
  std::vector<WedmTracks> tracks;  ///< of the records in front of the failure
  std::vector<std::size_t> tilts;  ///< records at whose end the wire tilts on the spot
  std::optional<WedmFailure> failure;
};

WedmContours wedmContours(const std::vector<WedmRecord>& records, const WedmParameters& parameters);

}  // namespace proveout::nc
