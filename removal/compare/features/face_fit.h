// A face of the CAD model as it was machined.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/mesh/cad_faces.h"
#include "removal/compare/exact_part.h"

namespace proveout {

/// Least-squares fit of the part's surface in place of a face, mm.
struct FaceFit {
  std::uint32_t face = 0;  ///< index in CadFaces
  std::size_t points = 0;  ///< of the part's surface that were taken; 0: none lies near enough
  std::size_t missed = 0;  ///< places of the face where the part has no such surface near enough
  double mean_mm = 0.0;    ///< of the distances off the face, > 0: material stands outside of it
  double least_mm = 0.0, most_mm = 0.0;
  double form_mm = 0.0;        ///< what the fit leaves: flatness of planes, roundness of rounds
  CadFace fitted;              ///< the face as it fits best; the model's own where `points` is 0
  bool placed = false;         ///< its place was fitted: the face goes far enough round to tell it
  bool tilted = false;         ///< so was its direction
  SurfaceMaker maker;          ///< of one of the points
  Vec3 middle = Vec3::Zero();  ///< of the points that were taken, on the model's face

  /// Less than half of the face is there: what is left of it says nothing of its size.
  bool gone() const { return missed > points; }
  /// Of the axis at the middle of the face, across it, or of the centre of sphere and torus; from the model.
  Vec3 shift(const CadFace& nominal) const;
};

}  // namespace proveout
