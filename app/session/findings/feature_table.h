// The features of the nominal as the report tells them, and what is wrong with them as findings.
#pragma once

#include <string>
#include <vector>

#include "io/report.h"
#include "removal/compare/comparison.h"
#include "removal/compare/features/judgement.h"

namespace proveout {

/// The feature that a face of `nominal_faces` belongs to, for people; where none is recognised the face.
std::string featureAt(std::uint32_t face, const Comparison& comparison);

/// "mm", "deg", "mm2", "um".
std::string unitOf(Quantity quantity);

/// A row for each feature of the nominal with its characteristics and verdicts. Empty where none were
/// recognised.
std::vector<ReportFeature> featureTable(const Comparison& comparison, const FeatureTolerances& tolerances);

/// What made the surface that a finding of a characteristic is about.
struct CharacteristicFault {
  std::size_t finding = 0;  ///< index in the findings
  SurfaceMaker maker;
  Vec3 at = Vec3::Zero();
};

/// Adds a finding for each characteristic with a tolerance of the job or a general one that the part does not
/// keep, and for rules that fit no feature. What only the tolerances of the surface limit is told as gouge or
/// excess already.
std::vector<CharacteristicFault> addCharacteristics(const Comparison& comparison,
                                                    const FeatureTolerances& tolerances,
                                                    std::vector<Finding>& findings);

}  // namespace proveout
