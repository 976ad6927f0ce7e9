#include "removal/wire/lean/wall_parts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/assert.h"
#include "core/geometry/plane.h"
#include "removal/wire/section/stretch_index.h"

namespace proveout {
namespace {

using Outline = std::vector<Vec2>;

/// Points may slide along walls by this share of the edges beside them.
constexpr double kSlide = 0.25;
/// Parabolas are off by no more than this share of the tolerance; the rest is for the triangles.
constexpr double kShareOfParabola = 0.25;
/// Parts of so few edges are halved as they are: a section a quarter up costs more than their triangles.
constexpr std::uint32_t kSmallPart = 16;
/// Most parts of one rung: walls that need more are halved.
constexpr std::uint32_t kMostRows = 256;

/// Points that follow each other; of whole loops the last is followed by the first.
struct Line {
  Outline points;
  bool closed = false;

  std::size_t sides() const { return closed ? points.size() : points.size() - 1; }
  const Vec2& behind(std::size_t i) const { return points[(i + 1) % points.size()]; }
};

std::vector<WireStretch> segmentsOf(const Line& line) {
  std::vector<WireStretch> sides(line.sides());
  for (std::size_t i = 0; i < sides.size(); ++i) {
    sides[i].from = line.points[i];
    sides[i].to = line.behind(i);
  }
  return sides;
}

/// By how much a corner may be off: the tip of a needle, of material or of a gap, moves fast with the height,
/// and may be missing as far as the needle is thinner than the tolerance.
double allowedAt(const Line& line, std::size_t i, double tolerance) {
  const std::size_t n = line.points.size();
  if (!line.closed && (i == 0 || i + 1 == n)) return tolerance;
  const Vec2 u = line.points[(i + n - 1) % n] - line.points[i], v = line.behind(i) - line.points[i];
  const double lengths = u.norm() * v.norm();
  if (lengths == 0.0) return tolerance;
  const double cosine = std::clamp(u.dot(v) / lengths, -1.0, 1.0);
  const double half_tangent = std::sqrt((1.0 - cosine) / (1.0 + cosine + 1e-12));
  const double needle = tolerance / (2.0 * half_tangent + 1e-9);
  return std::max(tolerance, std::min(needle, 0.5 * std::min(u.norm(), v.norm())));
}

/// By point of a line: whether it is off the other one.
std::vector<bool> offPoints(const Line& line, const Line& other, double tolerance) {
  const std::vector<WireStretch> sides = segmentsOf(other);
  const StretchIndex index(sides);
  std::vector<bool> off(line.points.size(), false);
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    if (index.nearest(line.points[i], tolerance).stretch != StretchIndex::kNone) continue;
    const double allowed = allowedAt(line, i, tolerance);
    off[i] = allowed <= tolerance || index.nearest(line.points[i], allowed).stretch == StretchIndex::kNone;
  }
  return off;
}

bool any(const std::vector<bool>& flags) {
  return std::find(flags.begin(), flags.end(), true) != flags.end();
}

std::uint32_t sizeOf(const LevelLoop& loop) { return static_cast<std::uint32_t>(loop.points.size()); }

/// From a place to the edges of a loop that meet at a point: where they turn little that point may lie
/// anywhere along them.
double besidePoint(const LevelLoop& loop, std::uint32_t i, const Vec2& p) {
  const std::uint32_t n = sizeOf(loop);
  return std::min(distanceToSegment(p, loop.points[(i + n - 1) % n], loop.points[i]),
                  distanceToSegment(p, loop.points[i], loop.points[(i + 1) % n]));
}
/// The length of the shorter one of both.
double shorterBeside(const LevelLoop& loop, std::uint32_t i) {
  const std::uint32_t n = sizeOf(loop);
  return std::min((loop.points[(i + n - 1) % n] - loop.points[i]).norm(),
                  (loop.points[(i + 1) % n] - loop.points[i]).norm());
}

/// A rung where edges of one name begin at all heights, and how many edges half way up the point that belongs
/// to it is behind the first.
struct Cut {
  std::size_t rung;
  std::uint32_t middle;
  double bend = 0.0;  ///< from the middle of the rung to that point, mm
};

/// So many rows that the triangles of a strip leave it by no more than `tolerance`: a parabola that bends by
/// `bend` between its ends and a wall one end of which opens by `twist` more than the other. Powers of two,
/// so that the points of neighbours are half way between each other also where one has more.
std::uint32_t rowsOf(double bend, double twist, double tolerance) {
  if (bend + 0.25 * twist <= tolerance) return 1;
  std::uint32_t rows = 2;
  while (rows <= kMostRows && (bend / rows + 0.125 * twist) / rows > tolerance) rows *= 2;
  return rows;
}

class WallJudge {
 public:
  WallJudge(const WallLoops& wall, double tolerance)
      : wall_(wall), middle_loop_(wall.middle.loop()), tolerance_(tolerance) {}

