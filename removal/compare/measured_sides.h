// Both surfaces of a comparison as points with their deviations.
#pragma once

#include <vector>

#include "core/mesh/signed_distance.h"
#include "removal/compare/comparison.h"
#include "removal/compare/sample_mesh.h"
#include "removal/compare/shape/nominal_shape.h"

namespace proveout {

/// A sampled surface with its deviations, in the convention of compare.h.
struct SampledSide {
  const SampleMesh* mesh = nullptr;
  std::vector<float> deviation;           ///< per sample point, mm; NaN where it is left out
  std::vector<float> bound;               ///< how far that may be off, mm
  std::vector<Eigen::Vector3f> gradient;  ///< per sample point, unit: outward at the other surface
  std::vector<std::uint32_t>
      opposite;  ///< per sample point: nearest triangle of the other side's mesh that was asked
};

struct NominalModel;

struct BothSides {
  SampledSide machined;                                ///< `opposite` counts the nominal's triangles
  SampledSide nominal;                                 ///< `opposite` counts triangles of machined.mesh
  const std::vector<std::uint32_t>* motion = nullptr;  ///< per triangle of the machined source; may be empty
  const NominalModel* model = nullptr;                 ///< null: the nominal's facets are taken as they are
  double reach_mm = 0.0;  ///< how far off facets of curved faces make a place unsure, mm
};

/// The nominal as it is asked.
struct NominalModel {
  /// `faces`: of the CAD model; null: none is known, curved faces are read from the mesh.
  NominalModel(const TriMesh& mesh, double sure_mm, const CadFaces* faces = nullptr)
      : surface(toSurface(mesh)),
        shape(faces != nullptr ? NominalShape(surface, distance, *faces) : NominalShape(surface, distance)),
        distance(surface, sure_mm) {}
  NominalModel(const NominalModel&) = delete;
  SurfaceMesh surface;
  NominalShape shape;  ///< first: it takes most memory while it is made
  SignedDistance distance;

  /// Deviation of a point of the part, mm; `d`: what distance.at(p) says.
  double deviation(const SurfaceDistance& d, const Vec3& p) const;
};

/// Measures both sides. Points of the machined surface that decide something are put onto the exact part
/// where the options have one: `part` is changed. Empty sides where `progress` was cancelled.
BothSides measureSides(SampleMesh& part, const SampleMesh& goal, const NominalModel& nominal,
                       const CompareOptions& options, Progress& progress);

}  // namespace proveout
