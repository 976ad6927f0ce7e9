#include "removal/turning/section/section_chains.h"

#include <algorithm>

#include "core/base/assert.h"

namespace proveout::section_detail {

namespace {

/// Edges of a piece: few enough that a small change copies little, so many that a long section has few
/// pieces.
constexpr std::size_t kMostEdges = 64;

double inMm(cInt v) { return kUnit * static_cast<double>(v); }

}  // namespace

Piece::Piece(Chain&& edges) : low(edges.points.front()), high(low) {
  PROVEOUT_ASSERT(edges.points.size() >= 2 && edges.motion.size() + 1 == edges.points.size());
  double cones = 0.0;
  for (std::size_t i = 0; i < edges.points.size(); ++i) {
    const IntPoint& p = edges.points[i];
    low = {std::min(low.X, p.X), std::min(low.Y, p.Y)};
    high = {std::max(high.X, p.X), std::max(high.Y, p.Y)};
    if (i == 0) continue;
    const IntPoint& before = edges.points[i - 1];
    const double a = inMm(before.X), b = inMm(p.X);
    cones += inMm(p.Y - before.Y) * (a * a + a * b + b * b);
    area += 0.5 * static_cast<double>(before.X + p.X) * static_cast<double>(p.Y - before.Y);
  }
  volume_mm3 = kPi / 3.0 * cones;
  chain = std::make_shared<const Chain>(std::move(edges));
}

void append(Chain&& run, ChainLoop& loop) {
  PROVEOUT_ASSERT(run.points.size() == run.motion.size() + 1);
  PROVEOUT_ASSERT(loop.empty() || loop.back().back() == run.points.front());
  if (!loop.empty() && loop.back().edges() + run.motion.size() <= kMostEdges) {
    Chain joined = *loop.back().chain;
    joined.points.insert(joined.points.end(), run.points.begin() + 1, run.points.end());
    joined.motion.insert(joined.motion.end(), run.motion.begin(), run.motion.end());
    loop.back() = Piece(std::move(joined));
    return;
  }
  const std::size_t count = run.motion.size(), parts = (count + kMostEdges - 1) / kMostEdges;
  for (std::size_t k = 0; k < parts; ++k) {
    const auto first = static_cast<std::ptrdiff_t>(count * k / parts),
               last = static_cast<std::ptrdiff_t>(count * (k + 1) / parts);
    Chain part;
    part.points.assign(run.points.begin() + first, run.points.begin() + last + 1);
    part.motion.assign(run.motion.begin() + first, run.motion.begin() + last);
    loop.emplace_back(std::move(part));
  }
}

ChainLoop chained(const Loop& loop) {
  PROVEOUT_ASSERT(loop.points.size() >= 3 && loop.motion.size() == loop.points.size());
  Chain run{loop.points, loop.motion};
  run.points.push_back(loop.points.front());
  ChainLoop out;
  append(std::move(run), out);
  return out;
}

bool isClosed(const ChainLoop& loop) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (!(loop[i].back() == loop[(i + 1) % loop.size()].front())) return false;
  }
  return !loop.empty();
}

Loop flat(const ChainLoop& loop) {
  Loop out;
  for (const Piece& piece : loop) {
    const Chain& chain = *piece.chain;
    out.points.insert(out.points.end(), chain.points.begin(), chain.points.end() - 1);
    out.motion.insert(out.motion.end(), chain.motion.begin(), chain.motion.end());
  }
  return out;
}

double areaOf(const ChainLoop& loop) {
  double area = 0.0;
  for (const Piece& piece : loop) area += piece.area;
  return area;
}

bool surrounds(const ChainLoop& loop, const IntPoint& p) {
  // Edges that a ray towards larger X meets; of a piece that lies beside the point the ends tell.
  bool odd = false;
  const auto meets = [&](const IntPoint& a, const IntPoint& b) {
    if ((a.Y > p.Y) == (b.Y > p.Y)) return false;
    const double share = static_cast<double>(p.Y - a.Y) / static_cast<double>(b.Y - a.Y);
    return static_cast<double>(a.X) + share * static_cast<double>(b.X - a.X) > static_cast<double>(p.X);
  };
  for (const Piece& piece : loop) {
    if (piece.high.X < p.X || piece.high.Y < p.Y || piece.low.Y > p.Y) continue;
    if (piece.low.X > p.X) {
      odd ^= (piece.front().Y > p.Y) != (piece.back().Y > p.Y);
      continue;
    }
    const ClipperLib::Path& points = piece.chain->points;
    for (std::size_t i = 1; i < points.size(); ++i) odd ^= meets(points[i - 1], points[i]);
  }
  return odd;
}

double nearestEdge2(const ChainLoop& loop, double x, double y, double most) {
  for (const Piece& piece : loop) {
    const double dx = std::max(
                     {0.0, static_cast<double>(piece.low.X) - x, x - static_cast<double>(piece.high.X)}),
                 dy = std::max(
                     {0.0, static_cast<double>(piece.low.Y) - y, y - static_cast<double>(piece.high.Y)});
    if (dx * dx + dy * dy >= most) continue;
    const ClipperLib::Path& points = piece.chain->points;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const IntPoint &a = points[i - 1], &b = points[i];
      if (a.X == 0 && b.X == 0) continue;  // the axis is no surface
      most = std::min(most, distance2(x, y, a, b));
    }
  }
  return most;
}

}  // namespace proveout::section_detail
