// Sections are changed in windows: a pass costs what it touches, not the whole profile.
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "removal/turning/section_loops.h"

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

WindowCut::WindowCut(const std::vector<Loop>& loops, const IntPoint& low, const IntPoint& high)
    : window_{{low.X - kMargin, low.Y - kMargin}, {high.X + kMargin, high.Y + kMargin}} {
  settle(loops);
  for (const Loop& loop : loops) {
    Loop divided = withCrossings(loop);
    const bool crossed = divided.points.size() > loop.points.size();
    if (crossed) {
      const auto out = [&](const IntPoint& a, const IntPoint& b) {
        return !window_.contains(0.5 * static_cast<double>(a.X + b.X), 0.5 * static_cast<double>(a.Y + b.Y));
      };
      chainsOf(divided, out, outside_, untouched_);
    } else {
      const IntPoint& p = loop.points.front();
      if (!window_.contains(static_cast<double>(p.X), static_cast<double>(p.Y))) untouched_.push_back(loop);
    }
    clip(std::move(divided));
  }
}

/// Moves the border off the coordinates of all points.
void WindowCut::settle(const std::vector<Loop>& loops) {
  for (bool moved = true; moved;) {
    moved = false;
    for (const Loop& loop : loops) {
      for (const IntPoint& p : loop.points) {
        const bool low_x = p.X == window_.low.X, low_y = p.Y == window_.low.Y;
        const bool high_x = p.X == window_.high.X, high_y = p.Y == window_.high.Y;
        if (!(low_x || low_y || high_x || high_y)) continue;
        window_.low.X -= low_x;
        window_.low.Y -= low_y;
        window_.high.X += high_x;
        window_.high.Y += high_y;
        moved = true;
      }
    }
  }
}

Loop WindowCut::withCrossings(const Loop& loop) const {
  Loop out;
  out.points.reserve(loop.points.size() + 8);
  out.motion.reserve(loop.points.size() + 8);
  const IntPoint &low = window_.low, &high = window_.high;
  for (std::size_t i = 0; i < loop.points.size(); ++i) {
    const IntPoint &a = loop.points[i], &b = loop.points[loop.after(i)];
    out.points.push_back(a);
    out.motion.push_back(loop.motion[i]);
    const auto [min_x, max_x] = std::minmax(a.X, b.X);
    const auto [min_y, max_y] = std::minmax(a.Y, b.Y);
    if (max_x < low.X || min_x > high.X || max_y < low.Y || min_y > high.Y) continue;
    if (min_x > low.X && max_x < high.X && min_y > low.Y && max_y < high.Y) continue;
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
    for (const IntPoint& p : met) {
      out.points.push_back(p);
      out.motion.push_back(loop.motion[i]);
    }
  }
  return out;
}

void WindowCut::clip(Loop loop) {
  for (const HalfPlane& plane : {HalfPlane{false, window_.low.Y, 1}, HalfPlane{false, window_.high.Y, -1},
                                 HalfPlane{true, window_.low.X, 1}, HalfPlane{true, window_.high.X, -1}}) {
    loop = clipped(loop, plane);
    if (loop.points.size() < 3) return;
  }
  inside_.push_back(std::move(loop));
}

/// Cuts a loop into the chains of edges that belong; a loop that belongs whole goes to `whole`.
template <typename Belongs>
void WindowCut::chainsOf(const Loop& loop, const Belongs& belongs, std::vector<Chain>& chains,
                         std::vector<Loop>& whole) {
  const std::size_t n = loop.points.size();
  std::vector<char> mine(n);
  for (std::size_t i = 0; i < n; ++i) mine[i] = belongs(loop.points[i], loop.points[loop.after(i)]);
  const auto other = std::find(mine.begin(), mine.end(), 0);
  if (other == mine.end()) {
    whole.push_back(loop);
    return;
  }
  const auto first = static_cast<std::size_t>(other - mine.begin());
  bool open = false;
  for (std::size_t k = 1; k <= n; ++k) {
    const std::size_t i = (first + k) % n;
    if (!mine[i]) {
      open = false;
      continue;
    }
    if (!open) chains.push_back({{loop.points[i]}, {}});
    open = true;
    chains.back().points.push_back(loop.points[loop.after(i)]);
    chains.back().motion.push_back(loop.motion[i]);
  }
}

bool WindowCut::join(const std::vector<Loop>& changed, std::vector<Loop>& out) const {
  std::vector<Chain> chains = outside_;
  out = untouched_;
  for (const Loop& loop : changed) {
    chainsOf(
        loop, [this](const IntPoint& a, const IntPoint& b) { return !window_.along(a, b); }, chains, out);
  }
  std::unordered_map<IntPoint, std::size_t, PointHash> begins;
  for (std::size_t c = 0; c < chains.size(); ++c) {
    if (!begins.emplace(chains[c].points.front(), c).second) return false;
  }
  std::vector<char> used(chains.size(), 0);
  for (std::size_t c = 0; c < chains.size(); ++c) {
    if (used[c]) continue;
    Loop loop;
    for (std::size_t at = c; !used[at];) {
      used[at] = 1;
      loop.points.insert(loop.points.end(), chains[at].points.begin(), chains[at].points.end() - 1);
      loop.motion.insert(loop.motion.end(), chains[at].motion.begin(), chains[at].motion.end());
      const auto next = begins.find(chains[at].points.back());
      if (next == begins.end()) return false;
      at = next->second;
      if (used[at] && at != c) return false;
    }
    clean(loop);
    if (loop.points.size() > 2) out.push_back(std::move(loop));
  }
  return true;
}

}  // namespace proveout::section_detail
