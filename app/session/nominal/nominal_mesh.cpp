#include "app/session/nominal/nominal_mesh.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <variant>

#include "app/session/nominal/alignment.h"
#include "io/mesh_io.h"
#include "io/step/step_file.h"

namespace proveout {

void addMeshWarnings(const std::vector<std::string>& texts, const std::string& code,
                     Diagnostics& diagnostics) {
  for (const std::string& text : texts) {
    Diagnostic diagnostic;
    diagnostic.severity = Severity::kWarning;
    diagnostic.code = code;
    diagnostic.message = text;
    diagnostics.add(std::move(diagnostic));
  }
}

namespace {

/// The faces of a mesh may be found in its facets, but they have no names.
Status checkNameless(const NominalSpec& nominal) {
  const auto refused = [&](const char* table) {
    return inputError(nominal.mesh.path + ": " + table +
                      " with `face` needs a STEP file: the faces of a mesh have no names");
  };
  for (const LocalTolerance& local : nominal.local)
    if (!local.face.empty()) return refused("[[nominal.tolerance]]");
  for (const CharacteristicRule& rule : nominal.characteristics)
    if (!rule.face.empty()) return refused("[[characteristic]]");
  return Done{};
}

/// Tolerances for faces that the model does not have are a mistake.
Status checkLocalTolerances(const NominalSpec& nominal, const CadFaces* faces) {
  if (faces == nullptr) return checkNameless(nominal);
  for (const LocalTolerance& local : nominal.local) {
    if (local.face.empty()) continue;
    const bool there = std::any_of(faces->faces.begin(), faces->faces.end(),
                                   [&](const CadFace& face) { return isNamed(face, local.face); });
    if (!there)
      return inputError(nominal.mesh.path + ": [[nominal.tolerance]] names a face '" + local.face +
                        "' that the file does not have");
  }
  return Done{};
}

/// A model of a CAD system: its mesh, with what the faces are exactly.
Result<PreparedMesh> loadCadNominal(const NominalSpec& nominal) {
  constexpr double kCoarsest = 0.02, kShare = 0.1;  // mm; of the tolerance, for faces that are no exact ones
  const double tolerance = std::min(nominal.gouge_mm, nominal.excess_mm);
  StepLoadOptions options;
  options.body = nominal.mesh.body;
  options.chord_mm = std::min(kCoarsest, tolerance) / nominal.placement.scale;
  options.free_chord_mm = kShare * tolerance / nominal.placement.scale;
  Result<StepBody> body = loadStep(nominal.mesh.path, options);
  if (!body) return body.error();
  placeMesh(nominal.placement, body->mesh);
  for (CadFace& face : body->faces.faces) face = face.placed(nominal.placement);
  body->faces.chord_mm *= nominal.placement.scale;
  Result<PreparedMesh> prepared = prepareNominal(body->mesh, nominal.mesh.path);
  if (!prepared) return prepared;
  CadFaces faces = facesOf(prepared->mesh, body->mesh, std::move(body->faces));
  prepared->faces = std::make_shared<const CadFaces>(joinedFaces(prepared->mesh, std::move(faces)));
  if (Status known = checkLocalTolerances(nominal, prepared->faces.get()); !known) return known.error();
  prepared->notes.insert(prepared->notes.begin(), body->notes.begin(), body->notes.end());
  return prepared;
}

}  // namespace

Result<PreparedMesh> loadNominal(const NominalSpec& nominal) {
  if (isStepFile(nominal.mesh.path)) return loadCadNominal(nominal);
  if (Status known = checkLocalTolerances(nominal, nullptr); !known) return known.error();
  if (Status known = checkAlignment(nominal, nullptr); !known) return known.error();
  MeshLoadOptions options;
  options.unit = nominal.mesh.unit;
  Result<TriMesh> mesh = loadMesh(nominal.mesh.path, options);
  if (!mesh) return mesh.error();
  placeMesh(nominal.placement, *mesh);
  return prepareNominal(*mesh, nominal.mesh.path);
}

Result<LoadedSolid> loadSolid(const StockSpec& spec) {
  Result<StockShape> shape = loadStockShape(spec);
  if (!shape) return shape.error();
  LoadedSolid out{std::move(*shape), {}};
  auto* mesh = std::get_if<MeshShape>(&out.shape);
  if (mesh == nullptr) return out;
  Result<PreparedMesh> solid = prepareNominal(mesh->mesh, mesh->name);
  if (!solid) return solid.error();
  mesh->mesh = std::move(solid->mesh);
  out.repairs = std::move(solid->notes);
  return out;
}

}  // namespace proveout
