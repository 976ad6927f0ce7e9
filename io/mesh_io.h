// Triangle meshes from and to files. In memory always mm.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/mesh/tri_mesh.h"

namespace proveout {

/// Unit of the coordinates in a file. STL, OBJ and PLY do not state one; see statesUnit.
enum class MeshUnit : std::uint8_t { kMillimetre, kInch, kMetre };
double meshUnitInMm(MeshUnit unit);                     ///< 1, 25.4, 1000
Result<MeshUnit> parseMeshUnit(std::string_view text);  ///< "mm", "inch" or "in", "m"
std::string_view meshUnitName(MeshUnit unit);           ///< "mm", "inch", "m"
/// Whether files of that name state their unit themselves: STEP, 3MF and GLB (metres by its standard).
bool statesUnit(std::string_view path);

struct MeshLoadOptions {
  MeshUnit unit = MeshUnit::kMillimetre;
  std::uint64_t max_bytes = 8ull << 30;  ///< larger files are refused before they are read
  std::string body = {};                 ///< of a STEP file: its name or number; empty: the only one
};

/// Reads STL (binary, ASCII), OBJ, PLY (ASCII, binary of either byte order), 3MF, GLB or a body of a STEP file,
/// which is faceted to 0.005 mm (io/step/step_file.h); the extension names the format, the content decides
/// between its variants. Of a 3MF the objects that it builds, and of a GLB the meshes of its scene, are read as
/// one mesh, placed as the file says; GLB's metres with +Y up become mm with +Z up. Polygons are triangulated, equal positions merged (weldVertices).
/// Whether the mesh is closed is not judged here. Errors: not a regular file, unreadable, empty, too large,
/// cut short, counts that do not fit the file's size, a coordinate that is not finite in single precision, an
/// index out of range, points or lines in place of faces, no triangle left.
Result<TriMesh> loadMesh(const std::string& path, const MeshLoadOptions& options = {});

/// The same from memory; `extension` is "stl", "obj", "ply", "3mf" or "glb" in any case, `name` stands in errors.
Result<TriMesh> parseMesh(std::string_view bytes, std::string_view extension, const std::string& name,
                          const MeshLoadOptions& options = {});

enum class MeshFormat : std::uint8_t { kStlBinary, kStlAscii, kObj, kPly, kThreeMf, kGlb };

/// Writes a mesh, mm; whole file or none. The bytes depend on the mesh alone. Coordinates survive a round
/// trip bit for bit. The text or header says that the unit is mm. PLY (binary, little endian) also carries
/// the motion of every triangle where the mesh has one, as face property `motion` (uint). 3MF and GLB are those
/// of io/exchange/threemf.h and glb_model.h. Errors: an index
/// out of range, a non-finite position, more triangles than the format can count, and those of AtomicFile.
Status writeMesh(const TriMesh& mesh, const std::string& path, MeshFormat format);
/// The same; returns the SHA-256 of the bytes (64 hex digits), taken while they are written.
Result<std::string> writeMeshHashed(const TriMesh& mesh, const std::string& path, MeshFormat format);

}  // namespace proveout
