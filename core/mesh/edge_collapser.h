// Takes vertices out of a mesh by collapsing edges, within a distance.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/corner_table.h"
#include "core/mesh/tri_mesh.h"
#include "core/mesh/vertex_star.h"

namespace proveout {

/// Collapses edges of one mesh.
class EdgeCollapser {
 public:
  /// `mesh` must outlive this. Vertices with a flag in `frozen` stay; empty: none has one.
  EdgeCollapser(const TriMesh& mesh, double tolerance, std::span<const std::uint8_t> frozen);

  /// False: cancelled.
  bool run(const Progress& progress);
  TriMesh result() const;
  double distance() const;

 private:
  /// Where a vertex may go: anywhere, along the border of two motions, nowhere.
  enum class Freedom : std::uint8_t { kFree, kBorder, kNone };
  /// A neighbour that a vertex may be joined with; what seems cheapest first.
  struct Way {
    double rank;
    int to;
    bool operator<(const Way& o) const { return rank != o.rank ? rank < o.rank : to < o.to; }
  };
  struct Ways {
    std::array<Way, VertexStar::kMost> all;
    int count = 0;
    std::array<std::uint32_t, 2> border{};  ///< neighbours along it
    float drift = 0.0f;                     ///< of the border, if the vertex goes
  };

  std::uint32_t motionOf(std::uint32_t t) const { return mesh_.motion.empty() ? kNoBorder : mesh_.motion[t]; }
  void findFreedoms(std::span<const std::uint8_t> frozen);
  void findBlocks(double size);
  std::vector<std::uint32_t> candidates() const;
  void simplifyBlocks(double size, std::uint32_t round);
  void simplifyBlock(std::vector<std::uint32_t> vertices, std::uint32_t round);
  bool tryVertex(std::uint32_t v, float limit, std::uint32_t sweep);
  bool findWays(const VertexStar& star, std::uint32_t v, float limit, Ways& ways);
  bool followBorder(std::uint32_t v, float limit, Ways& ways);
  bool staysManifold(const VertexStar& star, int to) const;
  bool foldsOver(const VertexStar& star, int to, const VertexStar::Change& change) const;
  void collapse(const VertexStar& star, int to, const VertexStar::Change& change, std::uint32_t sweep);

  static constexpr std::uint32_t kNoBorder = 0;
  const TriMesh& mesh_;
  const double tolerance_;
  CornerTable table_;
  std::vector<Eigen::Vector3f> normals_;  ///< of the triangles
  std::vector<float> error_;              ///< of the triangles, mm
  std::vector<float> drift_;              ///< vertices: of the borders there, mm
  std::vector<float> needs_;              ///< vertices: limit under which it is worth to try again, mm
  std::vector<Freedom> freedom_;
  std::vector<std::uint32_t> block_;  ///< of the vertices
  std::vector<std::uint32_t> swept_;  ///< vertices: the last sweep that changed a triangle there
  StarSurroundings around_;
};

}  // namespace proveout
