// A triangle mesh as a GLB file: glTF 2.0 (ISO/IEC 12113), binary form, one file.
//
// glTF is in metres with +Y up. Meshes here are in mm with +Z up: the values of the file are the mesh's own,
// bit for bit, and the node above the mesh carries the matrix that turns and scales them.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/mesh/tri_mesh.h"
#include "io/exchange/hashed_file.h"

namespace proveout {

enum class GlbNumber : std::uint16_t { kUnsignedShort = 5123, kUnsignedInt = 5125, kFloat = 5126 };

/// A table of numbers in the file: a row for each vertex, or the corners of the triangles.
struct GlbArray {
  std::string attribute;  ///< "POSITION"; application's own begin with '_'; empty: corners of triangles
  GlbNumber number = GlbNumber::kFloat;
  int columns = 1;          ///< 1, 3 or 4; a row takes a multiple of 4 bytes but where these are corners
  bool normalized = false;  ///< whole numbers stand for 0..1
  std::size_t rows = 0;
  std::vector<double> min = {}, max = {};  ///< of each column; empty: not told
  /// Appends rows from `first` to before `last`, little endian.
  std::function<void(std::size_t first, std::size_t last, std::string& out)> append;
};

struct GlbModel {
  std::string name;                  ///< of node and mesh; any text
  std::vector<GlbArray> attributes;  ///< POSITION among them
  GlbArray corners;                  ///< of the triangles
  std::string extras;                ///< JSON object with what readers may want to know; empty: nothing
  std::array<float, 3> colour = {1, 1, 1};  ///< of the material, linear, 0..1; times COLOR_0
};

/// POSITION of these points, mm, with its bounds; `positions` must outlive it and be finite.
GlbArray glbPositions(const std::vector<Eigen::Vector3f>& positions);
/// The same for any other vectors ("NORMAL").
GlbArray glbVectors(std::string attribute, const std::vector<Eigen::Vector3f>& rows);
/// Corners of these triangles; `triangles` must outlive it.
GlbArray glbCorners(const std::vector<std::array<std::uint32_t, 3>>& triangles);

/// Writes the model, whole file or none; the SHA-256 of its bytes. A model without triangles is a file with
/// an empty scene. Errors: more than the 4 GiB that the format counts, and those of AtomicFile.
Result<std::string> writeGlb(const GlbModel& model, const std::string& path);

/// The part alone: positions and triangles. Without normals, so that viewers show its facets and edges as
/// they are.
Result<std::string> writePartGlb(const TriMesh& mesh, const std::string& path);

}  // namespace proveout
