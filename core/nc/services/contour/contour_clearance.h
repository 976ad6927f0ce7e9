// How near elements of a contour come to others.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/nc/services/contour/contour_corner.h"

namespace proveout {

/// Least distance between two elements, mm; 0 where they cross.
double distanceBetween(const ContourElement& a, const ContourElement& b);

/// The first of `path` that comes nearer than `least` (mm) to one of `contour`.
struct NearPass {
  std::size_t path = 0, contour = 0;
  double distance = 0.0;  ///< mm
};
std::optional<NearPass> firstNearPass(const std::vector<ContourElement>& path,
                                      const std::vector<ContourElement>& contour, double least);

}  // namespace proveout
