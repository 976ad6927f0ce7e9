// Features of meshes: faces are found in their facets.
#pragma once

#include <memory>

#include "core/mesh/cad_faces.h"
#include "core/mesh/signed_distance.h"
#include "removal/compare/exact_part.h"
#include "removal/compare/features/recognition.h"

namespace proveout {

/// The faces that features are recognised from.
struct KnownFaces {
  std::shared_ptr<const CadFaces> faces;  ///< null: none are known
  FaceAccuracy accuracy;
  bool found = false;  ///< in facets
};

/// Those that are found in the facets of a mesh.
KnownFaces facesInFacets(const TriMesh& mesh);

/// A part that is a mesh with faces found in its facets: where a facet stands for a face the part lies on the
/// face, and a hole that was measured at chords of it is as wide as it was meant. Elsewhere the mesh.
class FacedPart final : public ExactPart {
 public:
  /// `surface`: of the mesh that the faces are of; has to outlive this.
  FacedPart(const SignedDistance& surface, std::shared_ptr<const CadFaces> faces)
      : surface_(surface), faces_(std::move(faces)) {}
  Sample at(const Vec3& p, double reach) const override;
  double accuracy() const override { return 0.0; }

 private:
  const SignedDistance& surface_;
  std::shared_ptr<const CadFaces> faces_;
};

}  // namespace proveout
