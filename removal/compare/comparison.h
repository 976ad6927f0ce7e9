// What a comparison with nominal CAD is asked and what it tells.
//
// Deviation, mm: signed distance of a point of the machined surface to the nominal solid. Positive: material
// stands outside nominal (excess). Negative: the surface lies below nominal (gouge). Seen from the nominal
// side, a point of the nominal surface that lies inside the machined solid has a positive deviation, one
// outside it a negative one: the same convention. Both sides are measured, since a pocket that was never cut
// is seen well from its nominal floor only, and a gouge well from the machined surface only.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/types.h"
#include "core/mesh/cad_faces.h"
#include "removal/compare/exact_part.h"
#include "removal/compare/features/face_fit.h"
#include "removal/compare/features/feature.h"

namespace proveout {

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

/// Tolerances that hold on a part of the surface in place of the general ones: on faces of a kind or a name,
/// in a region, or both together.
struct LocalTolerance {
  std::optional<SurfaceKind> kind;
  std::string face;  ///< name of a face of the CAD model; empty: any
  std::optional<IgnoredRegion> region;
  double gouge_mm = 0.0, excess_mm = 0.0;  ///< >= 0
};

struct CompareOptions {
  double gouge_mm = 0.02;                  ///< allowed below nominal, >= 0
  double excess_mm = 0.05;                 ///< allowed above nominal, >= 0
  std::vector<LocalTolerance> local = {};  ///< of several that fit the last one holds; fewer than 65,535
  double resolution_mm = 0.2;              ///< spacing of samples on large triangles of either mesh, > 0
  /// How far the machined mesh may lie off the machined surface, mm: about resolution^2 / (8 r) on a wall of
  /// radius r. 0: the mesh is taken as exact.
  double uncertainty_mm = 0.0;
  /// The machined part itself: places whose deviation could be beyond a tolerance are measured on it and not
  /// on the mesh. Null: the mesh is all there is, and deviations closer to a tolerance than `uncertainty_mm`
  /// are undecided.
  std::shared_ptr<const ExactPart> part = {};
  /// The faces of the CAD model that the nominal mesh was made of: samples are measured to them, and chords
  /// do not matter. Null: only the mesh is known.
  std::shared_ptr<const CadFaces> nominal_faces = {};
  /// Whether the features of the nominal are measured on the part.
  bool measure_features = true;
  /// Whether faces are looked for in the facets of the nominal where no CAD model tells them.
  bool find_features = false;
  /// How near to each other, mm, spots of two makers are one finding; below 0: never. Spots of one motion are
  /// one anyway. Empty: what is two samples apart is one.
  std::function<double(const SurfaceMaker&, const SurfaceMaker&)> spot_gap = {};
  int threads = 0;                          ///< 0: all cores; the result does not depend on it
  std::vector<IgnoredRegion> ignored = {};  ///< points in one of them are left out
};

enum class DeviationKind : std::uint8_t { kGouge, kExcess };

/// What one motion, or the blank, has of a patch.
struct MakerShare {
  SurfaceMaker maker;
  double share = 0.0;          ///< of the area, 0..1
  double depth_mm = 0.0;       ///< its deepest sample
  Vec3 where = Vec3::Zero();   ///< of that, mm
  Vec3 normal = Vec3::Zero();  ///< outward normal of the nominal there, unit
};

/// A region of the surface beyond tolerance: connected, or a group of spots that one tool left side by side.
struct DeviationPatch {
  DeviationKind kind = DeviationKind::kGouge;
  Vec3 where = Vec3::Zero();   ///< deepest point, mm
  Vec3 normal = Vec3::Zero();  ///< outward normal of the nominal there, unit
  double allowed_mm = 0.0;     ///< the tolerance that it is beyond
  double depth_mm = 0.0;       ///< there, from nominal (not from the tolerance), > 0
  double bound_mm = 0.0;  ///< the true depth is within this of it, and nowhere in the patch larger by more
  double chord_mm = 0.0;  ///< share of that bound that the nominal's facets have
  double area_mm2 = 0.0;  ///< beyond tolerance, of the surface that shows more of it
  double machined_area_mm2 = 0.0, nominal_area_mm2 = 0.0;  ///< of either surface
  double volume_mm3 = 0.0;                                 ///< between machined and nominal under that area
  Box3 bounds;                                             ///< of the region, mm
  SurfaceMaker maker;                                      ///< of the deepest point
  std::vector<MakerShare> makers;                          ///< of the area, largest share first; at least one
  bool from_nominal_only = false;  ///< seen only by the samples of the nominal surface
  std::size_t spots = 1;           ///< regions that are told as one
  std::uint32_t face = kNoFace;    ///< of CompareOptions::nominal_faces, at the deepest point
  /// Undecided patches only: the grid spacing at which the error would be small enough to tell, mm; 0 where
  /// the deviation is too close to the tolerance for any practical grid.
  double deciding_resolution_mm = 0.0;
};

/// The place of the nominal that a point of the part is measured to.
struct NominalFoot {
  Vec3 normal = Vec3::Zero();    ///< outward normal there, unit
  std::uint32_t face = kNoFace;  ///< of CompareOptions::nominal_faces
};

/// The deviation of any point of the machined surface. Thread-safe.
class DeviationField {
 public:
  virtual ~DeviationField() = default;
  /// Of a point of the machined mesh, mm; NaN where it is ignored.
  virtual float at(const Vec3& p) const = 0;
  /// Where that point is measured to, ignored or not.
  virtual NominalFoot footOf(const Vec3& p) const = 0;
};

/// Figures over a surface, weighted by area, without ignored regions.
struct DeviationFigures {
  double area_mm2 = 0.0;
  double rms_mm = 0.0;
  double p95_mm = 0.0;  ///< 95 % of the area deviates less, absolute value
};

struct Comparison {
  double gouge_tolerance_mm = 0.0, excess_tolerance_mm = 0.0;
  std::shared_ptr<const CadFaces> nominal_faces;  ///< those of the options, or as they were found
  bool faces_found = false;                       ///< in facets: exact to the chord of these alone
  std::vector<FaceFit> face_fits;                 ///< of the exact ones of these, in their order
  std::vector<Feature> features;                  ///< that these faces make, as they were machined
  std::vector<DeviationPatch> patches;    ///< beyond tolerance by more than their bound; deepest first
  std::vector<DeviationPatch> undecided;  ///< nearer to a tolerance than their bound; deepest first
  double max_gouge_mm = 0.0;              ///< deepest of both sides, >= 0
  double max_excess_mm = 0.0;             ///< highest of both sides, >= 0
  /// What is missing shows on the nominal's surface, what is left over mostly on the machined one.
  DeviationFigures machined, nominal;
  double rms_mm = 0.0, p95_mm = 0.0;  ///< the larger of both
  struct Histogram {
    std::vector<double> edges_mm;  ///< ascending; the outermost bins also hold everything beyond them
    std::vector<double> area_mm2;  ///< mean of both surfaces, one fewer than edges
  } histogram;
  std::vector<float> vertex_deviation;  ///< per vertex of the machined mesh, mm; NaN where it is ignored
  std::shared_ptr<const DeviationField> field;  ///< between the vertices; may be kept longer than this
  std::vector<double> ignored_mm2;  ///< of the machined surface, per region of CompareOptions::ignored
  /// Largest distance of the nominal's facets from the curved faces that they stand for, as estimated from
  /// how they turn against each other, and where. 0 for flat-faced parts.
  double nominal_chord_mm = 0.0;
  Vec3 nominal_chord_at = Vec3::Zero();
  bool nominal_chord_in_doubt = false;  ///< as much may be meant: it is of flats of a regular polygon
  /// Largest bound of a sample that decides something: 0 where all could be told without.
  double largest_bound_mm = 0.0;
  /// Of samples between the vertices of the machined mesh: 1.5 times the resolution, or more on huge meshes.
  double machined_spacing_mm = 0.0;
  double nominal_spacing_mm = 0.0;  ///< of samples on the nominal: the resolution, or more on huge meshes
  std::size_t machined_samples = 0, nominal_samples = 0;

  /// True where the surface is within tolerance and that could be told.
  bool pass() const { return patches.empty() && undecided.empty(); }
};

}  // namespace proveout