  WallVerdict whole(bool parts) {
    ribbon_ = ribbonBetween(wall_.lower, wall_.upper);
    if (!ribbon_) return std::move(out_);
    const std::uint32_t n = sizeOf(middle_loop_);
    middle_ = {0, n};
    closed_ = true;
    if (isStraight()) return std::move(out_);
    if (!parts) return std::move(out_);
    findCuts();
    if (cuts_.size() < 2) return std::move(out_);
    // From the first cut on all round to it again.
    beginAt(cuts_.front());
    cuts_.push_back({ribbon_->rungs.size() - 1, n, cuts_.front().bend});
    divide();
    if (out_.settled.empty()) out_ = {};
    return std::move(out_);
  }

  WallVerdict part(const WallPart& part, PartWish wish) {
    ribbon_ = ribbonBetween(wall_.lower, part.lower, wall_.upper, part.upper);
    if (!ribbon_) return failed();
    if (wish == PartWish::kLast) {
      if (!isUpright(*ribbon_, wall_.lower, wall_.upper)) return failed();
      out_.settled.push_back(std::move(*ribbon_));
      return std::move(out_);
    }
    const auto first = startHalfWay(ribbon_->rungs.front()), end = startHalfWay(ribbon_->rungs.back());
    if (!first || !end || *first == *end) return failed();
    const std::uint32_t n = sizeOf(middle_loop_);
    middle_ = {*first, (*end + n - *first) % n};
    if (wish == PartWish::kHalved) {
      leave(cutAt(0, 0), cutAt(ribbon_->rungs.size() - 1, middle_.edges));
      return std::move(out_);
    }
    if (isStraight()) return std::move(out_);
    if (middle_.edges > kSmallPart) findCuts();
    std::erase_if(cuts_, [&](const Cut& cut) {
      return cut.rung == 0 || cut.rung + 1 == ribbon_->rungs.size() || cut.middle == 0 ||
             cut.middle >= middle_.edges;
    });
    cuts_.insert(cuts_.begin(), cutAt(0, 0));
    cuts_.push_back(cutAt(ribbon_->rungs.size() - 1, middle_.edges));
    divide();
    return std::move(out_);
  }

 private:
  WallVerdict failed() {
    out_ = {};
    out_.failed = true;
    return std::move(out_);
  }

  /// Settles the whole wall if its triangles are true.
  bool isStraight() {
    look();
    if (any(off_rungs_) || any(off_points_)) return false;
    out_.settled.push_back(*ribbon_);
    return true;
  }

  Vec2 middleOf(const std::pair<std::uint32_t, std::uint32_t>& rung) const {
    return 0.5 * (wall_.lower.points[rung.first] + wall_.upper.points[rung.second]);
  }
  const Vec2& pointHalfWay(std::uint32_t k) const {
    return middle_loop_.points[(middle_.first + k) % sizeOf(middle_loop_)];
  }

