#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>

#include "core/base/assert.h"
#include "core/base/printable.h"
#include "io/exchange/deviation_mesh.h"
#include "io/exchange/hashed_file.h"

namespace proveout {
namespace {

constexpr std::size_t kPlyPiece = std::size_t{1} << 20;

void putPlyWord(std::string& out, std::uint32_t word) {
  for (int shift = 0; shift < 32; shift += 8) out += static_cast<char>(word >> shift & 0xFF);
}

void putPlyFloat(std::string& out, float value) { putPlyWord(out, std::bit_cast<std::uint32_t>(value)); }
void putPlyInt(std::string& out, std::int64_t value) {
  const auto most = std::int64_t{std::numeric_limits<std::int32_t>::max()};
  putPlyWord(out, static_cast<std::uint32_t>(static_cast<std::int32_t>(std::clamp(value, -most, most))));
}

std::string plyHead(const DeviationMesh& mesh) {
  std::string head = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment proveout, unit mm\n"
      "comment deviation from nominal in mm, positive: material left over; allowed -{:g} to {:g}\n"
      "comment colours saturate at {:g} mm\n",
      mesh.gouge_mm, mesh.excess_mm, mesh.limit_mm);
  for (std::size_t k = 0; k < mesh.files.size(); ++k)
    head += fmt::format("comment file {} {}\n", k, printable(mesh.files[k]));
  for (std::size_t k = 0; k < mesh.setups.size(); ++k) {
    if (!mesh.setups[k].empty()) head += fmt::format("comment setup {} {}\n", k, printable(mesh.setups[k]));
  }
  head += fmt::format(
      "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float deviation\n",
      mesh.positions.size());
  if (!mesh.made_by.empty())
    head +=
        "property int line\nproperty int block\nproperty int file\nproperty int tool\nproperty int setup\n";
  return head + fmt::format("element face {}\nproperty list uchar int vertex_indices\nend_header\n",
                            mesh.triangles.size());
}

void putPlyVertex(const DeviationMesh& mesh, std::size_t i, std::string& out) {
  for (int axis = 0; axis < 3; ++axis) putPlyFloat(out, mesh.positions[i][axis]);
  for (const std::uint8_t share : mesh.colours[i]) out += static_cast<char>(share);
  putPlyFloat(out, mesh.deviation[i]);
  if (mesh.made_by.empty()) return;
  const SurfaceBlock& by = mesh.blocks[mesh.made_by[i]];
  for (const std::int64_t value : {std::int64_t{by.line}, by.block, std::int64_t{by.file},
                                   std::int64_t{by.tool}, std::int64_t{by.setup}})
    putPlyInt(out, value);
}

}  // namespace

Result<std::string> writeDeviationPly(const DeviationMesh& mesh, const std::string& path) {
  PROVEOUT_ASSERT(mesh.deviation.size() == mesh.positions.size());
  PROVEOUT_ASSERT(mesh.colours.size() == mesh.positions.size());
  PROVEOUT_ASSERT(mesh.made_by.empty() || mesh.made_by.size() == mesh.positions.size());
  Result<HashedFile> file = HashedFile::create(path);
  if (!file) return file.error();
  std::string piece = plyHead(mesh);
  const auto spill = [&](std::size_t most) {
    if (piece.size() <= most) return;
    file->write(piece);
    piece.clear();
  };
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    putPlyVertex(mesh, i, piece);
    spill(kPlyPiece);
  }
  for (const auto& t : mesh.triangles) {
    piece += '\3';
    for (const std::uint32_t corner : t) putPlyWord(piece, corner);
    spill(kPlyPiece);
  }
  spill(0);
  return file->commit();
}

}  // namespace proveout
