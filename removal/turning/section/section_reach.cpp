#include "removal/turning/section/section_reach.h"

#include <algorithm>
#include <limits>

namespace proveout::section_detail {

namespace {

/// Units; where edges are cut coordinates are rounded.
constexpr cInt kSlack = 4;

class Box {
 public:
  void extend(const IntPoint& p) {
    low_ = {std::min(low_.X, p.X), std::min(low_.Y, p.Y)};
    high_ = {std::max(high_.X, p.X), std::max(high_.Y, p.Y)};
  }
  bool empty() const { return low_.X > high_.X; }
  const IntPoint& low() const { return low_; }
  const IntPoint& high() const { return high_; }
  bool holds(const IntPoint& p) const {
    return p.X >= low_.X && p.X <= high_.X && p.Y >= low_.Y && p.Y <= high_.Y;
  }
  /// Both beyond the same side.
  bool misses(const IntPoint& a, const IntPoint& b) const {
    return (a.X < low_.X && b.X < low_.X) || (a.X > high_.X && b.X > high_.X) ||
           (a.Y < low_.Y && b.Y < low_.Y) || (a.Y > high_.Y && b.Y > high_.Y);
  }

 private:
  IntPoint low_{std::numeric_limits<cInt>::max(), std::numeric_limits<cInt>::max()};
  IntPoint high_{std::numeric_limits<cInt>::min(), std::numeric_limits<cInt>::min()};
};

/// A side of a polygon.
struct Side {
  IntPoint a, b;
  bool between(cInt low, cInt high) const { return std::max(a.Y, b.Y) >= low && std::min(a.Y, b.Y) <= high; }
};

std::vector<Side> sidesOf(const ClipperLib::Path& polygon) {
  std::vector<Side> sides;
  sides.reserve(polygon.size());
  for (std::size_t i = 0; i < polygon.size(); ++i)
    sides.push_back({polygon[i > 0 ? i - 1 : polygon.size() - 1], polygon[i]});
  return sides;
}

/// Bounds of a polygon between two levels of Y, up to kSlack. `sides`: at least those that come there.
Box strip(const std::vector<Side>& sides, cInt low, cInt high) {
  Box box;
  for (const Side& side : sides) {
    if (!side.between(low, high)) continue;
    const IntPoint &a = side.a, &b = side.b;
    const double slope = a.Y == b.Y ? 0.0 : static_cast<double>(b.X - a.X) / static_cast<double>(b.Y - a.Y);
    for (const IntPoint& end : {a, b}) {
      const cInt y = std::clamp(end.Y, low, high);
      box.extend({end.X + static_cast<cInt>(slope * static_cast<double>(y - end.Y)), y});
    }
  }
  return box;
}

/// The part of the box from `low` to `high` in which a polygon may be; empty: none. `sides`: as in strip().
Box partIn(const IntPoint& low, const IntPoint& high, const std::vector<Side>& sides) {
  const Box at = strip(sides, low.Y - kSlack, high.Y + kSlack);
  Box part;
  const cInt left = std::max(at.low().X, low.X) - kSlack, right = std::min(at.high().X, high.X) + kSlack;
  if (at.empty() || left > right) return part;
  part.extend({left, at.low().Y});
  part.extend({right, at.high().Y});
  return part;
}

/// Where edges of the area come near a polygon.
void addMeetings(const std::vector<ChainLoop>& area, const ClipperLib::Path& polygon, Box& meetings) {
  Box whole;
  for (const IntPoint& p : polygon) whole.extend(p);
  const std::vector<Side> sides = sidesOf(polygon);
  std::vector<Side> near;  // those at the height of a piece
  for (const ChainLoop& loop : area) {
    for (const Piece& piece : loop) {
      if (!piece.near(whole.low(), whole.high())) continue;
      near.clear();
      for (const Side& side : sides) {
        if (side.between(piece.low.Y - kSlack, piece.high.Y + kSlack)) near.push_back(side);
      }
      if (partIn(piece.low, piece.high, near).empty()) continue;
      const ClipperLib::Path& points = piece.chain->points;
      for (std::size_t i = 1; i < points.size(); ++i) {
        const IntPoint &a = points[i - 1], &b = points[i];
        if (whole.misses(a, b)) continue;
        const IntPoint low(std::min(a.X, b.X), std::min(a.Y, b.Y)),
            high(std::max(a.X, b.X), std::max(a.Y, b.Y));
        // What lies within the meetings adds nothing to them.
        if (meetings.holds({low.X - kSlack, low.Y - kSlack}) &&
            meetings.holds({high.X + kSlack, high.Y + kSlack}))
          continue;
        const Box part = partIn(low, high, near);
        if (part.empty()) continue;
        meetings.extend(part.low());
        meetings.extend(part.high());
      }
    }
  }
}

/// Adds the corners of the polygon that lie in the area. All that is connected beyond the meetings is on one
/// side, and each such part of a polygon has a corner.
void addDeep(const std::vector<ChainLoop>& area, const ClipperLib::Path& polygon, Box& meetings) {
  const IntPoint* before = nullptr;  // a corner that is not in the area
  for (const IntPoint& p : polygon) {
    const bool beyond = meetings.empty() || !meetings.holds(p);
    const bool known = before != nullptr && (meetings.empty() || meetings.misses(*before, p));
    before = beyond ? &p : nullptr;
    if (!beyond || known) continue;
    bool inside = false;
    for (const ChainLoop& loop : area) inside ^= surrounds(loop, p);
    if (!inside) continue;
    meetings.extend(p);
    before = nullptr;
  }
}

}  // namespace

std::optional<Bounds> reachOf(const std::vector<ChainLoop>& area, const ClipperLib::Paths& tool) {
  Box meetings;
  for (const ClipperLib::Path& polygon : tool) addMeetings(area, polygon, meetings);
  for (const ClipperLib::Path& polygon : tool) addDeep(area, polygon, meetings);
  if (meetings.empty()) return std::nullopt;
  return Bounds{meetings.low(), meetings.high()};
}

}  // namespace proveout::section_detail
