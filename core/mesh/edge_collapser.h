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
  /// Where a vertex may go: anywhere, along the border of two motions, nowhere; told by the first look at it.
  enum class Freedom : std::uint8_t { kUnknown, kFree, kBorder, kNone };
  /// Whether a vertex has all its neighbours in its block; told by the first look in a round.
  enum class Place : std::uint8_t { kUnknown, kInside, kOutside };
  struct VertexState {
    float needs = 0.0f;       ///< limit under which it is worth to try again, mm
    float drift = 0.0f;       ///< of the borders there, mm
    float next_drift = 0.0f;  ///< the same if the vertex went; 0: not known
    std::uint32_t swept = 0;  ///< the last sweep that changed a triangle there
    Freedom freedom = Freedom::kUnknown;
    Place place = Place::kUnknown;
    bool listed = false;  ///< among those that the block looks at in this sweep or the next
    bool kept = false;    ///< among those that the block looks at in the passes of this round

    bool isWorth(float limit) const {
      return needs <= limit && next_drift <= limit && freedom != Freedom::kNone && place != Place::kOutside;
    }
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
  /// What one thread works on in a round.
  struct Sweeps {
    Block vertices;          ///< that may be worth a look in a later pass
    std::size_t sorted = 0;  ///< so many of them are in the order of their numbers
    Block todo, again;       ///< of this sweep and of the next
    float limit = 0.0f;      ///< by which a collapse may move the surface in this pass, mm
    std::uint32_t sweep = 0;
  };

  void findNormals(std::span<const float> off);
  void holdFolds();
  bool isFolded(std::uint32_t t) const;
  std::vector<Block> blocks(double size);
  void findCells(double size);
  void simplifyBlock(Block vertices, std::uint32_t round);
  void startPass(Sweeps& sweeps, double part);
  void sweepBlock(Sweeps& sweeps);
  bool mayGo(const VertexStar& star, std::uint32_t v);
  bool isInside(const VertexStar& star, std::uint32_t v) const;
  void tryVertex(std::uint32_t v, Sweeps& sweeps);
  bool findWays(const VertexStar& star, std::uint32_t v, float limit, Ways& ways);
  bool followBorder(const VertexStar& star, std::uint32_t v, float limit, Ways& ways);
  bool staysManifold(const VertexStar& star, int to) const;
  bool foldsOver(const VertexStar& star, int to, const VertexStar::Change& change) const;
  void collapse(const VertexStar& star, int to, const VertexStar::Change& change, Sweeps& sweeps);

  const TriMesh& mesh_;
  const double tolerance_;
  CornerTable table_;  ///< its labels are the motions
  std::unique_ptr<TriangleState[]> triangles_;
  std::vector<VertexState> vertices_;
  std::vector<std::uint32_t> movable_;  ///< vertices that may go, in order
  std::vector<std::uint32_t> cells_;    ///< by vertex: its block; empty: all is one
  StarSurroundings around_;
};

}  // namespace proveout
