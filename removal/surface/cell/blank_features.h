// Points on the faces, feature edges and corners of a blank, near a patch of a mesh of it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/tri_mesh.h"
#include "removal/grid/blank_field.h"

namespace proveout {

class BlankFeatures {
 public:
  /// `cell_mm`: the grid spacing; points are found up to two cells away, to a thousandth of one. All must
  /// outlive this.
  BlankFeatures(const TriMesh& mesh, const BlankField& field, double cell_mm)
      : mesh_(mesh), field_(field), h_(cell_mm) {}

  /// Points (mm) near `m` on the faces at these triangles of the mesh, and on sliver faces between them.
  std::vector<Vec3> near(const Vec3& m, std::span<const std::uint32_t> patch) const;

 private:
  double off(const Vec3& p) const;
  std::vector<std::uint64_t> facesOf(std::span<const std::uint32_t> triangles) const;
  bool meet(std::span<const std::uint64_t> faces, const Vec3& m, Vec3& x) const;
  Vec3 surfaceBetween(const Vec3& m, const Vec3& x) const;
  void addSliverFaces(const Vec3& m, std::vector<std::uint64_t>& faces) const;

  const TriMesh& mesh_;
  const BlankField& field_;
  double h_;
};

}  // namespace proveout