  /// Where the triangles of the wall and the section half way up leave each other. The ends of a part may
  /// slide along the wall: behind them both go on.
  void look() {
    Line triangles, section;
    triangles.closed = section.closed = closed_;
    const std::size_t rungs = ribbon_->rungs.size() - (closed_ ? 1 : 0);
    for (std::size_t k = 0; k < rungs; ++k) triangles.points.push_back(middleOf(ribbon_->rungs[k]));
    const std::uint32_t points = middle_.edges + (closed_ ? 0 : 1);
    for (std::uint32_t k = 0; k < points; ++k) section.points.push_back(pointHalfWay(k));
    off_rungs_ = offPoints(triangles, goneOn(section, beforeAndBehind(middle_)), tolerance_);
    const auto [i, j] = ribbon_->rungs.front();
    const auto [end_i, end_j] = ribbon_->rungs.back();
    off_points_ =
        offPoints(section,
                  goneOn(triangles, {middleOf({before(wall_.lower, i), before(wall_.upper, j)}),
                                     middleOf({behind(wall_.lower, end_i), behind(wall_.upper, end_j)})}),
                  tolerance_);
  }
  static std::uint32_t before(const LevelLoop& loop, std::uint32_t i) {
    return (i + sizeOf(loop) - 1) % sizeOf(loop);
  }
  static std::uint32_t behind(const LevelLoop& loop, std::uint32_t i) { return (i + 1) % sizeOf(loop); }
  std::pair<Vec2, Vec2> beforeAndBehind(const LoopSpan& span) const {
    const std::uint32_t end = endOf(middle_loop_, span);
    return {middle_loop_.points[before(middle_loop_, span.first)],
            middle_loop_.points[behind(middle_loop_, end)]};
  }
  static Line goneOn(const Line& line, const std::pair<Vec2, Vec2>& ends) {
    Line out = line;
    if (line.closed) return out;
    out.points.insert(out.points.begin(), ends.first);
    out.points.push_back(ends.second);
    return out;
  }

  std::optional<std::uint32_t> startHalfWay(const std::pair<std::uint32_t, std::uint32_t>& rung) const {
    const WallName name = wall_.lower.names[rung.first];
    if (wall_.upper.names[rung.second] != name) return std::nullopt;
    return wall_.middle.at(name, middleOf(rung));
  }

  Cut cutAt(std::size_t rung, std::uint32_t middle) const {
    const std::uint32_t i = (middle_.first + middle) % sizeOf(middle_loop_);
    return {rung, middle, besidePoint(middle_loop_, i, middleOf(ribbon_->rungs[rung]))};
  }

  /// Rungs whose parabola through the section half way up passes the one a quarter up.
  void findCuts() {
    const RunStarts* quarter = wall_.quarter();
    if (quarter == nullptr) return;
    const LevelLoop& quarter_up = quarter->loop();
    const std::uint32_t n = sizeOf(middle_loop_);
    for (const std::size_t rung : ribbon_->starts) {
      const auto [i, j] = ribbon_->rungs[rung];
      // Round ends may be missing at heights between these.
      if (!isSide(wall_.lower.names[i])) continue;
      const auto m = startHalfWay(ribbon_->rungs[rung]);
      if (!m) continue;
      const Vec2 expected =
          0.375 * wall_.lower.points[i] + 0.75 * middle_loop_.points[*m] - 0.125 * wall_.upper.points[j];
      const auto q = quarter->at(wall_.lower.names[i], expected);
      if (!q || besidePoint(quarter_up, *q, expected) > kShareOfParabola * tolerance_ ||
          (quarter_up.points[*q] - expected).norm() > kSlide * shorterBeside(quarter_up, *q))
        continue;
      const std::uint32_t middle = (*m + n - middle_.first) % n;
      if (middle <= middle_.edges) add(cutAt(rung, middle));
    }
  }
  void add(const Cut& cut) {
    const std::uint32_t n = sizeOf(middle_loop_);
    const std::uint32_t first = cuts_.empty() || !closed_ ? 0 : cuts_.front().middle;
    const auto behind = [&](const Cut& c) { return (c.middle + n - first) % n; };
    if (cuts_.empty() || (cut.rung > cuts_.back().rung && behind(cut) > behind(cuts_.back())))
      cuts_.push_back(cut);
  }

