// General tolerances of ISO 2768-1 (sizes, radii, angles) and ISO 2768-2 (form and perpendicularity).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "removal/compare/features/feature.h"

namespace proveout {

/// As a drawing's title block names it: "ISO 2768-mK".
struct GeneralTolerance {
  char size = '\0';  ///< 'f', 'm', 'c', 'v'; 0: none
  char form = '\0';  ///< 'H', 'K', 'L'; 0: none

  bool none() const { return size == '\0' && form == '\0'; }
  std::string text() const;  ///< "ISO 2768-mK"
  /// Largest deviation to either side, or of a zone its width, for a characteristic of that nominal value;
  /// mm, degrees. `length_mm`: of the feature, for angles and form. None: the standard gives no value.
  std::optional<double> limit(const Characteristic& c, double length_mm) const;
};

/// "m", "mK", "ISO 2768-mK"; the error lists the classes.
Result<GeneralTolerance> parseGeneralTolerance(std::string_view text);

}  // namespace proveout
