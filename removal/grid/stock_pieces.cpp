// The stock without pieces that have come loose.
#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "removal/grid/leaf_changes.h"
#include "removal/grid/stock_impl.h"

namespace proveout {
namespace {

/// By leaf, in leaf coordinates.
using Samples = std::map<Coord, LeafBits>;

/// Those of `own` that are joined with `seeds` along the axes.
LeafBits joined(LeafBits seeds, const LeafBits& own) {
  for (bool grows = true; grows;) {
    grows = false;
    for (int z = 0; z < 8; ++z) {
      std::uint64_t s = seeds[z];
      s |= s << 8 | s >> 8 | (s << 1 & ~kColumnY0) | (s >> 1 & ~kColumnY7);
      if (z > 0) s |= seeds[z - 1];
      if (z < 7) s |= seeds[z + 1];
      s &= own[z];
      grows = grows || s != seeds[z];
      seeds[z] = s;
    }
  }
  return seeds;
}

/// The samples beside the leaf's own in the neighbour a step along an axis.
LeafBits across(const LeafBits& from, int axis, int step) {
  LeafBits out{};
  if (axis == 2) {
    out[step > 0 ? 0 : 7] = from[step > 0 ? 7 : 0];
    return out;
  }
  const int shift = axis == 0 ? 56 : 7;
  const std::uint64_t last = axis == 0 ? kColumnX7 : kColumnY7, first = axis == 0 ? kColumnX0 : kColumnY0;
  for (int z = 0; z < 8; ++z) out[z] = step > 0 ? (from[z] & last) >> shift : (from[z] & first) << shift;
  return out;
}

/// Takes away the connected pieces of samples that lie within one of some boxes.
class PieceRemover {
 public:
  PieceRemover(Stock::Impl& stock, const std::vector<Box3>& loose, const Box3& kept)
      : stock_(stock), loose_(loose), kept_(kept) {}

  void run() {
    for (const StockLeaf& leaf : stock_.leaves) {
      const Coord at = leafCoord(leaf.origin);
      for (int z = 0; z < 8; ++z) {
        while (const std::uint64_t left = leaf.material()[z] & ~seenIn(at, z)) {
          LeafBits seed{};
          seed[z] = left & (~left + 1);
          const Samples piece = pieceOf(at, seed);
          if (isLoose(boundsOf(piece))) gone_.insert(piece.begin(), piece.end());
          for (const auto& [place, bits] : piece) {
            LeafBits& seen = seen_[place];
            for (int k = 0; k < 8; ++k) seen[k] |= bits[k];
          }
        }
      }
    }
    if (!gone_.empty()) commit();
  }

 private:
  std::uint64_t seenIn(const Coord& leaf, int z) const {
    const auto at = seen_.find(leaf);
    return at == seen_.end() ? 0 : at->second[z];
  }

  Samples pieceOf(const Coord& leaf, const LeafBits& seed) const {
    Samples piece, open{{leaf, seed}};
    while (!open.empty()) {
      const auto [at, seeds] = *open.begin();
      open.erase(open.begin());
      LeafBits& reached = piece[at];
      LeafBits start = reached;
      for (int z = 0; z < 8; ++z) start[z] |= seeds[z];
      const LeafBits now = joined(start, stock_.tree.bits(at));
      if (now == reached) continue;
      reached = now;
      for (int axis = 0; axis < 3; ++axis) {
        for (const int step : {-1, 1}) {
          const Coord next = at.offsetBy(axis == 0 ? step : 0, axis == 1 ? step : 0, axis == 2 ? step : 0);
          if (stock_.tree.holds(next)) addOpen(next, across(now, axis, step), piece, open);
        }
      }
    }
    return piece;
  }
  void addOpen(const Coord& leaf, const LeafBits& seeds, const Samples& piece, Samples& open) const {
    const LeafBits& own = stock_.tree.bits(leaf);
    const auto known = piece.find(leaf);
    LeafBits fresh{};
    bool any = false;
    for (int z = 0; z < 8; ++z) {
      fresh[z] = seeds[z] & own[z] & (known == piece.end() ? ~0ull : ~known->second[z]);
      any = any || fresh[z] != 0;
    }
    if (!any) return;
    LeafBits& all = open[leaf];
    for (int z = 0; z < 8; ++z) all[z] |= fresh[z];
  }

  /// Of the samples, mm.
  Box3 boundsOf(const Samples& piece) const {
    Box3 box;
    for (const auto& [leaf, bits] : piece) {
      for (int z = 0; z < 8; ++z) {
        for (std::uint64_t left = bits[z]; left != 0; left &= left - 1) {
          const int bit = std::countr_zero(left);
          box.extend(
              stock_.position(Coord(8 * leaf.x() + (bit >> 3), 8 * leaf.y() + (bit & 7), 8 * leaf.z() + z)));
        }
      }
    }
    return box;
  }

  /// It is of the smallest body that may hold it.
  bool isLoose(const Box3& piece) const {
    constexpr double kHair = 1e-2;
    const auto mayHold = [&](const Box3& body) {
      const Box3 wide = body.inflated(kHair * stock_.h);
      return (wide.min.array() <= piece.min.array()).all() && (wide.max.array() >= piece.max.array()).all();
    };
    double least = mayHold(kept_) ? kept_.size().prod() : std::numeric_limits<double>::infinity();
    bool loose = false;
    for (const Box3& body : loose_) {
      if (!mayHold(body) || body.size().prod() >= least) continue;
      least = body.size().prod();
      loose = true;
    }
    return loose;
  }

  void commit() {
    std::set<Coord> places;
    for (const auto& [leaf, bits] : gone_) {
      for (int n = 0; n < 8; ++n) {
        const Coord below = leaf.offsetBy(-(n & 1), -(n >> 1 & 1), -(n >> 2));
        if (stock_.tree.holds(below)) places.insert(below);
      }
    }
    std::vector<LeafChange> changes;
    const LeafReader reader(stock_);
    for (const Coord& place : places) {
      changes.push_back(readLeaf(reader, Coord(8 * place.x(), 8 * place.y(), 8 * place.z())));
      const auto gone = gone_.find(place);
      for (int z = 0; gone != gone_.end() && z < 8; ++z) changes.back().material[z] &= ~gone->second[z];
    }
    // What is left was crossed before: pieces are whole.
    commitChanges(stock_, addressesOf(changes),
                  [&](std::size_t i, const LeafEdges& edges, const std::vector<Crossing>& before) {
                    std::vector<Crossing> out;
                    out.reserve(edges.count);
                    forEachEdge(edges, [&](int axis, int x, int y, int z) {
                      const int index = changes[i].before.indexOf(axis, x, y, z);
                      out.push_back(before[static_cast<std::size_t>(index)]);
                    });
                    return out;
                  });
  }

  Stock::Impl& stock_;
  const std::vector<Box3>& loose_;
  Box3 kept_;
  Samples seen_, gone_;
};

}  // namespace

void Stock::dropPieces(const std::vector<Box3>& loose, const Box3& kept) {
  impl_->made_from.reset();
  impl_->dropped.insert(impl_->dropped.end(), loose.begin(), loose.end());
  PieceRemover(*impl_, loose, kept).run();
}

}  // namespace proveout
