#include "removal/wire/level_match.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace proveout {
namespace {

/// Names that are looked ahead for one that both loops have.
constexpr std::size_t kLookAhead = 512;

/// Edges of a loop that follow each other and have one name.
struct Run {
  WallName name;
  std::uint32_t first, count;  ///< from point `first` on, `count` edges
};

std::vector<Run> runsOf(const LevelLoop& loop) {
  const auto n = static_cast<std::uint32_t>(loop.points.size());
  std::uint32_t start = 0;
  while (start < n && loop.names[start] == loop.names[(start + n - 1) % n]) ++start;
  if (start == n) return {{loop.names[0], 0, n}};
  std::vector<Run> runs;
  for (std::uint32_t k = 0; k < n; ++k) {
    const std::uint32_t i = (start + k) % n;
    if (!runs.empty() && runs.back().name == loop.names[i])
      ++runs.back().count;
    else
      runs.push_back({loop.names[i], i, 1});
  }
  return runs;
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

/// Pairs of runs with one name, in the order of both loops, and the first of them: the longest whose name
/// comes once.
class RunAligner {
 public:
  RunAligner(const LevelLoop& a, const LevelLoop& b) : a_(runsOf(a)), b_(runsOf(b)), loop_(a) {}

  bool align() {
    if (!rotate()) return false;
    const Places places = placesOf(b_);
    std::size_t i = 0, j = 0;
    matched_.emplace_back(0, 0);
    while (next(places, i, j)) matched_.emplace_back(i, j);
    return true;
  }
  const std::vector<std::pair<std::size_t, std::size_t>>& matched() const { return matched_; }
  const std::vector<Run>& lower() const { return a_; }
  const std::vector<Run>& upper() const { return b_; }

 private:
  bool rotate() {
    const Places in_a = placesOf(a_), in_b = placesOf(b_);
    double longest = -1.0;
    std::size_t at_a = 0, at_b = 0;
    for (std::size_t i = 0; i < a_.size(); ++i) {
      const auto found = in_b.find(a_[i].name);
      if (found == in_b.end()) continue;
      const bool once = in_a.at(a_[i].name).size() == 1 && found->second.size() == 1;
      const double length = once ? lengthOf(loop_, a_[i]) : 0.0;
      if (length <= longest) continue;
      longest = length;
      at_a = i;
      at_b = found->second.front();
    }
    if (longest < 0.0) return false;
    std::rotate(a_.begin(), a_.begin() + static_cast<std::ptrdiff_t>(at_a), a_.end());
    std::rotate(b_.begin(), b_.begin() + static_cast<std::ptrdiff_t>(at_b), b_.end());
    return true;
  }

  /// The next pair behind i and j that skips least.
  bool next(const Places& places, std::size_t& i, std::size_t& j) const {
    std::size_t least = kLookAhead, to_i = 0, to_j = 0;
    for (std::size_t skip = 0; skip < least && i + 1 + skip < a_.size(); ++skip) {
      const auto found = places.find(a_[i + 1 + skip].name);
      if (found == places.end()) continue;
      const auto place = std::upper_bound(found->second.begin(), found->second.end(), j);
      if (place == found->second.end() || skip + (*place - j - 1) >= least) continue;
      least = skip + (*place - j - 1);
      to_i = i + 1 + skip;
      to_j = *place;
    }
    if (least == kLookAhead) return false;
    i = to_i;
    j = to_j;
    return true;
  }

  std::vector<Run> a_, b_;
  const LevelLoop& loop_;
  std::vector<std::pair<std::size_t, std::size_t>> matched_;
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

/// Shares that differ by less are one: there the shorter diagonal decides.
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

std::uint32_t edgesBetween(std::uint32_t from, std::uint32_t to, const LevelLoop& loop) {
  const auto n = static_cast<std::uint32_t>(loop.points.size());
  return (to + n - from) % n;
}

}  // namespace

LoopPairs pairLoops(const LevelSection& lower, const LevelSection& upper) {
  std::unordered_map<WallName, std::vector<std::uint32_t>> upper_of;
  for (std::uint32_t k = 0; k < upper.loops.size(); ++k) {
    for (const Run& run : runsOf(upper.loops[k])) {
      std::vector<std::uint32_t>& loops = upper_of[run.name];
      if (loops.empty() || loops.back() != k) loops.push_back(k);
    }
  }
  struct Best {
    std::size_t common = 0;
    std::uint32_t loop = 0;
  };
  std::vector<Best> for_lower(lower.loops.size()), for_upper(upper.loops.size());
  for (std::uint32_t i = 0; i < lower.loops.size(); ++i) {
    std::unordered_map<std::uint32_t, std::size_t> common;
    for (const Run& run : runsOf(lower.loops[i])) {
      const auto found = upper_of.find(run.name);
      if (found == upper_of.end()) continue;
      for (const std::uint32_t k : found->second) ++common[k];
    }
    for (std::uint32_t k = 0; k < upper.loops.size(); ++k) {
      const auto found = common.find(k);
      if (found == common.end()) continue;
      if (found->second > for_lower[i].common) for_lower[i] = {found->second, k};
      if (found->second > for_upper[k].common) for_upper[k] = {found->second, i};
    }
  }
  LoopPairs out;
  std::vector<bool> taken(upper.loops.size());
  for (std::uint32_t i = 0; i < lower.loops.size(); ++i) {
    const Best& best = for_lower[i];
    if (best.common > 0 && for_upper[best.loop].loop == i) {
      out.pairs.emplace_back(i, best.loop);
      taken[best.loop] = true;
    } else {
      out.lower_alone.push_back(i);
    }
  }
  for (std::uint32_t k = 0; k < upper.loops.size(); ++k) {
    if (!taken[k]) out.upper_alone.push_back(k);
  }
  return out;
}

std::optional<Ribbon> ribbonBetween(const LevelSection& lower, std::uint32_t lower_loop,
                                    const LevelSection& upper, std::uint32_t upper_loop) {
  const LevelLoop &a = lower.loops[lower_loop], &b = upper.loops[upper_loop];
  RunAligner aligner(a, b);
  if (!aligner.align()) return std::nullopt;
  Ribbon ribbon;
  ribbon.lower_loop = lower_loop;
  ribbon.upper_loop = upper_loop;
  const Run &first_a = aligner.lower().front(), &first_b = aligner.upper().front();
  ribbon.rungs.emplace_back(first_a.first, first_b.first);
  for (const auto& [i, j] : aligner.matched()) {
    const Run &in_a = aligner.lower()[i], &in_b = aligner.upper()[j];
    const auto [at_a, at_b] = ribbon.rungs.back();
    zip({a, at_a, edgesBetween(at_a, in_a.first, a)}, {b, at_b, edgesBetween(at_b, in_b.first, b)}, ribbon);
    zip({a, in_a.first, in_a.count}, {b, in_b.first, in_b.count}, ribbon);
  }
  // What is left until both loops close, unless one run was all of a loop.
  const auto [at_a, at_b] = ribbon.rungs.back();
  zip({a, at_a, edgesBetween(at_a, first_a.first, a)}, {b, at_b, edgesBetween(at_b, first_b.first, b)},
      ribbon);
  if (ribbon.rungs.size() > 1 && ribbon.rungs.back() == ribbon.rungs.front()) ribbon.rungs.pop_back();
  // A rung twice: all of a loop closed up to one point.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sorted = ribbon.rungs;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return std::nullopt;
  return ribbon;
}

}  // namespace proveout
