#include "removal/wire/lean/level_match.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/base/assert.h"

namespace proveout {
namespace {

/// How many names are looked ahead for one that both loops have.
constexpr std::size_t kLookAhead = 512;
/// Largest distance between matching corners of upright walls, mm; corners that slide along a wall may be
/// farther apart.
constexpr double kRungMm = 0.02;

/// Edges of a loop that follow each other and have one name.
struct Run {
  WallName name;
  std::uint32_t first, count;  ///< from point `first` on, `count` edges
};

std::vector<Run> runsOf(const LevelLoop& loop, const LoopSpan& span) {
  const auto n = static_cast<std::uint32_t>(loop.points.size());
  PROVEOUT_ASSERT(loop.names.size() == n && span.edges <= n);
  std::vector<Run> runs;
  for (std::uint32_t k = 0; k < span.edges; ++k) {
    const std::uint32_t i = (span.first + k) % n;
    if (!runs.empty() && runs.back().name == loop.names[i])
      ++runs.back().count;
    else
      runs.push_back({loop.names[i], i, 1});
  }
  return runs;
}

std::vector<Run> runsOf(const LevelLoop& loop) {
  const auto n = static_cast<std::uint32_t>(loop.points.size());
  std::uint32_t start = 0;
  while (start < n && loop.names[start] == loop.names[(start + n - 1) % n]) ++start;
  return runsOf(loop, {start % n, n});
}

using Places = std::unordered_map<WallName, std::vector<std::size_t>>;
Places placesOf(const std::vector<Run>& runs) {
  Places places;
  for (std::size_t i = 0; i < runs.size(); ++i) places[runs[i].name].push_back(i);
  return places;
}

double lengthOf(const LevelLoop& loop, const Run& run) {
  double sum = 0.0;
  const std::size_t n = loop.points.size();
  for (std::size_t k = 0; k < run.count; ++k)
    sum += (loop.points[(run.first + k + 1) % n] - loop.points[(run.first + k) % n]).norm();
  return sum;
}

/// Runs of whole loops from the longest on whose name comes once. False: they have no name in common.
bool rotateTogether(std::vector<Run>& a, std::vector<Run>& b, const LevelLoop& loop_a) {
  const Places in_a = placesOf(a), in_b = placesOf(b);
  double longest = -1.0;
  std::size_t at_a = 0, at_b = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto found = in_b.find(a[i].name);
    if (found == in_b.end()) continue;
    const bool once = in_a.at(a[i].name).size() == 1 && found->second.size() == 1;
    const double length = once ? lengthOf(loop_a, a[i]) : 0.0;
    if (length <= longest) continue;
    longest = length;
    at_a = i;
    at_b = found->second.front();
  }
  if (longest < 0.0) return false;
  std::rotate(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(at_a), a.end());
  std::rotate(b.begin(), b.begin() + static_cast<std::ptrdiff_t>(at_b), b.end());
  return true;
}

/// Pairs of runs with one name, in the order of both.
class RunAligner {
 public:
  RunAligner(const std::vector<Run>& a, const std::vector<Run>& b) : a_(a), b_(b), places_(placesOf(b)) {}

  std::vector<std::pair<std::size_t, std::size_t>> align() const {
    std::vector<std::pair<std::size_t, std::size_t>> matched;
    for (std::size_t i = 0, j = 0; next(i, j); ++i, ++j) matched.emplace_back(i, j);
    return matched;
  }

 private:
  /// The next pair from i and j on that skips least.
  bool next(std::size_t& i, std::size_t& j) const {
    std::size_t least = kLookAhead, to_i = 0, to_j = 0;
    for (std::size_t skip = 0; skip < least && i + skip < a_.size(); ++skip) {
      const auto found = places_.find(a_[i + skip].name);
      if (found == places_.end()) continue;
      const auto place = std::lower_bound(found->second.begin(), found->second.end(), j);
      if (place == found->second.end() || skip + (*place - j) >= least) continue;
      least = skip + (*place - j);
      to_i = i + skip;
      to_j = *place;
    }
    if (least == kLookAhead) return false;
    i = to_i;
    j = to_j;
    return true;
  }

