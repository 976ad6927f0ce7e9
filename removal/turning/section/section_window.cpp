// Sections are changed in windows: a pass costs what it touches, not the whole profile.
#include "removal/turning/section/section_window.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "core/base/assert.h"

namespace proveout::section_detail {

namespace {

/// How far a window reaches beyond what is changed, units.
constexpr cInt kMargin = 2003;

struct PointHash {
  std::size_t operator()(const IntPoint& p) const {
    const std::uint64_t h = static_cast<std::uint64_t>(p.X) * 0x9E3779B97F4A7C15ull ^
                            static_cast<std::uint64_t>(p.Y) * 0xC2B2AE3D27D4EB4Full;
    return static_cast<std::size_t>(h ^ (h >> 29));
  }
};

/// Where an edge crosses a line of constant X or Y.
IntPoint crossing(const IntPoint& a, const IntPoint& b, bool at_x, cInt value) {
  const double from = static_cast<double>(at_x ? a.X : a.Y), to = static_cast<double>(at_x ? b.X : b.Y);
  const double t = (static_cast<double>(value) - from) / (to - from);
  const double other_from = static_cast<double>(at_x ? a.Y : a.X),
               other_to = static_cast<double>(at_x ? b.Y : b.X);
  const auto other = static_cast<cInt>(std::llround(other_from + t * (other_to - other_from)));
  return at_x ? IntPoint(value, other) : IntPoint(other, value);
}

/// One side of a line of constant X or Y.
struct HalfPlane {
  bool at_x;
  cInt value;
  cInt sign;  ///< +1: above the value
  cInt off(const IntPoint& p) const { return sign * ((at_x ? p.X : p.Y) - value); }
};

/// The part of a loop in a half-plane, closed along its border (Sutherland and Hodgman, 1974).
Loop clipped(const Loop& loop, const HalfPlane& plane) {
  Loop out;
  const auto add = [&](const IntPoint& p, MotionId motion) {
    out.points.push_back(p);
    out.motion.push_back(motion);
  };
  for (std::size_t i = 0; i < loop.points.size(); ++i) {
    const IntPoint &a = loop.points[i], &b = loop.points[loop.after(i)];
    const cInt off_a = plane.off(a), off_b = plane.off(b);
    const MotionId motion = loop.motion[i];
    if (off_a >= 0 && off_b >= 0) {
      add(a, motion);
    } else if (off_a >= 0) {
      if (off_a > 0) add(a, motion);
      add(off_a > 0 ? crossing(a, b, plane.at_x, plane.value) : a, kNoMotion);
    } else if (off_b > 0) {
      add(crossing(a, b, plane.at_x, plane.value), motion);
    }
  }
  return out;
}

}  // namespace

double distance2(double x, double y, const IntPoint& a, const IntPoint& b) {
  const double ax = static_cast<double>(a.X), ay = static_cast<double>(a.Y);
  const double dx = static_cast<double>(b.X) - ax, dy = static_cast<double>(b.Y) - ay;
  const double length2 = dx * dx + dy * dy;
  double t = length2 > 0.0 ? ((x - ax) * dx + (y - ay) * dy) / length2 : 0.0;
  t = std::clamp(t, 0.0, 1.0);
  const double ex = x - ax - t * dx, ey = y - ay - t * dy;
  return ex * ex + ey * ey;
}

void clean(Loop& loop) {
  Loop out;
  const std::size_t n = loop.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const IntPoint& p = loop.points[i];
    const IntPoint& next = loop.points[(i + 1) % n];
    const IntPoint& before = out.points.empty() ? loop.points[n - 1] : out.points.back();
    const MotionId into = out.motion.empty() ? loop.motion[n - 1] : out.motion.back();
    if (p == next) continue;
    if (into == loop.motion[i] &&
        distance2(static_cast<double>(p.X), static_cast<double>(p.Y), before, next) <= kNear * kNear)
      continue;
    out.points.push_back(p);
    out.motion.push_back(loop.motion[i]);
  }
  loop = std::move(out);
}

namespace {

/// As clean(), of an open run whose ends stay.
void clean(Chain& run) {
  Chain out;
  for (std::size_t i = 0; i < run.motion.size(); ++i) {
    const IntPoint &p = run.points[i], &next = run.points[i + 1];
    if (p == next) continue;
    if (!out.motion.empty() && out.motion.back() == run.motion[i] &&
        distance2(static_cast<double>(p.X), static_cast<double>(p.Y), out.points.back(), next) <=
            kNear * kNear)
      continue;
    out.points.push_back(p);
    out.motion.push_back(run.motion[i]);
  }
  out.points.push_back(run.points.back());
  run = std::move(out);
}

}  // namespace

