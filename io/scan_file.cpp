#include "io/scan_file.h"

#include <filesystem>
#include <new>

#include "core/base/memory.h"
#include "core/base/memory_limit.h"
#include "io/atomic_file.h"
#include "io/mesh_formats.h"

namespace proveout {

namespace {

Error outOfMemory(const std::string& name) {
  return proveout::outOfMemory(name + ": the scan does not fit into memory", "take fewer points");
}

}  // namespace

Result<ScanFile> parseScan(std::string_view bytes, std::string_view extension, const std::string& name,
                           const MeshLoadOptions& options) {
  const std::string format = mesh_formats::lowerCase(extension);
  if (format != "ply" && format != "stl")
    return inputError(name + ": is no scan that can be read; the name must end in .ply or .stl");
  if (bytes.empty()) return inputError(name + ": is empty");
  try {
    mesh_formats::MeshBuilder builder;
    builder.scale = meshUnitInMm(options.unit);
    const Status status =
        format == "ply" ? mesh_formats::readPly(bytes, builder) : mesh_formats::readStl(bytes, builder);
    if (!status) return Error{status.error().kind, name + ": " + status.error().message};
    ScanFile scan;
    scan.meshed = !builder.mesh.triangles.empty();
    scan.mesh = scan.meshed ? weldVertices(builder.mesh) : std::move(builder.mesh);
    if (scan.mesh.positions.empty()) return inputError(name + ": the scan has no points");
    return scan;
  } catch (const std::bad_alloc&) {
    return outOfMemory(name);
  }
}

Result<ScanFile> loadScan(const std::string& path, const MeshLoadOptions& options) {
  try {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    constexpr double kCopies = 3.0;  // the file, its points, the welded mesh
    const Status fits = error ? Status(Done{}) : memoryFor(kCopies * static_cast<double>(size), path);
    if (!fits) return fits.error();
    const Result<std::string> bytes = readWholeFile(path, options.max_bytes);
    if (!bytes) return bytes.error();
    const std::string extension = std::filesystem::path(path).extension().string();
    return parseScan(*bytes, extension.empty() ? "" : extension.substr(1), path, options);
  } catch (const std::bad_alloc&) {
    return outOfMemory(path);
  }
}

}  // namespace proveout
