// The machined surface against nominal CAD: where material is missing (gouge) or left over (excess). Only the
// .cpp files behind this header see CGAL.
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/tri_mesh.h"
#include "removal/compare/comparison.h"
#include "removal/compare/nominal.h"

namespace proveout {

/// Compares two closed meshes. Both must be as prepareNominal leaves them (the mesh of a Stock is); what is
/// not closed or not finite is refused with kInput. kInterrupted where `progress` was cancelled. Points of
/// the machined mesh carry `motion` where it is filled.
Result<Comparison> compareToNominal(const TriMesh& machined, const TriMesh& nominal,
                                    const CompareOptions& options, Progress& progress);

}  // namespace proveout