WindowCut::WindowCut(const std::vector<ChainLoop>& loops, const IntPoint& low, const IntPoint& high)
    : window_{{low.X - kMargin, low.Y - kMargin}, {high.X + kMargin, high.Y + kMargin}} {
  settle(loops);
  PROVEOUT_ASSERT(window_.low.X < window_.high.X && window_.low.Y < window_.high.Y);
  for (const ChainLoop& loop : loops) {
    Strand divided;
    if (divide(loop, divided)) {
      const auto out = [&](const IntPoint& a, const IntPoint& b) {
        return !window_.contains(0.5 * static_cast<double>(a.X + b.X), 0.5 * static_cast<double>(a.Y + b.Y));
      };
      strandsOf(divided, out, outside_);
    } else {
      const IntPoint& p = loop.front().front();
      if (!window_.contains(static_cast<double>(p.X), static_cast<double>(p.Y))) untouched_.push_back(&loop);
    }
    clip({std::move(divided.points), std::move(divided.motion)});
  }
}

/// Moves the border off the coordinates of all points of the pieces that it may meet.
void WindowCut::settle(const std::vector<ChainLoop>& loops) {
  const auto moveOff = [this](const Piece& piece) {
    bool moved = false;
    for (const IntPoint& p : piece.chain->points) {
      const bool low_x = p.X == window_.low.X, low_y = p.Y == window_.low.Y;
      const bool high_x = p.X == window_.high.X, high_y = p.Y == window_.high.Y;
      if (!(low_x || low_y || high_x || high_y)) continue;
      window_.low.X -= low_x;
      window_.low.Y -= low_y;
      window_.high.X += high_x;
      window_.high.Y += high_y;
      moved = true;
    }
    return moved;
  };
  for (bool moved = true; moved;) {
    moved = false;
    for (const ChainLoop& loop : loops) {
      for (const Piece& piece : loop) moved |= piece.near(window_.low, window_.high) && moveOff(piece);
    }
  }
}

bool WindowCut::divide(const ChainLoop& loop, Strand& out) const {
  std::size_t edges = 0;
  for (const Piece& piece : loop) {
    if (!piece.near(window_.low, window_.high)) {
      out.add(piece.front(), kNoMotion, &piece);
      ++edges;
      continue;
    }
    const Chain& chain = *piece.chain;
    edges += piece.edges();
    for (std::size_t i = 0; i < chain.motion.size(); ++i) {
      out.add(chain.points[i], chain.motion[i], nullptr);
      addCrossings(chain.points[i], chain.points[i + 1], chain.motion[i], out);
    }
  }
  return out.points.size() > edges;
}

void WindowCut::addCrossings(const IntPoint& a, const IntPoint& b, MotionId motion, Strand& out) const {
  const IntPoint &low = window_.low, &high = window_.high;
  const auto [min_x, max_x] = std::minmax(a.X, b.X);
  const auto [min_y, max_y] = std::minmax(a.Y, b.Y);
  if (max_x < low.X || min_x > high.X || max_y < low.Y || min_y > high.Y) return;
  if (min_x > low.X && max_x < high.X && min_y > low.Y && max_y < high.Y) return;
  ClipperLib::Path met;
  for (const cInt x : {low.X, high.X}) {
    if (min_x >= x || max_x <= x) continue;
    const IntPoint p = crossing(a, b, true, x);
    if (p.Y > low.Y && p.Y < high.Y) met.push_back(p);
  }
  for (const cInt y : {low.Y, high.Y}) {
    if (min_y >= y || max_y <= y) continue;
    const IntPoint p = crossing(a, b, false, y);
    if (p.X > low.X && p.X < high.X) met.push_back(p);
  }
  const auto along = [&](const IntPoint& p) { return std::abs(p.X - a.X) + std::abs(p.Y - a.Y); };
  std::sort(met.begin(), met.end(),
            [&](const IntPoint& p, const IntPoint& q) { return along(p) < along(q); });
  for (const IntPoint& p : met) out.add(p, motion, nullptr);
}

