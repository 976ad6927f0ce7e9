// Scans against a nominal: one-sided, since what was not scanned says nothing.
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/tri_mesh.h"
#include "removal/compare/comparison.h"

namespace proveout {

struct ScanOptions {
  /// Tolerances, spacing of the samples on the nominal, faces and ignored regions; the part's frame. Not
  /// used: `part`, `uncertainty_mm`, `local`, features.
  CompareOptions compare;
  /// How near to a place of the nominal a point shows it; 0: two spacings of the points, or of fewer than
  /// nine the spacing of the samples.
  double reach_mm = 0.0;
};

/// Points farther from the nominal are not of the part: fixture, table, dust. Twenty times the larger
/// tolerance, 2 mm at least.
double scanOffLimit(const CompareOptions& options);

/// What a scan shows of a part.
struct ScanComparison {
  /// Deviations are those of the scan's points; in place of the machined mesh stands the nominal, whose
  /// vertices have the mean of the points that show them, NaN where there are none. Figures weigh points by
  /// the area that they stand for. Patches are of the nominal's surface; their deepest points are points of
  /// the scan. Features are not measured.
  Comparison comparison;
  std::size_t points = 0;   ///< that were compared: not off and not ignored
  std::size_t off = 0;      ///< beyond scanOffLimit()
  double spacing_mm = 0.0;  ///< of the points: the side of the square that each has for itself, about
  double reach_mm = 0.0;    ///< as it was taken
  double coverage = 0.0;    ///< share of the nominal's area that points show, 0..1; without ignored regions
};

/// The points of a scanned mesh, which may be open: its vertices and, on triangles with longer sides than
/// `spacing_mm` > 0, more between them. Of a mesh without triangles the vertices.
std::vector<Vec3> scanPointsOf(const TriMesh& mesh, double spacing_mm);

/// Measures every point of a scan to the closed `nominal`, deviations as in comparison.h: a point outside is
/// excess. A place of the nominal is shown by points whose foot on it is no farther off than the reach, on a
/// surface that faces about the same way. The same for the same input, whatever the number of threads.
/// Errors: kInput for no points, points that are not finite, a nominal that is not closed; kInterrupted.
Result<ScanComparison> compareScan(const std::vector<Vec3>& points, const TriMesh& nominal,
                                   const ScanOptions& options, Progress& progress);

}  // namespace proveout
