// 3MF packages (3D Manufacturing Format, Core Specification 1.3): a part as one object of a print job.
#pragma once

#include <string>

#include "core/base/result.h"
#include "core/mesh/tri_mesh.h"

namespace proveout {

/// Writes the part, whole file or none; the SHA-256 of its bytes. Unit mm, +Z up; coordinates are the
/// shortest decimals that read back as the same floats. A mesh without triangles is a package that builds
/// nothing.
Result<std::string> writeThreeMf(const TriMesh& mesh, const std::string& path);

}  // namespace proveout
