#include "removal/cut/thin_walls.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace proveout {

namespace {

/// Every fourth edge into the next leaf.
constexpr std::uint64_t kSomeY = 0x2222222222222222, kSomeX = 0x0000FF000000FF00;
/// And that in every other leaf, like the black squares of a chess board.
constexpr int kSomeWeight = 8;
bool isAsked(const Coord& origin) { return ((origin.x() ^ origin.y() ^ origin.z()) & 8) == 0; }

/// Points that an edge is asked at: thinner walls are not spoken of.
constexpr int kPoints = LostFilm::kParts;
constexpr std::size_t kBatch = kMaxColumns / 2;

/// Bits whose neighbour towards -y or +y, -x or +x is set.
std::uint64_t besideY(std::uint64_t w) {
  return (w << 1 & 0xFEFEFEFEFEFEFEFE) | (w >> 1 & 0x7F7F7F7F7F7F7F7F);
}
std::uint64_t besideX(std::uint64_t w) { return w << 8 | w >> 8; }

/// Edges along the axis that lie beside one whose ends are both in the material, as far as the leaf tells.
LeafBits besideHeld(int axis, const LeafBits& material, const LeafBits& crossed) {
  LeafBits held, out;
  for (int z = 0; z < 8; ++z) held[z] = material[z] & ~crossed[z];
  for (int z = 0; z < 8; ++z) {
    out[z] = (axis != 0 ? besideX(held[z]) : 0) | (axis != 1 ? besideY(held[z]) : 0);
    if (axis != 2 && z > 0) out[z] |= held[z - 1];
    if (axis != 2 && z < 7) out[z] |= held[z + 1];
  }
  return out;
}

}  // namespace

LostFilm ThinWallFinder::find(const LeafChange& change, const LeafEdges& edges, const OpenEdges* open,
                              std::span<const Reach> list) {
  LostFilm lost;
  collect(change, edges, open);
  if (!stacks_.empty()) unitePieces(table_, list, list_);
  for (std::size_t first = 0; first < stacks_.size(); first += kBatch) {
    drop(first, std::min(kBatch, stacks_.size() - first));
  }
  for (const Stack& stack : stacks_) {
    if (stack.open != 0) askPoints(stack, lost);
  }
  return lost;
}

bool ThinWallFinder::mayFind(const LeafChange& change, const LeafEdges& edges, const OpenEdges* open) {
  collect(change, edges, open);
  list_.clear();
  for (std::size_t first = 0; first < stacks_.size(); first += kBatch) {
    drop(first, std::min(kBatch, stacks_.size() - first));
  }
  return std::any_of(stacks_.begin(), stacks_.end(), [](const Stack& stack) { return stack.open != 0; });
}

void ThinWallFinder::collect(const LeafChange& change, const LeafEdges& edges, const OpenEdges* open) {
  stacks_.clear();
  LeafBits taken = samplesBefore(change);
  std::uint64_t any = 0;
  for (int z = 0; z < 8; ++z) any |= taken[z] &= ~change.material[z];
  if (any == 0) return;
  origin_ = change.origin;
  takers_ = change.takers;
  for (int z = 0; z < 9; ++z) z_[z] = impl_.position(origin_.offsetBy(0, 0, z)).z();
  for (int axis = 0; axis < (open != nullptr && open->undercut ? 3 : 2); ++axis) {
    const LeafBits beside = besideHeld(axis, change.material, edges.crossed[axis]);
    std::array<std::uint8_t, 64> columns{};
    std::uint64_t some = 0;
    for (int z = 0; z < 8; ++z) {
      // Neither crossed before nor now: both ends were material, and both are gone.
      std::uint64_t left = taken[z] & ~(change.before.crossed[axis][z] | edges.crossed[axis][z]) & ~beside[z];
      const std::uint64_t last = !isAsked(origin_) ? 0 : axis == 0 ? kColumnX7 & kSomeY : kColumnY7 & kSomeX;
      if (axis < 2) left &= last | (open != nullptr ? open->level[axis][z] : 0);
      if (axis == 2) left &= open->upright[z];
      some |= left;
      for (; left != 0; left &= left - 1)
        columns[std::countr_zero(left)] |= static_cast<std::uint8_t>(1u << z);
    }
    for (; some != 0; some &= some - 1) {
      const int bit = std::countr_zero(some), x = bit >> 3, y = bit & 7;
      const bool leads_on = axis == 0 ? x == 7 : axis == 1 && y == 7;
      Stack stack{static_cast<std::int8_t>(axis), static_cast<std::int8_t>(x), static_cast<std::int8_t>(y),
                  columns[bit], static_cast<std::uint8_t>(leads_on ? kSomeWeight : 1)};
      for (int z = 0; z < 8; ++z) {
        if ((stack.open >> z & 1) != 0 && besideMaterial(origin_, axis, x, y, z)) {
          stack.open &= static_cast<std::uint8_t>(~(1u << z));
        }
      }
      if (stack.open != 0) stacks_.push_back(stack);
    }
  }
}

