// Walls that the passes of one run leave standing between each other and that no sample lies in.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "removal/cut/leaf_crossings.h"
#include "removal/cut/leaf_cutter.h"

namespace proveout {

/// Finds thin walls; one object a thread, used again and again.
///
/// An edge between two samples that the run took lies in any pass that covers both (SweptBody::holdsEdges).
/// Where none does, and no material that the grid holds is beside the edge, it is asked point by point. For
/// level edges within a leaf the cutter knows most of the answer; of those that lead into the next leaf one
/// in eight stands for all.
class ThinWallFinder {
 public:
  ThinWallFinder(const Stock::Impl& impl, const PassTable& table)
      : impl_(impl), table_(table), reader_(impl) {}

  /// `edges`: those crossed now. `open`: may be null. The stock holds the new samples of all leaves.
  LostFilm find(const LeafChange& change, const LeafEdges& edges, const OpenEdges* open,
                std::span<const Reach> list);

  /// False where that would find nothing whatever the list: the passes that took most and last cover all.
  /// Much cheaper.
  bool mayFind(const LeafChange& change, const LeafEdges& edges, const OpenEdges* open);

 private:
  /// Edges that stand above each other, or one column of vertical edges.
  struct Stack {
    std::int8_t axis, x, y;
    std::uint8_t open;  ///< bit z: not known to be covered
    std::uint8_t weight;
  };

  void collect(const LeafChange& change, const LeafEdges& edges, const OpenEdges* open);
  bool besideMaterial(const Coord& origin, int axis, int x, int y, int z) const;
  void drop(std::size_t first, std::size_t count);
  bool holdsEdges(const Pass& pass) const;
  bool keepOpen(std::size_t first, std::size_t& count);
  bool dropCovered(const Pass& pass, std::size_t first, std::size_t& count);
  bool dropHeld(const SweptBody& body, std::size_t first, std::size_t& count);
  void askPoints(const Stack& stack, LostFilm& lost);
  Vec3 start(const Stack& stack) const;

  const Stock::Impl& impl_;
  const PassTable& table_;
  LeafReader reader_;
  Coord origin_;
  std::array<std::uint32_t, 2> takers_{};  ///< as in LeafChange
  std::array<double, 9> z_{};              ///< heights of the leaf's samples
  std::vector<Stack> stacks_;
  ReachList list_;  ///< see unitePieces
  std::array<double, kMaxColumns> x_{}, y_{}, lo_{}, hi_{};
};

}  // namespace proveout
