// Characteristics of a part as a whole, which need no nominal.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/geometry/types.h"
#include "removal/compare/comparison.h"
#include "removal/compare/exact_part.h"
#include "removal/compare/features/feature.h"

namespace proveout {

/// Whether a quantity is of the part as a whole: its least wall, its least inner radius, the blank's surface
/// that is left, crests between passes, roughness.
bool isOfPart(Quantity quantity);

/// `[[characteristic]]` of a job, of the part as a whole.
struct PartRule {
  Quantity quantity = Quantity::kThickness;
  std::string name;                     ///< for people; may be empty
  std::optional<IgnoredRegion> region;  ///< where it is looked for; none: everywhere
  std::optional<double> min, max;       ///< allowed values, at least one of them; units as Quantity says
};

/// A crest between passes that was measured.
struct CrestSample {
  Vec3 where = Vec3::Zero();
  double height_mm = 0.0;
  double width_mm = 0.0;  ///< from valley to valley
};

/// One of them, as the machined part has it. Units as Quantity says.
struct PartFeature {
  Quantity quantity = Quantity::kThickness;
  std::optional<double> measured;  ///< none: the part has nothing of the kind
  bool measurable = true;          ///< false: nothing but a mesh is known of the part, which is too little
  Vec3 where = Vec3::Zero();       ///< where it is met
  SurfaceMaker maker;              ///< of the surface there
  std::vector<CrestSample> crests = {};  ///< of scallop height and roughness: all that were measured
};

}  // namespace proveout
