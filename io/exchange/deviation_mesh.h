// The machined part with its deviation from nominal and the block that made it, vertex by vertex, as files
// for other programs.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/mesh/tri_mesh.h"

namespace proveout {

/// The block of a program that made a piece of surface.
struct SurfaceBlock {
  std::int32_t setup = -1;  ///< index into DeviationMesh::setups; -1: the blank's own surface
  std::int32_t tool = -1;   ///< number; -1: none
  std::int32_t file = -1;   ///< index into DeviationMesh::files; -1: none
  std::int32_t line = -1;   ///< from 1; -1: none
  std::int64_t block = -1;  ///< N number, or -1
};

struct DeviationMesh {
  std::vector<Eigen::Vector3f> positions;               ///< mm, workpiece frame of the last clamping
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< CCW seen from outside
  /// Per vertex, mm: positive where material is left over, negative where it is missing; NaN: not compared.
  std::vector<float> deviation;
  std::vector<std::array<std::uint8_t, 3>> colours;  ///< per vertex, sRGB
  std::vector<std::uint32_t> made_by;  ///< per vertex: index into `blocks`; empty: no program is known
  std::vector<SurfaceBlock> blocks;
  std::vector<std::string> files, setups;  ///< names; a job without setups has one with an empty name
  double gouge_mm = 0.0, excess_mm = 0.0;  ///< tolerances
  double limit_mm = 0.0;                   ///< where the colours saturate
};

/// PLY, binary little endian. Of each vertex x, y, z (float, mm), red, green, blue (uchar), deviation (float,
/// mm), and where blocks are known line, block, file, tool, setup (int; -1: none). What the numbers of files
/// and setups mean stands in comments. Whole file or none; the SHA-256 of its bytes.
Result<std::string> writeDeviationPly(const DeviationMesh& mesh, const std::string& path);

/// Vertices for flat edges: one for each vertex and normal that a shader needs.
struct ShadedVertices {
  std::vector<std::uint32_t> vertex;                    ///< of the mesh
  std::vector<Eigen::Vector3f> normals;                 ///< unit, outward
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices into these
};

/// GLB as of io/exchange/glb_model.h. Attributes POSITION, NORMAL, COLOR_0 (linear) and, as floats,
/// _DEVIATION (mm), and where blocks are known _LINE, _BLOCK, _FILE, _TOOL, _SETUP. Since glTF has no NaN,
/// vertices that were not compared have deviation 0, and _MEASURED, which is there only then, tells them
/// (0; else 1). Names of files and setups and the tolerances stand in the mesh's `extras`.
Result<std::string> writeDeviationGlb(const DeviationMesh& mesh, const ShadedVertices& shaded,
                                      const std::string& path);

}  // namespace proveout