  const std::vector<Run>&a_, &b_;
  Places places_;
};

/// How much of a loop has a name.
struct NamedLength {
  std::uint32_t loop;
  double mm;
};

/// Walks along a loop and counts its share of a way.
class Walker {
 public:
  Walker(const LevelLoop& loop, std::uint32_t at, std::uint32_t edges) : loop_(loop), at_(at), left_(edges) {
    for (std::uint32_t k = 0; k < edges; ++k) whole_ += step(at + k);
  }
  bool done() const { return left_ == 0; }
  std::uint32_t at() const { return at_ % size(); }
  const Vec2& point() const { return loop_.points[at()]; }
  const Vec2& ahead() const { return loop_.points[(at_ + 1) % size()]; }
  /// Where the next step ends.
  double shareAhead() const { return whole_ > 0.0 ? (gone_ + step(at_)) / whole_ : 1.0; }
  void go() {
    gone_ += step(at_);
    ++at_;
    --left_;
  }

 private:
  std::uint32_t size() const { return static_cast<std::uint32_t>(loop_.points.size()); }
  double step(std::uint32_t i) const {
    return (loop_.points[(i + 1) % size()] - loop_.points[i % size()]).norm();
  }

  const LevelLoop& loop_;
  std::uint32_t at_, left_;
  double whole_ = 0.0, gone_ = 0.0;
};

/// Shares that differ by less count as equal: there the shorter diagonal decides.
constexpr double kSameShare = 1e-9;

bool lowerGoes(const Walker& a, const Walker& b) {
  if (a.done() || b.done()) return b.done();
  const double ahead = a.shareAhead() - b.shareAhead();
  if (std::abs(ahead) > kSameShare) return ahead < 0.0;
  return (a.ahead() - b.point()).squaredNorm() <= (a.point() - b.ahead()).squaredNorm();
}

/// Adds the rungs behind the first one, by equal shares of both ways.
void zip(Walker a, Walker b, Ribbon& ribbon) {
  while (!a.done() || !b.done()) {
    (lowerGoes(a, b) ? a : b).go();
    ribbon.rungs.emplace_back(a.at(), b.at());
  }
}

/// Some of a loop, and its runs.
struct Chain {
  const LevelLoop& loop;
  LoopSpan span;
  std::vector<Run> runs;

  /// Edges from the start of the chain to that of a run.
  std::uint32_t edgesTo(const Run& run) const {
    const auto n = static_cast<std::uint32_t>(loop.points.size());
    return (run.first + n - span.first) % n;
  }
};

/// How far a chain is joined, edges.
struct Joined {
  std::uint32_t lower = 0, upper = 0;
};

void zipTo(const Joined& to, const Chain& a, const Chain& b, Joined& at, Ribbon& ribbon) {
  PROVEOUT_ASSERT(to.lower >= at.lower && to.upper >= at.upper);
  zip({a.loop, a.span.first + at.lower, to.lower - at.lower},
      {b.loop, b.span.first + at.upper, to.upper - at.upper}, ribbon);
  at = to;
}

/// None: a rung would be there twice, as all of a loop closes up to one point.
std::optional<Ribbon> zipRuns(const Chain& a, const Chain& b) {
  Ribbon ribbon;
  ribbon.rungs.emplace_back(a.span.first, b.span.first);
  Joined at;
  for (const auto& [i, j] : RunAligner(a.runs, b.runs).align()) {
    const Run &in_a = a.runs[i], &in_b = b.runs[j];
    const Joined start{a.edgesTo(in_a), b.edgesTo(in_b)};
    zipTo(start, a, b, at, ribbon);
    ribbon.starts.push_back(ribbon.rungs.size() - 1);
    zipTo({start.lower + in_a.count, start.upper + in_b.count}, a, b, at, ribbon);
  }
  zipTo({a.span.edges, b.span.edges}, a, b, at, ribbon);
  PROVEOUT_ASSERT(ribbon.rungs.size() == std::size_t{1} + a.span.edges + b.span.edges);
  const bool whole = ribbon.rungs.size() > 1 && ribbon.rungs.back() == ribbon.rungs.front();
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sorted(ribbon.rungs.begin(),
                                                              ribbon.rungs.end() - (whole ? 1 : 0));
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return std::nullopt;
  return ribbon;
}

}  // namespace

