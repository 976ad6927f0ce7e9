// Mesh writers. They are our own because the bytes must depend on the mesh alone, carry the unit and the
// motion of each triangle, and be one file that appears whole: the Open Asset Import Library puts its name
// and version into the files, adds vertex normals, leaves a material file beside an OBJ and has no place for
// unit or motion (docs/decisions/003-own-mesh-files.md).
#include <fmt/format.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"
#include "io/atomic_file.h"
#include "io/exchange/glb_model.h"
#include "io/exchange/threemf.h"
#include "io/mesh_io.h"
#include "io/sha256.h"

namespace proveout {

namespace {

using Bytes = std::string;

/// Little endian on any machine.
char* putWord32(char* at, std::uint32_t word) {
  for (int i = 0; i < 4; ++i) *at++ = static_cast<char>(word >> (8 * i) & 0xFF);
  return at;
}

char* putPoint(char* at, const Eigen::Vector3f& p) {
  for (int axis = 0; axis < 3; ++axis) at = putWord32(at, std::bit_cast<std::uint32_t>(p[axis]));
  return at;
}

/// `before`, then the coordinates as the shortest decimals that read back as the same floats.
void addPoint(Bytes& out, std::string_view before, const Eigen::Vector3f& p) {
  out += before;
  for (int i = 0; i < 3; ++i) {
    char digits[32];
    const auto result = std::to_chars(digits, digits + sizeof digits, p[i]);
    out += ' ';
    out.append(digits, static_cast<std::size_t>(result.ptr - digits));
  }
  out += '\n';
}

/// Unit normal of a triangle; zero where it has no area, as STL readers expect.
Eigen::Vector3f facetNormal(const TriMesh& mesh, const std::array<std::uint32_t, 3>& t) {
  const Vec3 a = mesh.positions[t[0]].cast<double>();
  const Vec3 u = mesh.positions[t[1]].cast<double>() - a, v = mesh.positions[t[2]].cast<double>() - a;
  const Vec3 n(u.y() * v.z() - u.z() * v.y(), u.z() * v.x() - u.x() * v.z(), u.x() * v.y() - u.y() * v.x());
  const double length = std::sqrt(n.x() * n.x() + n.y() * n.y() + n.z() * n.z());
  if (!(length > 0.0) || !std::isfinite(length)) return Eigen::Vector3f::Zero();
  return (n / length).cast<float>();
}

/// A file as a row of items: what stands before them, how many there are, and how item i is written.
template <typename AddItem>
struct Layout {
  Bytes head;
  std::size_t items;
  AddItem add;  ///< (Bytes&, i)
  Bytes tail = {};
};
template <typename AddItem>
Layout(Bytes, std::size_t, AddItem) -> Layout<AddItem>;
template <typename AddItem>
Layout(Bytes, std::size_t, AddItem, Bytes) -> Layout<AddItem>;

// The text must not begin with "solid": readers take that for the ASCII variant.
auto stlBinary(const TriMesh& mesh) {
  Bytes head = "proveout binary STL, unit mm";
  head.resize(84, ' ');
  putWord32(&head[80], static_cast<std::uint32_t>(mesh.triangles.size()));
  return Layout{std::move(head), mesh.triangles.size(), [&mesh](Bytes& out, std::size_t i) {
                  const auto& t = mesh.triangles[i];
                  char record[50] = {};
                  char* at = putPoint(record, facetNormal(mesh, t));
                  for (const std::uint32_t corner : t) at = putPoint(at, mesh.positions[corner]);
                  out.append(record, sizeof record);
                }};
}

auto stlAscii(const TriMesh& mesh) {
  return Layout{Bytes("solid proveout unit mm\n"), mesh.triangles.size(),
                [&mesh](Bytes& out, std::size_t i) {
                  const auto& t = mesh.triangles[i];
                  addPoint(out, "facet normal", facetNormal(mesh, t));
                  out += "  outer loop\n";
                  for (const std::uint32_t corner : t) addPoint(out, "    vertex", mesh.positions[corner]);
                  out += "  endloop\nendfacet\n";
                },
                Bytes("endsolid proveout unit mm\n")};
}

auto obj(const TriMesh& mesh) {
  return Layout{Bytes("# proveout, unit mm\n"), mesh.positions.size() + mesh.triangles.size(),
                [&mesh](Bytes& out, std::size_t i) {
                  if (i < mesh.positions.size()) return addPoint(out, "v", mesh.positions[i]);
                  const auto& t = mesh.triangles[i - mesh.positions.size()];
                  fmt::format_to(std::back_inserter(out), "f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
                }};
}

auto ply(const TriMesh& mesh) {
  const bool motion = !mesh.motion.empty();
  PROVEOUT_ASSERT(!motion || mesh.motion.size() == mesh.triangles.size());
  Bytes head = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment proveout, unit mm\n"
      "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
      "element face {}\nproperty list uchar int vertex_indices\n{}end_header\n",
      mesh.positions.size(), mesh.triangles.size(), motion ? "property uint motion\n" : "");
  return Layout{std::move(head), mesh.positions.size() + mesh.triangles.size(),
                [&mesh, motion](Bytes& out, std::size_t i) {
                  char record[17] = {3};
                  char* at = record;
                  if (i < mesh.positions.size()) {
                    at = putPoint(record, mesh.positions[i]);
                  } else {
                    i -= mesh.positions.size();
                    ++at;
                    for (const std::uint32_t corner : mesh.triangles[i]) at = putWord32(at, corner);
                    if (motion) at = putWord32(at, mesh.motion[i]);
                  }
                  out.append(record, static_cast<std::size_t>(at - record));
                }};
}

/// Writes the layout piece by piece. While one piece is hashed and written, the next one is made.
template <typename AddItem>
void writeLayout(const Layout<AddItem>& layout, AtomicFile& file, Sha256* hash) {
  constexpr std::size_t kPiece = 1u << 20;
  Bytes piece, next;
  piece.reserve(kPiece + 512);
  next.reserve(kPiece + 512);
  std::size_t item = 0;
  bool ended = false;
  const auto fill = [&](Bytes& out) {
    out.clear();
    while (out.size() < kPiece && item < layout.items) layout.add(out, item++);
    if (item == layout.items && !std::exchange(ended, true)) out += layout.tail;
  };
  piece = layout.head;
  while (!piece.empty()) {
    parallelFor(0, 2, [&](int job) {
      if (job == 0) {
        if (hash != nullptr) hash->update(piece.data(), piece.size());
      } else {
        file.write(piece);
        fill(next);
      }
    });
    std::swap(piece, next);
  }
}

/// What makes a mesh impossible to write, or "".
std::string defect(const TriMesh& mesh) {
  // OBJ counts from 1 in 32 bits, PLY here in 31, STL counts triangles in 32.
  if (mesh.positions.size() > 0x7FFFFFFEu || mesh.triangles.size() > 0xFFFFFFFEu)
    return "is too large for the format";
  if (!mesh.motion.empty() && mesh.motion.size() != mesh.triangles.size()) {
    return "has another number of motions than of triangles";
  }
  for (const Eigen::Vector3f& p : mesh.positions) {
    if (!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z())) {
      return "has a position that is not finite";
    }
  }
  for (const auto& t : mesh.triangles) {
    for (const std::uint32_t corner : t) {
      if (corner >= mesh.positions.size()) return "has a triangle with an index out of range";
    }
  }
  return {};
}

Status writeFile(const TriMesh& mesh, const std::string& path, MeshFormat format, Sha256* hash) {
  const std::string wrong = defect(mesh);
  if (!wrong.empty()) return Error{ErrorKind::kInternal, path + ": the mesh " + wrong};
  Result<AtomicFile> file = AtomicFile::create(path);
  if (!file) return file.error();
  switch (format) {
    case MeshFormat::kStlBinary:
      writeLayout(stlBinary(mesh), *file, hash);
      break;
    case MeshFormat::kStlAscii:
      writeLayout(stlAscii(mesh), *file, hash);
      break;
    case MeshFormat::kObj:
      writeLayout(obj(mesh), *file, hash);
      break;
    case MeshFormat::kPly:
      writeLayout(ply(mesh), *file, hash);
      break;
    case MeshFormat::kThreeMf:
    case MeshFormat::kGlb:
      break;  // writePackage
  }
  return file->commit();
}

/// Formats that are made of several parts.
bool isPackage(MeshFormat format) { return format == MeshFormat::kThreeMf || format == MeshFormat::kGlb; }

Result<std::string> writePackage(const TriMesh& mesh, const std::string& path, MeshFormat format) {
  const std::string wrong = defect(mesh);
  if (!wrong.empty()) return Error{ErrorKind::kInternal, path + ": the mesh " + wrong};
  return format == MeshFormat::kGlb ? writePartGlb(mesh, path) : writeThreeMf(mesh, path);
}

}  // namespace

Status writeMesh(const TriMesh& mesh, const std::string& path, MeshFormat format) {
  if (isPackage(format)) {
    const Result<std::string> written = writePackage(mesh, path, format);
    return written ? Status(Done{}) : Status(written.error());
  }
  return writeFile(mesh, path, format, nullptr);
}

Result<std::string> writeMeshHashed(const TriMesh& mesh, const std::string& path, MeshFormat format) {
  if (isPackage(format)) return writePackage(mesh, path, format);
  Sha256 hash;
  if (const Status done = writeFile(mesh, path, format, &hash); !done) return done.error();
  return hash.finish();
}

}  // namespace proveout
