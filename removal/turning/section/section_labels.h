// Which motion made an edge that a set operation has left of a section.
#pragma once

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "removal/turning/section/section_loops.h"

namespace proveout::section_detail {

struct Edge {
  IntPoint a, b;
  bool operator==(const Edge& o) const { return a == o.a && b == o.b; }
};

struct EdgeHash {
  std::size_t operator()(const Edge& e) const {
    std::uint64_t h = 0x9E3779B97F4A7C15ull;
    for (const cInt v : {e.a.X, e.a.Y, e.b.X, e.b.Y}) {
      h ^= static_cast<std::uint64_t>(v);
      h *= 0xFF51AFD7ED558CCDull;
      h ^= h >> 32;
    }
    return static_cast<std::size_t>(h);
  }
};

/// Finds the labels of the edges that a difference leaves.
class EdgeLabels {
 public:
  explicit EdgeLabels(const std::vector<Loop>& old) : old_(old) {
    std::size_t count = 0;
    for (const Loop& loop : old) count += loop.points.size();
    known_.reserve(count);
    for (const Loop& loop : old) {
      for (std::size_t i = 0; i < loop.points.size(); ++i)
        known_[{loop.points[i], loop.points[(i + 1) % loop.points.size()]}] = loop.motion[i];
    }
  }

  /// What does not lie on an old edge was made by `motion`.
  MotionId of(const IntPoint& a, const IntPoint& b, MotionId motion) const {
    const auto found = known_.find({a, b});
    if (found != known_.end()) return found->second;
    if (lines_.empty()) makeLines();
    const double x = 0.5 * static_cast<double>(a.X + b.X), y = 0.5 * static_cast<double>(a.Y + b.Y);
    const double dx = static_cast<double>(b.X - a.X), dy = static_cast<double>(b.Y - a.Y);
    if (rows_.empty() || y < bottom_ || y > top_) return motion;
    for (const std::uint32_t i : rows_[rowOf(y)]) {
      const Line& line = lines_[i];
      if (x < line.low_x || x > line.high_x || y < line.low_y || y > line.high_y) continue;
      const double ex = static_cast<double>(line.to->X - line.from->X),
                   ey = static_cast<double>(line.to->Y - line.from->Y);
      // The same way round, and not just touched in a point.
      if (dx * ex + dy * ey <= 0.0) continue;
      if (distance2(x, y, *line.from, *line.to) <= kNear * kNear) return line.motion;
    }
    return motion;
  }

 private:
  /// An old edge and where points on it may be, units.
  struct Line {
    double low_x, high_x, low_y, high_y;
    const IntPoint *from, *to;
    MotionId motion;
  };
  void makeLines() const {
    constexpr double kSlack = 2.0;
    for (const Loop& loop : old_) {
      for (std::size_t i = 0; i < loop.points.size(); ++i) {
        const IntPoint &p = loop.points[i], &q = loop.points[loop.after(i)];
        lines_.push_back({static_cast<double>(std::min(p.X, q.X)) - kSlack,
                          static_cast<double>(std::max(p.X, q.X)) + kSlack,
                          static_cast<double>(std::min(p.Y, q.Y)) - kSlack,
                          static_cast<double>(std::max(p.Y, q.Y)) + kSlack, &p, &q, loop.motion[i]});
      }
    }
    makeRows();
  }

  /// Lines by the heights that they reach over, so that a point is compared with few.
  void makeRows() const {
    constexpr std::size_t kLinesARow = 4, kMostRows = 1024;
    if (lines_.empty()) return;
    bottom_ = lines_.front().low_y;
    top_ = lines_.front().high_y;
    for (const Line& line : lines_) {
      bottom_ = std::min(bottom_, line.low_y);
      top_ = std::max(top_, line.high_y);
    }
    rows_.resize(std::clamp(lines_.size() / kLinesARow, std::size_t{1}, kMostRows));
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      for (std::size_t row = rowOf(lines_[i].low_y); row <= rowOf(lines_[i].high_y); ++row)
        rows_[row].push_back(static_cast<std::uint32_t>(i));
    }
  }
  std::size_t rowOf(double y) const {
    const double share = (y - bottom_) / (top_ - bottom_);
    return std::min(static_cast<std::size_t>(share * static_cast<double>(rows_.size())), rows_.size() - 1);
  }

  const std::vector<Loop>& old_;
  mutable std::vector<Line> lines_;  ///< made when first needed, as all of these
  mutable std::vector<std::vector<std::uint32_t>> rows_;
  mutable double bottom_ = 0.0, top_ = 0.0;  ///< units
  std::unordered_map<Edge, MotionId, EdgeHash> known_;
};

}  // namespace proveout::section_detail
