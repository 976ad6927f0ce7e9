// Brings the nominal of a run, or of a comparison, to where the part lies.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "io/job/job.h"
#include "io/report.h"
#include "removal/compare/fit/alignment.h"
#include "removal/compare/nominal.h"

namespace proveout {

/// What became of a wish: one of both.
struct AlignOutcome {
  std::optional<Alignment> alignment;
  std::string fault;  ///< why the nominal was left where it was: a sentence, with what to do
};

/// A part that a nominal is aligned to.
struct AlignedPart {
  const TriMesh& mesh;
  const ExactPart* exact = nullptr;  ///< null: the mesh is all there is
  double uncertainty_mm = 0.0;       ///< how far the mesh may lie off the exact part
};

/// Looks for the motion and moves mesh and faces of the nominal by it, where no point moves farther than the
/// wish allows. Errors: datums of a nominal whose faces are not known (a mesh); interrupted.
Result<AlignOutcome> alignNominal(const NominalSpec& spec, const AlignedPart& part, PreparedMesh& nominal,
                                  Progress& progress);

/// The same to the points of a scan; by a fit alone. Errors: datums; interrupted.
Result<AlignOutcome> alignToScan(const NominalSpec& spec, const std::vector<Vec3>& points,
                                 PreparedMesh& nominal, Progress& progress);

/// Where the features of the nominal, `faces` of which are known, are measured behind the comparison: in the
/// frame of the model as it was before.
void measureAligned(const PreparedMesh& nominal, const Alignment& alignment, const AlignedPart& part,
                    double spacing_mm, Comparison& comparison);

/// Findings of features, from the one of that index on, come in the frame of the model: puts their places
/// onto the part.
void placeOnPart(const RigidTransform& motion, std::size_t first, std::vector<Finding>& findings);

/// Error where the wish needs faces that the nominal does not have.
Status checkAlignment(const NominalSpec& spec, const CadFaces* faces);

ReportAlignment reportAlignment(const Alignment& alignment);

}  // namespace proveout
