#include "removal/compare/features/found_features.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/mesh/faces/found_faces.h"

namespace proveout {

KnownFaces facesInFacets(const TriMesh& mesh) {
  /// Corners say how faces lie to each other to several times what each may be off.
  constexpr double kNear = 4.0, kLeastNear = 1e-3, kNearRad = 1e-3;
  FoundFaces found = findFaces(mesh);
  KnownFaces out;
  out.accuracy = {std::max(kLeastNear, kNear * found.near_mm), kNearRad};
  out.found = true;
  out.faces = std::make_shared<const CadFaces>(std::move(found.faces));
  return out;
}

ExactPart::Sample FacedPart::at(const Vec3& p, double reach) const {
  /// As far from its facets faces are asked, mm: what facets leave them by at most.
  constexpr double kMostChord = 0.25;
  const SurfaceDistance d = surface_.at(p);
  Sample out{std::clamp(d.distance, -reach, reach), d.gradient.cast<double>().normalized(), {}};
  const CadFace* face = faces_->exactAt(d.triangle);
  if (face == nullptr || std::abs(d.distance) > kMostChord) return out;
  const double off = face->distance(p);
  if (std::abs(off - d.distance) > kMostChord) return out;
  out.value = std::clamp(off, -reach, reach);
  out.normal = face->normalAt(p);
  return out;
}

}  // namespace proveout
