// The deepest point of a patch between its samples.
#pragma once

#include "removal/compare/deviation_patches.h"

namespace proveout {

/// The machined mesh where nothing more exact is known.
class MeshPart final : public ExactPart {
 public:
  /// `accuracy_mm`: how far the mesh may lie off the true surface.
  MeshPart(const SignedDistance& surface, double accuracy_mm) : surface_(surface), accuracy_(accuracy_mm) {}
  Sample at(const Vec3& p, double reach) const override;
  double accuracy() const override { return accuracy_; }

 private:
  const SignedDistance& surface_;
  double accuracy_;
};

/// Walks over the surface of the part from the deepest sample to where it is deepest (a search by ever
/// smaller steps, from `step_mm` on), or measures the distance of a sample of the nominal anew. Fills where,
/// depth, bound, normal and, where the part knows it, the maker.
void findDeepest(const ExactPart& part, const NominalModel& nominal, double step_mm, FoundPatch& found);

}  // namespace proveout
