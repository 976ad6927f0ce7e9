// STEP files (ISO 10303-21: AP203, AP214, AP242 with geometry) as meshes with exact faces. They are read by
// OpenCASCADE in a process of its own, which may crash, loop or eat memory without taking a run with it
// (docs/decisions/057-step-process.md).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/mesh/cad_faces.h"
#include "core/mesh/tri_mesh.h"

namespace proveout {

/// Does the name end in .step or .stp, in any case?
bool isStepFile(std::string_view path);

/// Is the reader there? Errors: it is not installed; says how it comes.
Status checkStepReader();

struct StepLoadOptions {
  std::string body;        ///< its name, or its number from 1; empty: the only one
  double chord_mm = 0.02;  ///< facets of planes, cylinders, cones, spheres and tori: no farther off, > 0
  double free_chord_mm = 0.005;  ///< the same where the body has other faces too, > 0
  int most_s = 120;              ///< processor time that reading may take
};

/// A body of a file.
struct StepBody {
  TriMesh mesh;  ///< mm; equal positions merged
  CadFaces faces;
  std::string name;                 ///< may be empty
  std::string unit;                 ///< of the file: "millimetre", "inch"
  std::vector<std::string> bodies;  ///< names of all bodies in the file
  std::vector<std::string> notes;   ///< what was done about a body that is no plain solid, one sentence each
};

/// Reads one body. Errors: no reader, no such file, damaged, no solid, several bodies and none chosen or not
/// that one, too long, too much memory, the library crashed.
Result<StepBody> loadStep(const std::string& path, const StepLoadOptions& options = {});

}  // namespace proveout
