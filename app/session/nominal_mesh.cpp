#include "app/session/nominal_mesh.h"

#include "io/mesh_io.h"

namespace proveout {

void noteRepairs(const PreparedMesh& mesh, const std::string& code, Diagnostics& diagnostics) {
  for (const std::string& note : mesh.notes) {
    Diagnostic diagnostic;
    diagnostic.severity = Severity::kWarning;
    diagnostic.code = code;
    diagnostic.message = note;
    diagnostics.add(std::move(diagnostic));
  }
}

Result<PreparedMesh> loadNominal(const NominalSpec& nominal) {
  MeshLoadOptions options;
  options.unit = nominal.mesh.unit;
  const Result<TriMesh> mesh = loadMesh(nominal.mesh.path, options);
  if (!mesh) return mesh.error();
  return prepareNominal(*mesh, nominal.mesh.path);
}

}  // namespace proveout
