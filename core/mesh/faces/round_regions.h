// Round faces in a mesh: facets that stand for one cylinder, cone, sphere or torus.
#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/cad_faces.h"
#include "core/mesh/faces/flat_facets.h"

namespace proveout {

/// Facets of one face.
struct FacetRegion {
  CadFace face;
  std::vector<std::uint32_t> facets;
  double residual_mm = 0.0;  ///< how far corners that should lie on the face are off it at most
  double chord_mm = 0.0;     ///< how far the facets' middles are off it at most
  std::size_t corners = 0;   ///< that it was fitted to
};

/// Looks for round faces among the facets that are not `taken`, and takes what it finds: from a few
/// neighbours on, as long as corners lie within `near_mm` of the face, which is fitted anew while it grows.
/// Of the kinds that fit, that with most facets holds, and of those about alike the simplest. The same mesh
/// has the same faces.
std::vector<FacetRegion> findRoundRegions(const FlatFacets& facets, double near_mm, std::vector<bool>& taken);

}  // namespace proveout