void WindowCut::clip(Loop loop) {
  for (const HalfPlane& plane : {HalfPlane{false, window_.low.Y, 1}, HalfPlane{false, window_.high.Y, -1},
                                 HalfPlane{true, window_.low.X, 1}, HalfPlane{true, window_.high.X, -1}}) {
    loop = clipped(loop, plane);
    if (loop.points.size() < 3) return;
  }
  inside_.push_back(std::move(loop));
}

/// Cuts a loop into the strands of edges that belong. False where all of it belongs: nothing is added.
template <typename Belongs>
bool WindowCut::strandsOf(const Strand& loop, const Belongs& belongs, std::vector<Strand>& strands) {
  const std::size_t n = loop.points.size();
  PROVEOUT_ASSERT(loop.motion.size() == n && loop.far.size() == n);
  const auto after = [n](std::size_t i) { return i + 1 < n ? i + 1 : 0; };
  std::vector<char> mine(n);
  for (std::size_t i = 0; i < n; ++i)
    mine[i] = loop.far[i] != nullptr || belongs(loop.points[i], loop.points[after(i)]);
  const auto other = std::find(mine.begin(), mine.end(), 0);
  if (other == mine.end()) return false;
  const auto first = static_cast<std::size_t>(other - mine.begin());
  bool open = false;
  for (std::size_t k = 1; k <= n; ++k) {
    const std::size_t i = (first + k) % n;
    if (!mine[i]) {
      open = false;
      continue;
    }
    if (!open) strands.push_back({{loop.points[i]}, {}, {}});
    open = true;
    strands.back().add(loop.points[after(i)], loop.motion[i], loop.far[i]);
  }
  return true;
}

/// A closed strand as pieces; those that were far are what they were.
ChainLoop WindowCut::closed(Strand&& joined) {
  ChainLoop out;
  const std::size_t n = joined.motion.size();
  PROVEOUT_ASSERT(joined.points.size() == n && joined.far.size() == n);
  const auto far = std::find_if(joined.far.begin(), joined.far.end(), [](const Piece* p) { return p; });
  if (far == joined.far.end()) {
    Loop loop{std::move(joined.points), std::move(joined.motion)};
    clean(loop);
    return loop.points.size() > 2 ? chained(loop) : out;
  }
  const auto first = static_cast<std::size_t>(far - joined.far.begin());
  Chain run;
  const auto end = [&](const IntPoint& p) {
    if (run.motion.empty()) return;
    run.points.push_back(p);
    clean(run);
    if (!run.motion.empty()) append(std::exchange(run, {}), out);
    run = {};
  };
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = (first + k) % n;
    if (const Piece* piece = joined.far[i]) {
      end(joined.points[i]);
      out.push_back(*piece);
      continue;
    }
    run.points.push_back(joined.points[i]);
    run.motion.push_back(joined.motion[i]);
  }
  end(joined.points[first]);
  return out;
}

bool WindowCut::join(const std::vector<Loop>& changed, std::vector<ChainLoop>& out) const {
  std::vector<Strand> strands = outside_;
  for (const ChainLoop* loop : untouched_) out.push_back(*loop);
  for (const Loop& loop : changed) {
    const auto off_border = [this](const IntPoint& a, const IntPoint& b) { return !window_.along(a, b); };
    Strand whole{loop.points, loop.motion, std::vector<const Piece*>(loop.points.size(), nullptr)};
    if (strandsOf(whole, off_border, strands)) continue;
    if (ChainLoop island = closed(std::move(whole)); !island.empty()) out.push_back(std::move(island));
  }
  std::unordered_map<IntPoint, std::size_t, PointHash> begins;
  for (std::size_t c = 0; c < strands.size(); ++c) {
    if (!begins.emplace(strands[c].points.front(), c).second) return false;
  }
  std::vector<char> used(strands.size(), 0);
  for (std::size_t c = 0; c < strands.size(); ++c) {
    if (used[c]) continue;
    Strand loop;
    for (std::size_t at = c; !used[at];) {
      used[at] = 1;
      const Strand& strand = strands[at];
      PROVEOUT_ASSERT(strand.points.size() == strand.motion.size() + 1);
      for (std::size_t i = 0; i < strand.motion.size(); ++i)
        loop.add(strand.points[i], strand.motion[i], strand.far[i]);
      const auto next = begins.find(strand.points.back());
      if (next == begins.end()) return false;
      at = next->second;
      if (used[at] && at != c) return false;
    }
    if (ChainLoop whole = closed(std::move(loop)); !whole.empty()) out.push_back(std::move(whole));
  }
  return true;
}

}  // namespace proveout::section_detail
