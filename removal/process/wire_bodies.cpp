#include "removal/process/wire_bodies.h"

#include <limits>

namespace proveout {

std::size_t bodyLike(const std::vector<Box3>& bounds, const std::optional<Box3>& wanted) {
  if (!wanted) return 0;
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < bounds.size(); ++k) {
    const double off = (bounds[k].min - wanted->min).head<2>().cwiseAbs().sum() +
                       (bounds[k].max - wanted->max).head<2>().cwiseAbs().sum();
    if (off >= least) continue;
    least = off;
    best = k;
  }
  return best;
}

}  // namespace proveout