/// The part of besideHeld that lies in other leaves.
bool ThinWallFinder::besideMaterial(const Coord& origin, int axis, int x, int y, int z) const {
  const std::array<int, 3> place{x, y, z};
  for (int other = 0; other < 3; ++other) {
    if (other == axis || (place[other] != 0 && place[other] != 7)) continue;
    Coord at = origin.offsetBy(x, y, z);
    at[other] += place[other] == 0 ? -1 : 1;
    if (!reader_.isMaterial(at)) continue;
    ++at[axis];
    if (reader_.isMaterial(at)) return true;
  }
  return false;
}

bool ThinWallFinder::holdsEdges(const Pass& pass) const {
  if (pass.body.isConvex()) return true;
  const Vec3 low = impl_.position(origin_), high = impl_.position(origin_.offsetBy(8, 8, 8));
  return pass.body.holdsEdges(impl_.h, 0.5 * (low + high).head<2>(), 6.0 * impl_.h);
}

/// Takes out what one pass covers whole: first those that took much. Passes in the middle of the list are
/// likely to be those right over the leaf.
void ThinWallFinder::drop(std::size_t first, std::size_t count) {
  double highest = z_[0], lowest = z_[8];
  for (std::size_t i = 0; i < count; ++i) {
    const Stack& stack = stacks_[first + i];
    const Vec3 a = start(stack);
    x_[2 * i] = x_[2 * i + 1] = a.x();
    y_[2 * i] = y_[2 * i + 1] = a.y();
    if (stack.axis == 0) x_[2 * i + 1] += impl_.h;
    if (stack.axis == 1) y_[2 * i + 1] += impl_.h;
    highest = std::max(highest, z_[std::bit_width(stack.open) - 1]);
    lowest = std::min(lowest, z_[std::countr_zero(stack.open)]);
  }
  for (const std::uint32_t taker : takers_) {
    if (taker == kNoPass || !holdsEdges(table_.passes[taker])) continue;
    if (!dropCovered(table_.passes[taker], first, count)) return;
  }
  const std::size_t size = list_.size();
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t step = (i + 1) / 2, middle = size / 2;
    const Reach& reach = list_[i % 2 == 1 ? middle - step : middle + step];
    if (reach.low >= highest) continue;
    if (reach.high <= lowest) continue;
    const Pass& pass = table_.passes[reach.pass];
    if (holdsEdges(pass) && !dropCovered(pass, first, count)) return;
  }
}

/// Puts the stacks that are open to the front, in their order, and makes their number `count`; false for 0.
bool ThinWallFinder::keepOpen(std::size_t first, std::size_t& count) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (stacks_[first + i].open == 0) continue;
    std::swap(stacks_[first + kept], stacks_[first + i]);
    for (const std::size_t end : {0, 1}) {
      x_[2 * kept + end] = x_[2 * i + end];
      y_[2 * kept + end] = y_[2 * i + end];
    }
    ++kept;
  }
  count = kept;
  return count > 0;
}

