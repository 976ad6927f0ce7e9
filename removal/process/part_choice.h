// Which of several bodies is the part: what a job, a nominal or a programmed parting says, else the larger
// one.
#pragma once

#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/geometry/types.h"

namespace proveout {

/// From this share of the part's volume on another body may be meant as well.
inline constexpr double kNotableShare = 0.01;

struct PartChoice {
  std::size_t body = 0;
  /// A body that may be the part as well: nothing says which of the two it is.
  std::optional<std::size_t> rival;
};

/// The largest body; its rival is the next one, where that is notable. Requires volumes.
PartChoice largestOf(const std::vector<double>& volumes_mm3);
/// The same for a body that is chosen by something else than its volume, but not for sure.
PartChoice doubted(std::size_t body, const std::vector<double>& volumes_mm3);

/// "the point of the part (part_point) X.. Y.. Z.. lies in no body that is left".
std::string pointInNoBody(const Vec3& p);

}  // namespace proveout
