// The machined surface against nominal CAD: where material is missing (gouge) or left over (excess).
//
// Deviation, mm: signed distance of a point of the machined surface to the nominal solid. Positive: material
// stands outside nominal (excess). Negative: the surface lies below nominal (gouge). Seen from the nominal
// side, a point of the nominal surface that lies inside the machined solid has a positive deviation, one
// outside it a negative one: the same convention. Both sides are measured, since a pocket that was never cut
// is seen well from its nominal floor only, and a gouge well from the machined surface only.
//
// Only the .cpp files behind this header see CGAL.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/tri_mesh.h"
#include "core/path/toolpath.h"

namespace proveout {

/// A mesh that bounds a solid: closed, outward, welded.
struct PreparedMesh {
  TriMesh mesh;
  std::vector<std::string> notes;  ///< what was repaired or looks wrong, one sentence each; for a warning
};

/// Makes a solid of a mesh as files bring it. Repairs what is safe: equal vertices are merged, and border
/// vertices within 0.1 micrometre + 1e-6 of the size of each other; collapsed and doubled triangles are
/// dropped; facets with mixed orientation are made consistent; shells that are inside out are turned.
/// Otherwise refuses with kInput: empty, not finite, an index out of range, a hole (names the place and how
/// many edges are open). `name` stands in front of messages ("bracket.stl").
Result<PreparedMesh> prepareNominal(const TriMesh& mesh, const std::string& name);

/// Part of space that is left out of a comparison: what lies in the box and between the radii about the Z
/// axis. A thread that the nominal shows as a plain cylinder is the usual reason.
struct IgnoredRegion {
  std::string name;
  Box3 box{Vec3::Constant(-std::numeric_limits<double>::infinity()),
           Vec3::Constant(std::numeric_limits<double>::infinity())};
  double inner_radius = 0.0, outer_radius = std::numeric_limits<double>::infinity();  ///< mm

  bool contains(const Vec3& p) const {
    const double r = std::hypot(p.x(), p.y());
    return (p.array() >= box.min.array()).all() && (p.array() <= box.max.array()).all() &&
           r >= inner_radius && r <= outer_radius;
  }
};

struct CompareOptions {
  double gouge_mm = 0.02;      ///< allowed below nominal, >= 0
  double excess_mm = 0.05;     ///< allowed above nominal, >= 0
  double resolution_mm = 0.2;  ///< spacing of samples on large triangles of either mesh, > 0
  /// Half-width of the error of the machined surface (about resolution^2 / (8 r) on a wall of radius r):
  /// deviations closer than this to a tolerance are reported as undecided. 0: the mesh is taken as exact.
  double uncertainty_mm = 0.0;
  int threads = 0;                     ///< 0: all cores; the result does not depend on it
  std::vector<IgnoredRegion> ignored = {};  ///< points in one of them count as without deviation
};

enum class DeviationKind : std::uint8_t { kGouge, kExcess };

/// A connected region of the surface beyond tolerance.
struct DeviationPatch {
  DeviationKind kind = DeviationKind::kGouge;
  Vec3 where = Vec3::Zero();  ///< deepest sampled point, mm
  double depth_mm = 0.0;      ///< there, from nominal (not from the tolerance), > 0
  double area_mm2 =
      0.0;  ///< of the machined surface beyond tolerance; of the nominal's where only that shows it
  double volume_mm3 =
      0.0;      ///< between machined and nominal under that area: depth times projected area, summed
  Box3 bounds;  ///< of the region, mm
  /// Made the deepest point; kNoMotion: the blank's own surface (excess only, unless no motion is near).
  MotionId motion = kNoMotion;
  MotionId main_motion = kNoMotion;  ///< made the largest part of the region's area
  double main_motion_share = 0.0;    ///< of the area, 0..1
  bool from_nominal_only = false;    ///< seen only by the samples of the nominal surface
  /// Undecided patches only: the grid spacing at which the error would be small enough to tell, mm; 0 where
  /// the deviation is too close to the tolerance for any practical grid.
  double deciding_resolution_mm = 0.0;
};

struct Comparison {
  double gouge_tolerance_mm = 0.0, excess_tolerance_mm = 0.0, uncertainty_mm = 0.0;
  std::vector<DeviationPatch> patches;    ///< beyond tolerance + uncertainty; deepest first
  std::vector<DeviationPatch> undecided;  ///< deepest within tolerance +- uncertainty; deepest first
  double max_gouge_mm = 0.0;              ///< deepest of both sides, >= 0
  double max_excess_mm = 0.0;             ///< highest of both sides, >= 0
  double rms_mm = 0.0;                    ///< over the machined surface, area-weighted
  double p95_mm = 0.0;  ///< 95 % of the machined surface deviates less, area-weighted, absolute value
  struct Histogram {
    std::vector<double> edges_mm;  ///< ascending; the outermost bins also hold everything beyond them
    std::vector<double> area_mm2;  ///< of the machined surface, one fewer than edges
  } histogram;
  std::vector<float> vertex_deviation;  ///< per vertex of the machined mesh, mm; NaN where it is ignored
  std::vector<double> ignored_mm2;      ///< of the machined surface, per region of CompareOptions::ignored
  /// Estimated distance of the nominal's facets from the curved surface that they stand for: the largest
  /// chord height between neighbouring facets that meet at less than 20 degrees. 0 for flat-faced parts.
  double nominal_tessellation_mm = 0.0;
  /// Of samples between the vertices of the machined mesh: 1.5 times the resolution, or more on huge meshes.
  double machined_spacing_mm = 0.0;
  double nominal_spacing_mm = 0.0;  ///< of samples on the nominal: the resolution, or more on huge meshes
  std::size_t machined_samples = 0, nominal_samples = 0;

  /// True where the surface is within tolerance and the grid could tell.
  bool pass() const { return patches.empty() && undecided.empty(); }
};

/// Compares two closed meshes. Both must be as prepareNominal leaves them (the mesh of a Stock is); what is
/// not closed or not finite is refused with kInput. kInterrupted where `progress` was cancelled. Points of
/// the machined mesh carry `motion` where it is filled.
Result<Comparison> compareToNominal(const TriMesh& machined, const TriMesh& nominal,
                                    const CompareOptions& options, Progress& progress);

}  // namespace proveout