/// False when nothing is open any more.
bool ThinWallFinder::dropCovered(const Pass& pass, std::size_t first, std::size_t& count) {
  if (pass.body.isAskedWhole()) return dropHeld(pass.body, first, count);
  pass.body.columns(x_.data(), y_.data(), static_cast<int>(2 * count), lo_.data(), hi_.data());
  for (std::size_t i = 0; i < count; ++i) {
    Stack& stack = stacks_[first + i];
    const double lo = std::max(lo_[2 * i], lo_[2 * i + 1]), hi = std::min(hi_[2 * i], hi_[2 * i + 1]);
    const int up = stack.axis == 2 ? 1 : 0;
    for (unsigned left = lo < hi ? stack.open : 0u; left != 0; left &= left - 1) {
      const int z = std::countr_zero(left);
      if (lo < z_[z] && z_[z + up] < hi) stack.open &= static_cast<std::uint8_t>(~(1u << z));
    }
  }
  return keepOpen(first, count);
}

/// The same for a body that is asked whole: edges that the tool holds at one place of its way.
bool ThinWallFinder::dropHeld(const SweptBody& body, std::size_t first, std::size_t& count) {
  for (std::size_t i = 0; i < count; ++i) {
    Stack& stack = stacks_[first + i];
    for (unsigned left = stack.open; left != 0; left &= left - 1) {
      const int z = std::countr_zero(left);
      const Vec3 a(x_[2 * i], y_[2 * i], z_[z]),
          b(x_[2 * i + 1], y_[2 * i + 1], z_[z + (stack.axis == 2 ? 1 : 0)]);
      if (body.holds(a, b)) stack.open &= static_cast<std::uint8_t>(~(1u << z));
    }
  }
  return keepOpen(first, count);
}

Vec3 ThinWallFinder::start(const Stack& stack) const {
  return impl_.position(origin_.offsetBy(stack.x, stack.y, 0));
}

void ThinWallFinder::askPoints(const Stack& stack, LostFilm& lost) {
  const Vec3 a = start(stack);
  const auto along = [&](int i) { return (i + 0.5) / kPoints * impl_.h; };
  const int columns = stack.axis == 2 ? 1 : kPoints;
  for (int i = 0; i < columns; ++i) {
    x_[i] = a.x() + (stack.axis == 0 ? along(i) : 0.0);
    y_[i] = a.y() + (stack.axis == 1 ? along(i) : 0.0);
  }
  std::array<std::uint64_t, 8> bare{};  // points that no pass covers
  for (int z = 0; z < 8; ++z) bare[z] = (stack.open >> z & 1) != 0 ? (1ull << kPoints) - 1 : 0;
  const double lowest = z_[std::countr_zero(stack.open)],
               highest = z_[std::bit_width(stack.open) - 1] + (stack.axis == 2 ? impl_.h : 0.0);
  for (const Reach& reach : list_) {
    if (reach.low >= highest || reach.high <= lowest) continue;
    const Pass& pass = table_.passes[reach.pass];
    const bool whole = pass.body.isAskedWhole();
    if (!whole) pass.body.columns(x_.data(), y_.data(), columns, lo_.data(), hi_.data());
    for (int z = 0; z < 8; ++z) {
      for (std::uint64_t left = bare[z]; left != 0; left &= left - 1) {
        const int i = std::countr_zero(left), column = stack.axis == 2 ? 0 : i;
        const double at = z_[z] + (stack.axis == 2 ? along(i) : 0.0);
        const bool covered =
            whole ? pass.body.covers({x_[column], y_[column], at}) : lo_[column] < at && at < hi_[column];
        if (covered) bare[z] &= ~(1ull << i);
      }
    }
  }
  for (int z = 0; z < 8; ++z) {
    if (bare[z] == 0) continue;
    if (lost.edges == 0) {
      lost.where = Vec3(a.x(), a.y(), z_[z]);
      lost.where[stack.axis] += along(std::countr_zero(bare[z]));
    }
    lost.edges += stack.weight;
    lost.parts += stack.weight * std::popcount(bare[z]);
  }
}

}  // namespace proveout
