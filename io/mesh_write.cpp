// Mesh writers. They are our own because the bytes must depend on the mesh alone, carry the unit and the motion of each
// triangle, and be one file that appears whole: the Open Asset Import Library puts its name and version into the
// files, adds vertex normals, leaves a material file beside an OBJ and has no place for unit or motion
// (docs/decisions/003-own-mesh-files.md).
#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <cmath>

#include "io/atomic_file.h"
#include "io/mesh_io.h"

namespace proveout {

namespace {

/// Collects bytes and hands them on in large pieces.
class Output {
 public:
  explicit Output(AtomicFile& file) : file_(file) { buffer_.reserve(kPiece + 256); }

  void text(std::string_view text) {
    buffer_ += text;
    flushIfFull();
  }
  void word16(std::uint16_t word) { bytes(word, 2); }
  void word32(std::uint32_t word) { bytes(word, 4); }
  void real32(float x) { word32(std::bit_cast<std::uint32_t>(x)); }
  void byte(std::uint8_t x) { bytes(x, 1); }
  /// Shortest decimal that reads back as the same float.
  void number(float x) {
    char digits[32];
    const auto result = std::to_chars(digits, digits + sizeof digits, x);
    text(std::string_view(digits, static_cast<std::size_t>(result.ptr - digits)));
  }
  void point(std::string_view before, const Eigen::Vector3f& p) {
    text(before);
    for (int i = 0; i < 3; ++i) {
      text(" ");
      number(p[i]);
    }
    text("\n");
  }
  void flush() {
    file_.write(buffer_);
    buffer_.clear();
  }

 private:
  static constexpr std::size_t kPiece = 1u << 20;

  /// Little endian on any machine.
  void bytes(std::uint32_t word, int count) {
    for (int i = 0; i < count; ++i) buffer_ += static_cast<char>(word >> (8 * i) & 0xFF);
    flushIfFull();
  }
  void flushIfFull() {
    if (buffer_.size() >= kPiece) flush();
  }

  AtomicFile& file_;
  std::string buffer_;
};

/// Unit normal of a triangle; zero where it has no area, as STL readers expect.
Eigen::Vector3f facetNormal(const TriMesh& mesh, const std::array<std::uint32_t, 3>& t) {
  const Vec3 a = mesh.positions[t[0]].cast<double>();
  const Vec3 u = mesh.positions[t[1]].cast<double>() - a, v = mesh.positions[t[2]].cast<double>() - a;
  const Vec3 n(u.y() * v.z() - u.z() * v.y(), u.z() * v.x() - u.x() * v.z(), u.x() * v.y() - u.y() * v.x());
  const double length = std::sqrt(n.x() * n.x() + n.y() * n.y() + n.z() * n.z());
  if (!(length > 0.0) || !std::isfinite(length)) return Eigen::Vector3f::Zero();
  return (n / length).cast<float>();
}

// The text must not begin with "solid": readers take that for the ASCII variant.
void writeStlBinary(const TriMesh& mesh, Output& out) {
  std::string header = "proveout binary STL, unit mm";
  header.resize(80, ' ');
  out.text(header);
  out.word32(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3f normal = facetNormal(mesh, t);
    for (int i = 0; i < 3; ++i) out.real32(normal[i]);
    for (const std::uint32_t corner : t) {
      for (int i = 0; i < 3; ++i) out.real32(mesh.positions[corner][i]);
    }
    out.word16(0);
  }
}

void writeStlAscii(const TriMesh& mesh, Output& out) {
  out.text("solid proveout unit mm\n");
  for (const auto& t : mesh.triangles) {
    out.point("facet normal", facetNormal(mesh, t));
    out.text("  outer loop\n");
    for (const std::uint32_t corner : t) out.point("    vertex", mesh.positions[corner]);
    out.text("  endloop\nendfacet\n");
  }
  out.text("endsolid proveout unit mm\n");
}

void writeObj(const TriMesh& mesh, Output& out) {
  out.text("# proveout, unit mm\n");
  for (const Eigen::Vector3f& p : mesh.positions) out.point("v", p);
  for (const auto& t : mesh.triangles) out.text(fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1));
}

void writePly(const TriMesh& mesh, Output& out) {
  const bool motion = !mesh.motion.empty();
  out.text(
      fmt::format("ply\nformat binary_little_endian 1.0\ncomment proveout, unit mm\n"
                  "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
                  "element face {}\nproperty list uchar int vertex_indices\n{}end_header\n",
                  mesh.positions.size(), mesh.triangles.size(), motion ? "property uint motion\n" : ""));
  for (const Eigen::Vector3f& p : mesh.positions) {
    for (int i = 0; i < 3; ++i) out.real32(p[i]);
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    out.byte(3);
    for (const std::uint32_t corner : mesh.triangles[i]) out.word32(corner);
    if (motion) out.word32(mesh.motion[i]);
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

}  // namespace

Status writeMesh(const TriMesh& mesh, const std::string& path, MeshFormat format) {
  const std::string wrong = defect(mesh);
  if (!wrong.empty()) return Error{ErrorKind::kInternal, path + ": the mesh " + wrong};
  Result<AtomicFile> file = AtomicFile::create(path);
  if (!file) return file.error();
  Output out(*file);
  switch (format) {
    case MeshFormat::kStlBinary:
      writeStlBinary(mesh, out);
      break;
    case MeshFormat::kStlAscii:
      writeStlAscii(mesh, out);
      break;
    case MeshFormat::kObj:
      writeObj(mesh, out);
      break;
    case MeshFormat::kPly:
      writePly(mesh, out);
      break;
  }
  out.flush();
  return file->commit();
}

}  // namespace proveout
