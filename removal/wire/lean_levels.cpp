#include "removal/wire/lean_levels.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/parallel_for.h"
#include "removal/wire/stretch_index.h"

namespace proveout {
namespace {

/// Slabs thinner than twice this are not halved, mm.
constexpr double kThinnest = 5e-4;

using Outline = std::vector<Vec2>;

/// Where the triangles of a wall are half way up.
Outline middleOf(const Ribbon& ribbon, const LevelSection& lower, const LevelSection& upper) {
  Outline points;
  points.reserve(ribbon.rungs.size());
  for (const auto& [i, j] : ribbon.rungs)
    points.push_back(0.5 *
                     (lower.loops[ribbon.lower_loop].points[i] + upper.loops[ribbon.upper_loop].points[j]));
  return points;
}

std::vector<WireStretch> segmentsOf(const Outline& points) {
  std::vector<WireStretch> sides(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    sides[i].from = points[i];
    sides[i].to = points[(i + 1) % points.size()];
  }
  return sides;
}

bool staysBy(const Outline& points, const std::vector<WireStretch>& sides, double tolerance) {
  const StretchIndex index(sides);
  return std::all_of(points.begin(), points.end(), [&](const Vec2& p) {
    return index.nearest(p, tolerance).stretch != StretchIndex::kNone;
  });
}

bool areNear(const Outline& a, const Outline& b, double tolerance) {
  return staysBy(a, segmentsOf(b), tolerance) && staysBy(b, segmentsOf(a), tolerance);
}

class LevelMaker {
 public:
  LevelMaker(const std::function<LevelSection(double z)>& section, double tolerance, Progress& progress)
      : section_(section), tolerance_(tolerance), progress_(progress) {}

  Result<LeanLevels> make(double low, double high) {
    sections_[low] = section_(low);
    sections_[high] = section_(high);
    std::vector<Span> open{{low, high}};
    double done = 0.0;
    while (!open.empty()) {
      if (progress_.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted"};
      std::vector<Try> tries(open.size());
      parallelFor(std::size_t{0}, open.size(), [&](std::size_t k) { tries[k] = attempt(open[k]); });
      std::vector<Span> next;
      for (std::size_t k = 0; k < open.size(); ++k) {
        const auto [from, to] = open[k];
        if (tries[k].good) {
          slabs_[from] = std::move(tries[k].slab);
          done += to - from;
          continue;
        }
        const double middle = tries[k].middle.z;
        sections_[middle] = std::move(tries[k].middle);
        next.emplace_back(from, middle);
        next.emplace_back(middle, to);
      }
      open = std::move(next);
      progress_.report("removing", done / (high - low));
    }
    return take(high);
  }

 private:
  using Span = std::pair<double, double>;
  struct Try {
    bool good = false;
    LevelSlab slab;
    LevelSection middle;
  };

  Try attempt(const Span& span) const {
    const LevelSection &lower = sections_.at(span.first), &upper = sections_.at(span.second);
    const bool thin = span.second - span.first < 2.0 * kThinnest;
    Try out;
    out.middle = section_(0.5 * (span.first + span.second));
    const LoopPairs ends = pairLoops(lower, upper), half = pairLoops(lower, out.middle);
    bool good = ends.lower_alone.empty() && ends.upper_alone.empty() && half.upper_alone.empty() &&
                half.lower_alone.empty();
    if (!good && !thin) return out;
    std::vector<std::uint32_t> middle_of(lower.loops.size(), kNone);
    for (const auto& [i, m] : half.pairs) middle_of[i] = m;
    out.slab.lower_alone = ends.lower_alone;
    out.slab.upper_alone = ends.upper_alone;
    const double height = span.second - span.first;
    for (const auto& [i, k] : ends.pairs) {
      std::optional<Ribbon> ribbon = ribbonBetween(lower, i, upper, k);
      const std::uint32_t m = middle_of[i];
      const bool near = ribbon && m != kNone &&
                        areNear(middleOf(*ribbon, lower, upper), out.middle.loops[m].points, tolerance_);
      if (!near && !thin) return out;
      if (!near && !(good && ribbon)) {
        out.slab.lower_alone.push_back(i);
        out.slab.upper_alone.push_back(k);
        continue;
      }
      const double a = areaOf(lower.loops[i]), b = areaOf(upper.loops[k]);
      const double half_way = m != kNone ? areaOf(out.middle.loops[m]) : 0.5 * (a + b);
      out.slab.ribbons.push_back(std::move(*ribbon));
      out.slab.volumes.push_back(height / 6.0 * (a + 4.0 * half_way + b));
    }
    out.good = true;
    return out;
  }

  Result<LeanLevels> take(double high) {
    LeanLevels out;
    std::map<double, std::uint32_t> number;
    std::vector<double> heights;
    for (const auto& [from, slab] : slabs_) heights.push_back(from);
    heights.push_back(high);
    for (const double z : heights) {
      number[z] = static_cast<std::uint32_t>(out.levels.size());
      out.levels.push_back(std::move(sections_.at(z)));
    }
    for (auto& [from, slab] : slabs_) {
      slab.lower = number.at(from);
      slab.upper = slab.lower + 1;
      out.slabs.push_back(std::move(slab));
    }
    return out;
  }

  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  const std::function<LevelSection(double z)>& section_;
  double tolerance_;
  Progress& progress_;
  std::map<double, LevelSection> sections_;
  std::map<double, LevelSlab> slabs_;  ///< by their lower height
};

}  // namespace

Result<LeanLevels> leanLevels(const std::function<LevelSection(double z)>& section, double low, double high,
                              double tolerance, Progress& progress) {
  return LevelMaker(section, tolerance, progress).make(low, high);
}

}  // namespace proveout
