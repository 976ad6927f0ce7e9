// Connected regions beyond tolerance, on both surfaces together.
#pragma once

#include <vector>

#include "removal/compare.h"
#include "removal/sample_mesh.h"

namespace proveout {

/// A sampled surface with its deviations, in the convention of compare.h.
struct SampledSide {
  const SampleMesh* mesh = nullptr;
  std::vector<float> deviation;           ///< per sample point, mm
  std::vector<Eigen::Vector3f> gradient;  ///< per sample point, unit: where the deviation grows
  std::vector<std::uint32_t>
      opposite;  ///< per sample point: nearest triangle of the other side's mesh that was asked
};

struct BothSides {
  SampledSide machined;                      ///< `opposite` counts the nominal's triangles; not used here
  SampledSide nominal;                       ///< `opposite` counts triangles of machined.mesh
  const std::vector<std::uint32_t>* motion;  ///< per triangle of the machined source; may be empty
};

/// Regions where the deviation of the kind exceeds `level_mm`, in a fixed order that depends on the input
/// alone.
std::vector<DeviationPatch> findPatches(const BothSides& sides, DeviationKind kind, double level_mm);

}  // namespace proveout
