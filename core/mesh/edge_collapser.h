// Takes vertices out of a mesh by collapsing edges, within a distance.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
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
  /// `mesh` must outlive this. Vertices with a flag in `frozen` stay; empty: none has one. `off`: by vertex,
  /// how far triangles there are off already, mm; empty: none is.
  EdgeCollapser(const TriMesh& mesh, double tolerance, std::span<const std::uint8_t> frozen,
                std::span<const float> off);

  /// False: cancelled.
  bool run(const Progress& progress);
  TriMesh result() const;
  double distance() const;

 private:
  /// Where a vertex may go: anywhere, along the border of two motions, nowhere.
  enum class Freedom : std::uint8_t { kFree, kBorder, kNone };
  struct VertexState {
    float needs = 0.0f;       ///< limit under which it is worth to try again, mm
    std::uint32_t swept = 0;  ///< the last sweep that changed a triangle there
    float drift = 0.0f;       ///< of the borders there, mm
    float next_drift = 0.0f;  ///< the same if the vertex went; 0: not known
    Freedom freedom = Freedom::kNone;
    bool inside = false;  ///< of a block of this round
    bool listed = false;  ///< among those that the block looks at in this sweep or the next

    bool isWorth(float limit) const { return needs <= limit && next_drift <= limit; }
  };
  static constexpr int kMostTries = 3;
  /// Neighbours that a vertex may be joined with; what seems cheapest first.
  struct Ways {
    std::array<int, kMostTries> to{};
    std::array<double, kMostTries> rank{};
    int count = 0;
    float drift = 0.0f;  ///< of the border, if the vertex goes

    void add(int j, double rank_of_it);
  };
  using Block = std::vector<std::uint32_t>;

  void findNormals(std::span<const float> off);
  void findFreedoms(std::span<const std::uint8_t> frozen);
  std::vector<Block> blocks(double size);
  std::vector<std::uint32_t> blockNumbers(double size) const;
  void simplifyBlock(Block vertices, std::uint32_t round);
  void sweepBlock(Block& todo, float limit, std::uint32_t sweep);
  void tryVertex(std::uint32_t v, float limit, std::uint32_t sweep, Block& again);
  bool findWays(const VertexStar& star, std::uint32_t v, float limit, Ways& ways);
  bool followBorder(const VertexStar& star, std::uint32_t v, float limit, Ways& ways);
  bool staysManifold(const VertexStar& star, int to) const;
  bool foldsOver(const VertexStar& star, int to, const VertexStar::Change& change) const;
  void collapse(const VertexStar& star, int to, const VertexStar::Change& change, std::uint32_t sweep,
                Block& again);

  const TriMesh& mesh_;
  const double tolerance_;
  CornerTable table_;  ///< its labels are the motions
  std::unique_ptr<TriangleState[]> triangles_;
  std::vector<VertexState> vertices_;
  std::vector<std::uint32_t> movable_;  ///< vertices that may go
  StarSurroundings around_;
};

}  // namespace proveout
