// Which passes reach into the stacks of leaves of a grid, leaves that stand above each other. The grid's area
// is quartered down to single stacks, each square with its list of passes; a list lives only as long as its
// square is worked on, so that no path is ever listed whole for all of the grid.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "removal/cut/pass.h"
#include "removal/grid/stock_impl.h"

namespace proveout {

/// A pass that reaches into a stack of leaves.
struct StackReach {
  std::uint32_t pass;
  float low;      ///< height below which it does not reach there, mm (a lower bound)
  float high;     ///< height above which it does not reach there, mm (an upper bound)
  float covered;  ///< height up to which the turn below it (Pass::lower) covers all that it does, mm (a lower
                  ///< bound)

  /// Whether it counts for what lies between two heights. `bottom` < `top`.
  bool counts(double bottom, double top) const { return low < top && high > bottom && covered < top; }
};
using StackList = std::vector<StackReach>;

/// Those of `list` that count between two heights, mm, into `out`.
void reachesBetween(const StackList& list, double bottom, double top, ReachList& out);

/// The stacks of leaves that a blank stands in, each with the height below which passes are asked for.
class LeafStacks {
 public:
  static constexpr float kNone = -std::numeric_limits<float>::infinity();

  /// `height`: of all stacks, mm; kNone: their passes are not asked for.
  LeafStacks(const Stock::Impl& impl, float height);

  /// Of leaves as Coord: the first and, in each direction, one behind the last.
  const Coord& low() const { return low_; }
  const Coord& end() const { return end_; }
  std::size_t count() const { return levels_[0].size(); }
  /// Number of the stack at a place of the grid.
  std::size_t number(const Coord& at) const {
    return static_cast<std::size_t>((at.y() - low_.y()) >> 3) * width_[0] +
           static_cast<std::size_t>((at.x() - low_.x()) >> 3);
  }
  /// Raises the height of a stack, mm.
  void raise(std::size_t stack, float height) { levels_[0][stack] = std::max(levels_[0][stack], height); }

  /// Calls body(origin, list) for each stack whose height is not kNone: `origin` is its lowest leaf, `list`
  /// the passes that reach below its height, in the order of the table. From many threads; stops early when
  /// `stopped` tells so.
  using Body = std::function<void(const Coord& origin, const StackList& list)>;
  void visit(const PassTable& table, const std::function<bool()>& stopped, const Body& body);

 private:
  struct Visit;
  void spread();
  float heightOf(int level, int x, int y) const;
  void quarter(Visit& visit, int level, int x, int y, const StackList& list) const;
  FourBlocks blocksOf(int level, int x, int y) const;
  const Stock::Impl& impl_;
  Coord low_, end_;
  std::vector<std::vector<float>> levels_;  ///< heights of squares of 2^level stacks each way
  std::vector<std::size_t> width_;          ///< of each level along x
};

}  // namespace proveout