  /// Turns a whole wall so that it begins at a cut.
  void beginAt(const Cut& start) {
    const std::uint32_t n = sizeOf(middle_loop_);
    const std::size_t rung = start.rung;
    const std::uint32_t middle = start.middle;
    ribbon_->rungs.pop_back();
    std::rotate(ribbon_->rungs.begin(), ribbon_->rungs.begin() + static_cast<std::ptrdiff_t>(rung),
                ribbon_->rungs.end());
    std::rotate(off_rungs_.begin(), off_rungs_.begin() + static_cast<std::ptrdiff_t>(rung), off_rungs_.end());
    std::rotate(off_points_.begin(), off_points_.begin() + middle, off_points_.end());
    ribbon_->rungs.push_back(ribbon_->rungs.front());
    off_rungs_.push_back(off_rungs_.front());
    off_points_.push_back(off_points_.front());
    for (Cut& cut : cuts_) {
      cut.rung = cut.rung - rung;
      cut.middle = (cut.middle + n - middle) % n;
    }
    middle_.first = middle;
  }

  bool isOff(const Cut& from, const Cut& to) const {
    PROVEOUT_ASSERT(to.rung < off_rungs_.size() && to.middle < off_points_.size());
    return std::find(off_rungs_.begin() + static_cast<std::ptrdiff_t>(from.rung),
                     off_rungs_.begin() + static_cast<std::ptrdiff_t>(to.rung) + 1,
                     true) != off_rungs_.begin() + static_cast<std::ptrdiff_t>(to.rung) + 1 ||
           std::find(off_points_.begin() + from.middle, off_points_.begin() + to.middle + 1, true) !=
               off_points_.begin() + to.middle + 1;
  }

  /// Between two cuts a wall of one name is a strip between two rungs.
  struct Strip {
    bool settled = false;
    bool plain = false;      ///< one edge at all heights
    std::uint32_t rows = 1;  ///< on both sides
  };
  Strip stripBetween(const Cut& from, const Cut& to) const {
    PROVEOUT_ASSERT(from.rung < to.rung && from.middle < to.middle);
    const auto [i, j] = ribbon_->rungs[from.rung];
    const auto [end_i, end_j] = ribbon_->rungs[to.rung];
    const Vec2 low = wall_.lower.points[end_i] - wall_.lower.points[i],
               high = wall_.upper.points[end_j] - wall_.upper.points[j], along = low + high;
    const bool plain = to.middle == from.middle + 1 && spanBetween(wall_.lower, i, end_i).edges == 1 &&
                       spanBetween(wall_.upper, j, end_j).edges == 1;
    if (!plain || along.norm() == 0.0) {
      const bool room = hasRoom(from, from.rung + 1) && hasRoom(to, to.rung - 1);
      return {room && !isOff(from, to), false, 1};
    }
    const double twist = std::abs(cross2(along, high - low)) / along.norm();
    const std::uint32_t rows =
        rowsOf(std::max(from.bend, to.bend), twist, (1.0 - kShareOfParabola) * tolerance_);
    return {rows <= kMostRows, true, rows};
  }

  /// Whether a cut's rung, once it goes through the section half way up, stays clear of the straight one
  /// beside it.
  bool hasRoom(const Cut& cut, std::size_t beside) const {
    const Vec2 straight = middleOf(ribbon_->rungs[cut.rung]);
    const double moves = (pointHalfWay(cut.middle) - straight).norm();
    return 2.0 * moves <= (middleOf(ribbon_->rungs[beside]) - straight).norm();
  }

