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

/// By how much a corner may be off: the tip of a needle, of material or of a gap, moves fast with the height,
/// and may be missing as far as the needle is thinner than the tolerance.
double allowedAt(const Outline& points, std::size_t i, double tolerance) {
  const std::size_t n = points.size();
  const Vec2 u = points[(i + n - 1) % n] - points[i], v = points[(i + 1) % n] - points[i];
  const double lengths = u.norm() * v.norm();
  if (lengths == 0.0) return tolerance;
  const double cosine = std::clamp(u.dot(v) / lengths, -1.0, 1.0);
  const double half_tangent = std::sqrt((1.0 - cosine) / (1.0 + cosine + 1e-12));
  const double needle = tolerance / (2.0 * half_tangent + 1e-9);
  return std::max(tolerance, std::min(needle, 0.5 * std::min(u.norm(), v.norm())));
}

bool staysBy(const Outline& points, const std::vector<WireStretch>& sides, double tolerance) {
  const StretchIndex index(sides);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (index.nearest(points[i], tolerance).stretch != StretchIndex::kNone) continue;
    const double allowed = allowedAt(points, i, tolerance);
    if (allowed <= tolerance || index.nearest(points[i], allowed).stretch == StretchIndex::kNone)
      return false;
  }
  return true;
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
    std::vector<Task> open{{low, high, allOf(sections_[low]), allOf(sections_[high])}};
    double done = 0.0;
    while (!open.empty()) {
      if (progress_.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted"};
      std::vector<Try> tries(open.size());
      parallelFor(std::size_t{0}, open.size(), [&](std::size_t k) { tries[k] = attempt(open[k]); });
      std::vector<Task> next;
      for (std::size_t k = 0; k < open.size(); ++k) {
        if (tries[k].lower_left.empty() && tries[k].upper_left.empty() && tries[k].middle_left.empty())
          done += open[k].to - open[k].from;
        else
          divide(open[k], tries[k], next);
        keep(open[k], std::move(tries[k]));
      }
      open = std::move(next);
      progress_.report("removing", done / (high - low));
    }
    return take();
  }

 private:
  using Loops = std::vector<bool>;  ///< of a section: those that are asked about
  struct Task {
    double from, to;
    Loops lower, upper;
  };
  struct Try {
    LevelSlab slab;
    LevelSection middle;
    struct Pass {
      std::uint32_t loop;  ///< of the middle
      double z;            ///< of the other
      std::uint32_t other;
    };
    std::vector<Pass> passed;
    /// Loops whose walls need the middle.
    std::vector<std::uint32_t> lower_left, upper_left, middle_left;
  };

  static Loops allOf(const LevelSection& section) { return Loops(section.loops.size(), true); }
  static Loops only(std::size_t count, const std::vector<std::uint32_t>& loops) {
    Loops out(count, false);
    for (const std::uint32_t k : loops) out[k] = true;
    return out;
  }

  /// Pairs and loops alone among those that are asked about.
  static LoopPairs among(const LoopPairs& all, const Loops& in_a, const Loops& in_b) {
    LoopPairs out;
    for (const auto& [i, k] : all.pairs) {
      if (in_a[i] && in_b[k]) {
        out.pairs.emplace_back(i, k);
        continue;
      }
      if (in_a[i]) out.lower_alone.push_back(i);
      if (in_b[k]) out.upper_alone.push_back(k);
    }
    for (const std::uint32_t i : all.lower_alone)
      if (in_a[i]) out.lower_alone.push_back(i);
    for (const std::uint32_t k : all.upper_alone)
      if (in_b[k]) out.upper_alone.push_back(k);
    return out;
  }

  Try attempt(const Task& task) const {
    const LevelSection &lower = sections_.at(task.from), &upper = sections_.at(task.to);
    const bool thin = task.to - task.from < 2.0 * kThinnest;
    Try out;
    out.middle = section_(0.5 * (task.from + task.to));
    const LoopPairs ends = among(pairLoops(lower, upper), task.lower, task.upper);
    const LoopPairs half = pairLoops(lower, out.middle);
    const bool whole = ends.lower_alone.empty() && ends.upper_alone.empty();
    std::vector<std::uint32_t> middle_of(lower.loops.size(), kNone);
    for (const auto& [i, m] : half.pairs) middle_of[i] = m;
    out.lower_left = ends.lower_alone;
    out.upper_left = ends.upper_alone;
    Loops passed(out.middle.loops.size(), false);
    for (const auto& [i, k] : ends.pairs) {
      std::optional<Ribbon> ribbon = ribbonBetween(lower, i, upper, k);
      const std::uint32_t m = middle_of[i];
      const bool near = ribbon && m != kNone &&
                        areNear(middleOf(*ribbon, lower, upper), out.middle.loops[m].points, tolerance_);
      if (!near && !(thin && whole && ribbon)) {
        out.lower_left.push_back(i);
        out.upper_left.push_back(k);
        continue;
      }
      if (m != kNone) {
        passed[m] = true;
        out.passed.push_back({m, task.from, i});
      }
      const double a = areaOf(lower.loops[i]), b = areaOf(upper.loops[k]);
      const double half_way = m != kNone ? areaOf(out.middle.loops[m]) : 0.5 * (a + b);
      out.slab.ribbons.push_back(std::move(*ribbon));
      out.slab.volumes.push_back((task.to - task.from) / 6.0 * (a + 4.0 * half_way + b));
    }
    if (thin) {
      out.slab.lower_alone = std::move(out.lower_left);
      out.slab.upper_alone = std::move(out.upper_left);
      out.lower_left.clear();
      out.upper_left.clear();
      return out;
    }
    passElsewhere(half, task.lower, task.from, passed, out);
    if (!isAll(task.upper)) passElsewhere(pairLoops(upper, out.middle), task.upper, task.to, passed, out);
    for (std::uint32_t m = 0; m < out.middle.loops.size(); ++m)
      if (!passed[m]) out.middle_left.push_back(m);
    return out;
  }

  static bool isAll(const Loops& asked) {
    return std::all_of(asked.begin(), asked.end(), [](bool in) { return in; });
  }

  /// Finds loops of the middle whose walls were settled before, over more height, by those of a section at
  /// height z.
  static void passElsewhere(const LoopPairs& to_middle, const Loops& asked, double z, Loops& passed,
                            Try& out) {
    for (const auto& [i, m] : to_middle.pairs) {
      if (asked[i] || passed[m]) continue;
      passed[m] = true;
      out.passed.push_back({m, z, i});
    }
  }

  void divide(const Task& task, const Try& tried, std::vector<Task>& next) {
    const double middle = tried.middle.z;
    const Loops in_middle = only(tried.middle.loops.size(), tried.middle_left);
    next.push_back({task.from, middle, only(task.lower.size(), tried.lower_left), in_middle});
    next.push_back({middle, task.to, in_middle, only(task.upper.size(), tried.upper_left)});
  }

  void keep(const Task& task, Try&& tried) {
    const double middle = tried.middle.z;
    for (const auto& [loop, z, other] : tried.passed) passed_.push_back({middle, loop, z, other});
    if (!tried.middle_left.empty() || !tried.lower_left.empty() || !tried.upper_left.empty())
      sections_[middle] = std::move(tried.middle);
    LevelSlab& slab = tried.slab;
    if (slab.ribbons.empty() && slab.lower_alone.empty() && slab.upper_alone.empty()) return;
    slabs_.push_back({task.from, task.to, std::move(slab)});
  }

  Result<LeanLevels> take() {
    LeanLevels out;
    std::map<double, std::uint32_t> number;
    for (auto& [z, section] : sections_) {
      number[z] = static_cast<std::uint32_t>(out.levels.size());
      out.levels.push_back(std::move(section));
    }
    std::sort(slabs_.begin(), slabs_.end(), [](const Placed& a, const Placed& b) {
      return a.from != b.from ? a.from < b.from : a.to < b.to;
    });
    for (Placed& placed : slabs_) {
      placed.slab.lower = number.at(placed.from);
      placed.slab.upper = number.at(placed.to);
      out.slabs.push_back(std::move(placed.slab));
    }
    for (const Passed& p : passed_) {
      const auto level = number.find(p.z);
      if (level != number.end()) out.passed.push_back({level->second, p.loop, number.at(p.other_z), p.other});
    }
    return out;
  }

  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  struct Placed {
    double from, to;
    LevelSlab slab;
  };
  struct Passed {
    double z;
    std::uint32_t loop;
    double other_z;
    std::uint32_t other;
  };
  const std::function<LevelSection(double z)>& section_;
  double tolerance_;
  Progress& progress_;
  std::map<double, LevelSection> sections_;
  std::vector<Placed> slabs_;
  std::vector<Passed> passed_;
};

}  // namespace

Result<LeanLevels> leanLevels(const std::function<LevelSection(double z)>& section, double low, double high,
                              double tolerance, Progress& progress) {
  return LevelMaker(section, tolerance, progress).make(low, high);
}

}  // namespace proveout
