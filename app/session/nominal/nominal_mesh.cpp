#include "app/session/nominal/nominal_mesh.h"

#include <utility>
#include <variant>

#include "io/mesh_io.h"

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

Result<PreparedMesh> loadNominal(const NominalSpec& nominal) {
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
