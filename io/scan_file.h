// Scans from files: points, or meshes that need not be closed. In memory always mm.
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/mesh/tri_mesh.h"
#include "io/mesh_io.h"

namespace proveout {

/// What a scanner measured.
struct ScanFile {
  TriMesh mesh;         ///< its points, mm; triangles where the file has some, not judged
  bool meshed = false;  ///< it has triangles
};

/// Reads a scan: PLY (ASCII or binary; vertices with x, y and z, with or without faces) or STL, of which the
/// triangles may be open. Errors: those of loadMesh, but for points without a surface; another format; no
/// points.
Result<ScanFile> loadScan(const std::string& path, const MeshLoadOptions& options = {});

/// The same from memory; `extension` is "ply" or "stl" in any case, `name` stands in errors.
Result<ScanFile> parseScan(std::string_view bytes, std::string_view extension, const std::string& name,
                           const MeshLoadOptions& options = {});

}  // namespace proveout
