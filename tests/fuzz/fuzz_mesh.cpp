// Feeds any bytes to the readers of meshes. The first byte says which format and unit. What is read must be
// sound, come out the same when it is written and read again, and is made a nominal and a blank as a run
// does.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "core/mesh/edge_table.h"
#include "core/mesh/tri_mesh.h"
#include "io/mesh_io.h"
#include "removal/compare/compare.h"
#include "removal/grid/stock.h"
#include "tests/fuzz/laws.h"

namespace {

using namespace proveout;

/// CGAL joins bodies that overlap; larger meshes take it too long for a fuzzer.
constexpr std::size_t kMostTriangles = 64;
/// Cells along the longest side of a blank.
constexpr double kCells = 8.0;

bool sameCorners(const TriMesh& a, const TriMesh& b) {
  if (a.triangles.size() != b.triangles.size()) return false;
  for (std::size_t t = 0; t < a.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (a.positions[a.triangles[t][k]] != b.positions[b.triangles[t][k]]) return false;
    }
  }
  return true;
}

void checkSound(const TriMesh& mesh) {
  require(!mesh.triangles.empty(), "a mesh that was read has a triangle");
  for (const auto& p : mesh.positions) require(p.allFinite(), "positions are finite");
  for (const auto& t : mesh.triangles)
    require(triangleIsProper(t, mesh.positions.size()), "triangles have three corners of the mesh");
  require(mesh.motion.empty() || mesh.motion.size() == mesh.triangles.size(), "one motion a triangle");
  const MeshExtent extent = meshExtent(mesh);
  require(std::isfinite(extent.volume_mm3) && std::isfinite(meshArea(mesh)), "volume and area are finite");
  require(sameCorners(weldVertices(mesh), mesh), "what was read is welded");
  std::uint32_t count = 0;
  const MeshTopology topology = analyseTopology(mesh);
  require(meshComponents(mesh, count).size() == mesh.triangles.size(), "each triangle has a component");
  require(count == topology.components, "components are counted alike");
}

void checkWritten(const TriMesh& mesh, std::size_t choice) {
  static const ScratchFolder folder;
  constexpr std::array<MeshFormat, 6> kFormats = {MeshFormat::kStlBinary, MeshFormat::kStlAscii,
                                                  MeshFormat::kObj,       MeshFormat::kPly,
                                                  MeshFormat::kThreeMf,   MeshFormat::kGlb};
  const MeshFormat format = kFormats[choice % kFormats.size()];
  const std::string path = folder.at(format == MeshFormat::kObj       ? "mesh.obj"
                                     : format == MeshFormat::kPly     ? "mesh.ply"
                                     : format == MeshFormat::kThreeMf ? "mesh.3mf"
                                     : format == MeshFormat::kGlb     ? "mesh.glb"
                                                                      : "mesh.stl");
  require(writeMesh(mesh, path, format).ok(), "what was read can be written");
  const Result<TriMesh> again = loadMesh(path);
  require(again.ok() && sameCorners(mesh, *again), "written and read again it is the same");
  if (format == MeshFormat::kPly) require(again->motion == mesh.motion, "motions are kept");
}

void checkNominal(const TriMesh& mesh) {
  const Result<PreparedMesh> nominal = prepareNominal(mesh, "mesh");
  if (!nominal) return require(!nominal.error().message.empty(), "a refusal has a reason");
  const MeshTopology topology = analyseTopology(nominal->mesh);
  require(topology.boundary_edges + topology.degenerate_triangles + topology.non_finite_positions == 0,
          "a nominal is closed");
  require(meshVolume(nominal->mesh) > 0.0, "a nominal has volume");
  const Result<PreparedMesh> again = prepareNominal(nominal->mesh, "mesh");
  // Bodies that were found to touch only may overlap by the rounding of the coordinates of what was joined.
  const bool rounded = !again && again.error().message.find("cannot be joined") != std::string::npos;
  require(again.ok() || rounded, "a nominal is a nominal");
}

void checkBlank(const TriMesh& mesh) {
  RemovalOptions options;
  options.threads = 1;
  options.max_memory_gb = 0.2;
  options.resolution_mm = meshBounds(mesh).size().maxCoeff() / kCells;
  Progress progress;
  const Result<Stock> stock = Stock::create(MeshShape{mesh, "mesh"}, options, progress);
  if (!stock) return require(!stock.error().message.empty(), "a refusal has a reason");
  const Result<StockSurface> surface = stock->surface(1, progress);
  require(surface.ok(), "a blank has a surface");
  require(std::isfinite(surface->volume_mm3) && std::isfinite(stock->initialVolume()), "volumes are finite");
  require(analyseTopology(surface->mesh).closedManifold(), "the surface of a blank is closed");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  constexpr std::uint8_t kPackages = 250;  // from there on; the corpus is older than them
  const char* const extension = data[0] >= kPackages ? std::array{"glb", "3mf"}[data[0] % 2]
                                                     : std::array{"stl", "obj", "ply"}[data[0] % 3];
  MeshLoadOptions options;
  options.unit = std::array{MeshUnit::kMillimetre, MeshUnit::kInch, MeshUnit::kMetre}[data[0] / 3 % 3];
  const Result<TriMesh> mesh = parseMesh(bytes, extension, "mesh", options);
  if (!mesh) {
    require(mesh.error().message.starts_with("mesh: "), "an error names the file");
    return 0;
  }
  checkSound(*mesh);
  const Result<TriMesh> again = parseMesh(bytes, extension, "mesh", options);
  require(again.ok() && again->positions == mesh->positions && again->triangles == mesh->triangles &&
              again->motion == mesh->motion,
          "a second reading gives the same");
  checkWritten(*mesh, size);
  if (mesh->triangles.size() > kMostTriangles) return 0;
  checkNominal(*mesh);
  checkBlank(*mesh);
  return 0;
}