LoopPairs pairLoops(const LevelSection& lower, const LevelSection& upper) {
  std::unordered_map<WallName, std::vector<NamedLength>> upper_of;
  for (std::uint32_t k = 0; k < upper.loops.size(); ++k) {
    for (const Run& run : runsOf(upper.loops[k])) {
      std::vector<NamedLength>& loops = upper_of[run.name];
      if (loops.empty() || loops.back().loop != k) loops.push_back({k, 0.0});
      loops.back().mm += lengthOf(upper.loops[k], run);
    }
  }
  struct Best {
    double common = 0.0;
    std::uint32_t loop = 0;
  };
  std::vector<Best> for_lower(lower.loops.size()), for_upper(upper.loops.size());
  for (std::uint32_t i = 0; i < lower.loops.size(); ++i) {
    std::unordered_map<WallName, double> own;
    for (const Run& run : runsOf(lower.loops[i])) own[run.name] += lengthOf(lower.loops[i], run);
    std::vector<double> common(upper.loops.size(), 0.0);
    for (const auto& [name, mm] : own) {
      const auto found = upper_of.find(name);
      if (found == upper_of.end()) continue;
      for (const NamedLength& there : found->second) common[there.loop] += std::min(mm, there.mm);
    }
    for (std::uint32_t k = 0; k < upper.loops.size(); ++k) {
      if (common[k] > for_lower[i].common) for_lower[i] = {common[k], k};
      if (common[k] > for_upper[k].common) for_upper[k] = {common[k], i};
    }
  }
  LoopPairs out;
  std::vector<bool> taken(upper.loops.size());
  for (std::uint32_t i = 0; i < lower.loops.size(); ++i) {
    const Best& best = for_lower[i];
    if (best.common > 0.0 && for_upper[best.loop].loop == i) {
      out.pairs.emplace_back(i, best.loop);
      taken[best.loop] = true;
    } else {
      out.lower_alone.push_back(i);
    }
  }
  for (std::uint32_t k = 0; k < upper.loops.size(); ++k) {
    if (!taken[k]) out.upper_alone.push_back(k);
  }
  PROVEOUT_ASSERT(out.pairs.size() + out.lower_alone.size() == lower.loops.size() &&
                  out.pairs.size() + out.upper_alone.size() == upper.loops.size());
  return out;
}

std::uint32_t endOf(const LevelLoop& loop, const LoopSpan& span) {
  return (span.first + span.edges) % static_cast<std::uint32_t>(loop.points.size());
}

std::optional<Ribbon> ribbonBetween(const LevelLoop& lower, const LevelLoop& upper) {
  std::vector<Run> a = runsOf(lower), b = runsOf(upper);
  if (!rotateTogether(a, b, lower)) return std::nullopt;
  const LoopSpan all_a{a.front().first, static_cast<std::uint32_t>(lower.points.size())},
      all_b{b.front().first, static_cast<std::uint32_t>(upper.points.size())};
  return zipRuns({lower, all_a, std::move(a)}, {upper, all_b, std::move(b)});
}

std::optional<Ribbon> ribbonBetween(const LevelLoop& lower, const LoopSpan& lower_span,
                                    const LevelLoop& upper, const LoopSpan& upper_span) {
  return zipRuns({lower, lower_span, runsOf(lower, lower_span)},
                 {upper, upper_span, runsOf(upper, upper_span)});
}

bool isUpright(const Ribbon& ribbon, const LevelLoop& lower, const LevelLoop& upper) {
  return std::all_of(ribbon.rungs.begin(), ribbon.rungs.end(), [&](const auto& rung) {
    return (upper.points[rung.second] - lower.points[rung.first]).norm() <= kRungMm;
  });
}

}  // namespace proveout
