#include "core/tool/insert_holder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/geometry/ears.h"

namespace proveout {

namespace {

using Piece = std::vector<std::size_t>;  ///< indices of points, counter-clockwise

/// Three points nearer to one line than this are on it, mm.
constexpr double kStraightMm = 1e-9;

/// Twice the area of the triangle, above 0 counter-clockwise.
double turn(const Vec2& a, const Vec2& b, const Vec2& c) { return cross2(b - a, c - a); }

bool cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return (turn(a, b, c) > 0.0) != (turn(a, b, d) > 0.0) && (turn(c, d, a) > 0.0) != (turn(c, d, b) > 0.0);
}

bool meet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return cross(a, b, c, d) || distanceToSegment(a, c, d) < kHolderClearanceMm ||
         distanceToSegment(b, c, d) < kHolderClearanceMm || distanceToSegment(c, a, b) < kHolderClearanceMm ||
         distanceToSegment(d, a, b) < kHolderClearanceMm;
}

/// Cuts ears off a simple polygon.
class EarClipping {
 public:
  explicit EarClipping(const std::vector<Vec2>& points) : p_(points) {
    for (std::size_t k = 0; k < p_.size(); ++k) rest_.push_back(k);
    if (signedArea2(p_) < 0.0) std::reverse(rest_.begin(), rest_.end());
  }

  /// False: rounding leaves no ear.
  bool run() {
    while (rest_.size() > 3) {
      std::size_t k = 0;
      while (k < rest_.size() && !straight(k) && !ear(k)) ++k;
      if (k == rest_.size()) return false;
      if (!straight(k)) pieces.push_back({before(k), rest_[k], after(k)});
      rest_.erase(rest_.begin() + static_cast<std::ptrdiff_t>(k));
    }
    if (!straight(0) && !straight(1) && !straight(2)) pieces.push_back(rest_);
    return !pieces.empty();
  }

  std::vector<Piece> pieces;

 private:
  std::size_t before(std::size_t k) const { return rest_[(k + rest_.size() - 1) % rest_.size()]; }
  std::size_t after(std::size_t k) const { return rest_[(k + 1) % rest_.size()]; }
  bool straight(std::size_t k) const {
    const Vec2 &a = p_[before(k)], &b = p_[rest_[k]], &c = p_[after(k)];
    return std::abs(turn(a, b, c)) <= kStraightMm * (c - a).norm();
  }
  bool ear(std::size_t k) const {
    const Vec2 &a = p_[before(k)], &b = p_[rest_[k]], &c = p_[after(k)];
    if (turn(a, b, c) <= 0.0) return false;
    return std::none_of(rest_.begin(), rest_.end(), [&](std::size_t i) {
      if (i == before(k) || i == rest_[k] || i == after(k)) return false;
      const Vec2& p = p_[i];
      return turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0;
    });
  }

  const std::vector<Vec2>& p_;
  std::vector<std::size_t> rest_;
};

/// Where a piece has the side from a to b; its size: nowhere.
std::size_t sideOf(const Piece& piece, std::size_t a, std::size_t b) {
  for (std::size_t k = 0; k < piece.size(); ++k) {
    if (piece[k] == a && piece[(k + 1) % piece.size()] == b) return k;
  }
  return piece.size();
}

/// Both pieces as one if they share a side and the whole is convex; else nothing.
Piece joined(const std::vector<Vec2>& p, const Piece& one, const Piece& other) {
  for (std::size_t k = 0; k < one.size(); ++k) {
    const std::size_t a = one[k], b = one[(k + 1) % one.size()];
    const std::size_t at = sideOf(other, b, a);
    if (at == other.size()) continue;
    Piece whole;  // from b round to a, then the other from a to b
    for (std::size_t i = 1; i <= one.size(); ++i) whole.push_back(one[(k + i) % one.size()]);
    for (std::size_t i = 2; i < other.size(); ++i) whole.push_back(other[(at + i) % other.size()]);
    for (std::size_t i = 0; i < whole.size(); ++i) {
      const Vec2 &u = p[whole[i]], &v = p[whole[(i + 1) % whole.size()]],
                 &w = p[whole[(i + 2) % whole.size()]];
      if (turn(u, v, w) < 0.0) return {};
    }
    return whole;
  }
  return {};
}

void joinPieces(const std::vector<Vec2>& points, std::vector<Piece>& pieces) {
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (std::size_t j = i + 1; j < pieces.size();) {
      Piece whole = joined(points, pieces[i], pieces[j]);
      if (whole.empty()) {
        ++j;
        continue;
      }
      pieces[i] = std::move(whole);
      pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(j));
      j = i + 1;  // what did not fit before may fit now
    }
  }
}

/// What keeps a polygon from being simple; empty: it is.
std::string fault(const std::vector<Vec2>& p) {
  const std::size_t n = p.size();
  if (n < 3) return fmt::format("a polygon has at least three points, not {}", n);
  if (n > kMaxHolderPoints) return fmt::format("{} points; at most {} are allowed", n, kMaxHolderPoints);
  const auto at = [&](std::size_t k) -> const Vec2& { return p[k % n]; };
  for (std::size_t i = 0; i < n; ++i) {
    if ((at(i + 1) - p[i]).norm() < kHolderClearanceMm)
      return fmt::format("points {} and {} are the same", i + 1, (i + 1) % n + 1);
  }
  for (std::size_t i = 0; i < n; ++i) {
    // Neighbours share a point; they must not fold back onto each other.
    if (distanceToSegment(at(i + 2), p[i], at(i + 1)) < kHolderClearanceMm ||
        distanceToSegment(p[i], at(i + 1), at(i + 2)) < kHolderClearanceMm)
      return fmt::format("the border folds back on itself at point {}", (i + 1) % n + 1);
    for (std::size_t j = i + 2; j < n && (j + 1) % n != i; ++j) {
      if (meet(p[i], at(i + 1), p[j], at(j + 1)))
        return fmt::format("the border meets itself: behind point {} and behind point {}", i + 1, j + 1);
    }
  }
  return {};
}

}  // namespace

Result<std::vector<std::vector<Vec2>>> convexPieces(const std::vector<Vec2>& polygon) {
  if (std::string why = fault(polygon); !why.empty()) return inputError(std::move(why));
  EarClipping clipping(polygon);
  if (!clipping.run()) return inputError("the polygon is too thin");
  joinPieces(polygon, clipping.pieces);
  std::vector<std::vector<Vec2>> pieces;
  for (const Piece& piece : clipping.pieces) {
    PROVEOUT_ASSERT(piece.size() >= 3);
    std::vector<Vec2>& points = pieces.emplace_back();
    for (const std::size_t k : piece) points.push_back(polygon[k]);
  }
  return pieces;
}

}  // namespace proveout
