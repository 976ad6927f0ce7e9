// Writes the planned quads as a mesh, and again where the plan changed.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "removal/surface/mesh/leaf_mesh.h"
#include "removal/surface/mesh/leaf_quads.h"

namespace proveout {

class MeshWriter {
 public:
  /// Both must outlive this.
  MeshWriter(const SurfaceGrid& grid, const VertexMerger& merger);

  /// Writes the mesh with what is merged now. `changed`: leaves whose quads or merged cells differ from the
  /// previous call; all of them at the first call. The rest is copied from the mesh written before. Null if
  /// cancelled. The fans must live as long as the mesh, which the next call but one overwrites.
  LeafMesh* write(const std::vector<LeafQuads>& quads, const std::vector<std::uint8_t>& changed,
                  Progress& progress);

 private:
  void layOut(const std::vector<LeafQuads>& quads, const std::vector<std::uint8_t>& changed);
  std::uint32_t keptCells(const SurfaceLeaf& leaf) const;
  void makeRoom(const std::vector<LeafQuads>& quads);
  void writeVertices(const SurfaceLeaf& leaf, std::size_t number, bool changed);
  void copyVertices(std::size_t number);
  void writeLeaf(const SurfaceLeaf& leaf, const LeafQuads& quads, std::size_t number);
  std::size_t writeQuad(const std::array<std::uint32_t, 4>& v, bool at02, bool leans, const Crossing& c,
                        std::size_t first, std::size_t next, std::vector<std::uint32_t>& poor);
  std::size_t writeMerged(const SurfaceLeaf& leaf, Quad& quad, const Crossing& c, std::size_t first,
                          std::size_t next, std::vector<std::uint32_t>& poor);
  void copyLeaf(std::size_t number);
  void writeFans(const std::vector<LeafQuads>& quads);

  const SurfaceGrid& grid_;
  const VertexMerger& merger_;
  LeafMesh now_;
  LeafMesh before_;  ///< of the previous call; its memory serves the next one
};

}  // namespace proveout
