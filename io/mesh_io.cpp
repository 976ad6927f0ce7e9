// Loading of meshes: units, the choice of the reader, and what every format has in common.
#include "io/mesh_io.h"

#include <fmt/format.h>

#include <filesystem>
#include <new>

#include "core/base/memory.h"
#include "core/base/memory_limit.h"
#include "io/atomic_file.h"
#include "io/mesh_formats.h"
#include "io/step/step_file.h"

namespace proveout {

double meshUnitInMm(MeshUnit unit) {
  switch (unit) {
    case MeshUnit::kMillimetre:
      return 1.0;
    case MeshUnit::kInch:
      return 25.4;
    case MeshUnit::kMetre:
      return 1000.0;
  }
  return 1.0;
}

std::string_view meshUnitName(MeshUnit unit) {
  switch (unit) {
    case MeshUnit::kMillimetre:
      return "mm";
    case MeshUnit::kInch:
      return "inch";
    case MeshUnit::kMetre:
      return "m";
  }
  return "mm";
}

Result<MeshUnit> parseMeshUnit(std::string_view text) {
  if (text == "mm") return MeshUnit::kMillimetre;
  if (text == "inch" || text == "in") return MeshUnit::kInch;
  if (text == "m") return MeshUnit::kMetre;
  return inputError("there is no unit '" + std::string(text) + "'; there are mm, inch, m");
}

namespace {

using mesh_formats::MeshBuilder;
using Reader = Status (*)(std::string_view, MeshBuilder&);

Reader readerFor(const std::string& extension) {
  if (extension == "stl") return mesh_formats::readStl;
  if (extension == "obj") return mesh_formats::readObj;
  if (extension == "ply") return mesh_formats::readPly;
  if (extension == "glb") return mesh_formats::readGlb;
  if (extension == "3mf") return mesh_formats::readThreeMf;
  return nullptr;
}

std::string extensionOf(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  return extension.empty() ? extension : extension.substr(1);
}

Error unknownFormat(const std::string& name) {
  return inputError(
      name +
      ": is no mesh that can be read; the name must end in .stl, .obj, .ply, .3mf, .glb, .step or .stp");
}

Error outOfMemory(const std::string& name) {
  return proveout::outOfMemory(name + ": the mesh does not fit into memory", "take a coarser one");
}

}  // namespace

bool statesUnit(std::string_view path) {
  const std::string extension = mesh_formats::lowerCase(extensionOf(std::string(path)));
  return extension == "glb" || extension == "3mf" || isStepFile(path);
}

Result<TriMesh> parseMesh(std::string_view bytes, std::string_view extension, const std::string& name,
                          const MeshLoadOptions& options) {
  const Reader reader = readerFor(mesh_formats::lowerCase(extension));
  if (reader == nullptr) return unknownFormat(name);
  if (bytes.empty()) return inputError(name + ": is empty");
  try {
    MeshBuilder builder;
    builder.scale = statesUnit(fmt::format("x.{}", extension)) ? 1.0 : meshUnitInMm(options.unit);
    const Status status = reader(bytes, builder);
    if (!status) return Error{status.error().kind, name + ": " + status.error().message};
    TriMesh mesh = weldVertices(builder.mesh);
    if (mesh.triangles.empty())
      return inputError(name + ": has no surface: no triangle with three different corners");
    return mesh;
  } catch (const std::bad_alloc&) {
    return outOfMemory(name);
  }
}

Result<TriMesh> loadMesh(const std::string& path, const MeshLoadOptions& options) {
  if (isStepFile(path)) {
    constexpr double kChord = 0.005;
    Result<StepBody> body =
        loadStep(path, {.body = options.body, .chord_mm = kChord, .free_chord_mm = kChord});
    if (!body) return body.error();
    return std::move(body->mesh);
  }
  const std::string extension = extensionOf(path);
  if (readerFor(mesh_formats::lowerCase(extension)) == nullptr) return unknownFormat(path);
  try {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    constexpr double kCopies = 3.0;  // the file, its triangles, the welded mesh
    const Status fits = error ? Status(Done{}) : memoryFor(kCopies * static_cast<double>(size), path);
    if (!fits) return fits.error();
    const Result<std::string> bytes = readWholeFile(path, options.max_bytes);
    if (!bytes) return bytes.error();
    return parseMesh(*bytes, extension, path, options);
  } catch (const std::bad_alloc&) {
    return outOfMemory(path);
  }
}

}  // namespace proveout