  /// What is between cuts is settled or open; neighbours of a kind stay together.
  void divide() {
    std::vector<Strip> strips;
    for (std::size_t k = 0; k + 1 < cuts_.size(); ++k) strips.push_back(stripBetween(cuts_[k], cuts_[k + 1]));
    for (std::size_t k = 0; k < strips.size();) {
      std::size_t end = k + 1;
      while (end < strips.size() && strips[end].settled == strips[k].settled) ++end;
      if (strips[k].settled)
        settle(strips, k, end);
      else
        leave(cuts_[k], cuts_[end]);
      k = end;
    }
  }

  void settle(const std::vector<Strip>& strips, std::size_t first, std::size_t end) {
    Ribbon& part = out_.settled.emplace_back();
    part.rungs.push_back(ribbon_->rungs[cuts_[first].rung]);
    for (std::size_t k = first; k < end; ++k) {
      const auto from = ribbon_->rungs.begin() + static_cast<std::ptrdiff_t>(cuts_[k].rung),
                 to = ribbon_->rungs.begin() + static_cast<std::ptrdiff_t>(cuts_[k + 1].rung);
      part.rungs.insert(part.rungs.end(), strips[k].plain ? to : from + 1, to + 1);
      if (strips[k].rows == 1) continue;
      addCurved(cuts_[k], strips[k].rows, k);
      addCurved(cuts_[k + 1], strips[k].rows, k + 1);
    }
  }
  void addCurved(const Cut& cut, std::uint32_t rows, std::size_t number) {
    const auto [i, j] = ribbon_->rungs[cut.rung];
    out_.curved.push_back({i, j, pointHalfWay(cut.middle), rows, number % 2 == 1});
  }

  void leave(const Cut& from, const Cut& to) {
    const auto [i, j] = ribbon_->rungs[from.rung];
    const auto [end_i, end_j] = ribbon_->rungs[to.rung];
    const std::uint32_t n = sizeOf(middle_loop_), first = (middle_.first + from.middle) % n,
                        end = (middle_.first + to.middle) % n;
    // Edges of one name begin at either end: there are some between them at every height.
    out_.open.push_back({spanBetween(wall_.lower, i, end_i),
                         {first, to.middle - from.middle},
                         spanBetween(wall_.upper, j, end_j)});
    out_.splits.push_back({i, first, j});
    out_.splits.push_back({end_i, end, end_j});
  }
  static LoopSpan spanBetween(const LevelLoop& loop, std::uint32_t first, std::uint32_t end) {
    return {first, (end + sizeOf(loop) - first) % sizeOf(loop)};
  }

  const WallLoops& wall_;
  const LevelLoop& middle_loop_;
  double tolerance_;
  bool closed_ = false;
  std::optional<Ribbon> ribbon_;
  LoopSpan middle_;
  std::vector<bool> off_rungs_;   ///< by rung, not the last of a whole wall
  std::vector<bool> off_points_;  ///< by point of the section half way up, from middle_.first on
  std::vector<Cut> cuts_;
  WallVerdict out_;
};

}  // namespace

std::optional<std::uint32_t> RunStarts::at(WallName name, const Vec2& p) const {
  if (!told_) {
    const std::uint32_t n = sizeOf(*loop_);
    for (std::uint32_t i = 0; i < n; ++i) {
      if (loop_->names[i] != loop_->names[(i + n - 1) % n]) of_[loop_->names[i]].push_back(i);
    }
    told_ = true;
  }
  const auto found = of_.find(name);
  if (found == of_.end()) return std::nullopt;
  const std::vector<std::uint32_t>& places = found->second;
  return *std::min_element(places.begin(), places.end(), [&](std::uint32_t a, std::uint32_t b) {
    return (loop_->points[a] - p).norm() < (loop_->points[b] - p).norm();
  });
}

WallVerdict judgeWall(const WallLoops& wall, double tolerance, bool parts) {
  return WallJudge(wall, tolerance).whole(parts);
}

WallVerdict judgePart(const WallLoops& wall, const WallPart& part, double tolerance, PartWish wish) {
  return WallJudge(wall, tolerance).part(part, wish);
}

}  // namespace proveout
