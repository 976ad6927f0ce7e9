#include "removal/wire/lean/lean_levels.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <unordered_set>
#include <utility>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"
#include "removal/wire/lean/wall_parts.h"

namespace proveout {
namespace {

/// Slabs thinner than twice this are not halved any more, mm.
constexpr double kThinnest = 5e-4;

/// Most rounds in which walls are divided: each finds out where they must not be.
constexpr int kMostRounds = 12;
/// How often heights are halved where walls run through each other, at most; and so that this does not help.
constexpr int kMostFiner = 6, kMostWorse = 2;

/// Most points of sections that are kept although no level uses them: 30 MB.
constexpr std::size_t kMostSpare = 1'000'000;

using Names = std::unordered_set<WallName>;

void addNames(const LevelLoop& loop, Names& names) { names.insert(loop.names.begin(), loop.names.end()); }

bool hasAny(const LevelLoop& loop, const Names& names) {
  return std::any_of(loop.names.begin(), loop.names.end(),
                     [&](WallName name) { return names.contains(name); });
}

class LevelMaker {
 public:
  LevelMaker(const SectionMaker& section, double tolerance, Progress& progress)
      : section_(section), tolerance_(tolerance), progress_(progress) {}

  Status make(double low, double high, const LevelsUse& use) {
    std::size_t least = std::numeric_limits<std::size_t>::max();
    for (int tries = 0, worse = 0;; ++tries) {
      for (const double z : {low, high}) sections_[z] = sectionAt(z);
      if (const Status done = settleRounds(low, high); !done) return done;
      LeanLevels made = take();
      const Result<std::vector<CrossedTriangle>> found = use(made);
      if (!found && tries == 0) return found.error();
      worse += !found || found->size() >= least ? 1 : 0;
      if (!found || found->empty() || tries == kMostFiner || worse == kMostWorse) return Done{};
      least = std::min(least, found->size());
      crossed_.add(*found);
      for (LevelSection& level : made.levels) sections_[level.z] = std::move(level);
      for (Sections* sections : {&sections_, &spare_})
        std::erase_if(*sections, [&](const auto& section) { return crossed_.at(section.first); });
    }
  }

 private:
  using Sections = std::map<double, LevelSection>;
  using Loops = std::vector<bool>;  ///< of a section: those that are asked about
  /// A wall of which some is settled.
  struct OpenWall {
    std::uint32_t lower, upper;  ///< loops
    std::vector<WallPart> parts;
  };
  struct Task {
    double from, to;
    Loops lower, upper;
    std::vector<OpenWall> open;
  };
  /// Between these heights what has one of the names must not be parted.
  struct Trouble {
    double from, to;
    Names names;
  };
  struct Try {
    LevelSlab slab;
    LevelSection middle;
    std::optional<LevelSection> quarter;  ///< if it was asked for
    struct Pass {
      std::uint32_t loop;  ///< of the middle
      double z;            ///< of the other
      std::uint32_t other;
    };
    std::vector<Pass> passed;
    /// Loops whose walls need the middle.
    std::vector<std::uint32_t> lower_left, upper_left, middle_left;
    std::vector<OpenWall> below, above;  ///< what is left of parted walls
    struct Split {
      std::uint32_t lower_loop, middle_loop, upper_loop;
      SplitRung rung;
    };
    std::vector<Split> splits;
    struct Curve {
      std::uint32_t lower_loop, upper_loop;
      CurvedRung rung;
    };
    std::vector<Curve> curves;
    std::vector<Trouble> troubles;

    bool needsMiddle() const {
      return !lower_left.empty() || !upper_left.empty() || !middle_left.empty() || !below.empty();
    }
  };
  /// What an attempt knows of the sections that it compares.
  struct Setting {
    const Task& task;
    const LevelSection &lower, &upper;
    bool thin;
    std::vector<std::uint32_t> middle_of_lower, middle_of_upper;
    LoopPairs to_lower, to_upper;  ///< pairs of lower and middle, of middle and upper
    Names alone;                   ///< of loops that end or begin between the heights
    std::function<const RunStarts*(std::uint32_t lower)> quarter;
  };

  Status settleRounds(double low, double high) {
    for (int round = 0;; ++round) {
      parts_ = round < kMostRounds;
      slabs_.clear();
      passed_.clear();
      splits_.clear();
      curves_.clear();
      used_ = {low, high};
      if (const Status done = settleAll(low, high); !done || !failed_) return done;
    }
  }

  Status settleAll(double low, double high) {
    failed_ = false;
    std::vector<Task> open{{low, high, allOf(sections_[low]), allOf(sections_[high]), {}}};
    double done = 0.0;
    while (!open.empty()) {
      if (progress_.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted"};
      std::vector<Try> tries(open.size());
      parallelFor(std::size_t{0}, open.size(), [&](std::size_t k) { tries[k] = attempt(open[k]); });
      for (Try& tried : tries) {
        failed_ = failed_ || !tried.troubles.empty();
        std::move(tried.troubles.begin(), tried.troubles.end(), std::back_inserter(troubles_));
      }
      std::vector<Task> next;
      for (std::size_t k = 0; k < open.size(); ++k) {
        const bool needed = tries[k].needsMiddle();
        if (needed)
          divide(open[k], tries[k], next);
        else
          done += open[k].to - open[k].from;
        keep(open[k], std::move(tries[k]), needed);
      }
      if (failed_) break;
      open = std::move(next);
      progress_.report("removing", done / (high - low));
    }
    return Done{};
  }

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

  LevelSection sectionAt(double z) const {
    for (const Sections* sections : {&sections_, &spare_}) {
      const auto known = sections->find(z);
      if (known != sections->end()) return known->second;
    }
    return section_(z, crossed_.at(z) ? ThinPlaces::kGo : ThinPlaces::kStay);
  }

  /// Loops of both sections whose walls are asked about, wholly or in part.
  static std::pair<Loops, Loops> notSettled(const Task& task) {
    std::pair<Loops, Loops> out(task.lower, task.upper);
    for (const OpenWall& wall : task.open) out.first[wall.lower] = out.second[wall.upper] = true;
    return out;
  }

  Setting settingOf(const Task& task, const LevelSection& middle) const {
    Setting set{task,
                sections_.at(task.from),
                sections_.at(task.to),
                task.to - task.from < 2.0 * kThinnest,
                {},
                {},
                {},
                {},
                {},
                {}};
    set.to_lower = pairLoops(set.lower, middle);
    set.to_upper = pairLoops(middle, set.upper);
    set.middle_of_lower.assign(set.lower.loops.size(), kNone);
    set.middle_of_upper.assign(set.upper.loops.size(), kNone);
    for (const auto& [i, m] : set.to_lower.pairs) set.middle_of_lower[i] = m;
    for (const auto& [m, k] : set.to_upper.pairs) set.middle_of_upper[k] = m;
    for (const std::uint32_t m : set.to_lower.upper_alone) addNames(middle.loops[m], set.alone);
    for (const std::uint32_t m : set.to_upper.lower_alone) addNames(middle.loops[m], set.alone);
    const auto [lower, upper] = notSettled(task);
    for (const std::uint32_t i : set.to_lower.lower_alone)
      if (lower[i]) addNames(set.lower.loops[i], set.alone);
    for (const std::uint32_t k : set.to_upper.upper_alone)
      if (upper[k]) addNames(set.upper.loops[k], set.alone);
    return set;
  }

  /// The middle's loop of a wall, if both others say the same one.
  static std::uint32_t middleOf(const Setting& set, std::uint32_t lower, std::uint32_t upper) {
    const std::uint32_t m = set.middle_of_lower[lower];
    return m == set.middle_of_upper[upper] ? m : kNone;
  }

  static double middleOf(const Task& task) { return 0.5 * (task.from + task.to); }
  /// The middle of the lower half.
  static double quarterOf(const Task& task) { return 0.5 * (task.from + middleOf(task)); }

  Try attempt(const Task& task) const {
    Try out;
    out.middle = sectionAt(middleOf(task));
    Setting set = settingOf(task, out.middle);
    std::vector<std::optional<RunStarts>> quarter_of;
    set.quarter = [&](std::uint32_t lower) -> const RunStarts* {
      if (!out.quarter) {
        out.quarter = sectionAt(quarterOf(task));
        quarter_of.resize(set.lower.loops.size());
        for (const auto& [i, q] : pairLoops(set.lower, *out.quarter).pairs)
          quarter_of[i].emplace(out.quarter->loops[q]);
      }
      return quarter_of[lower] ? &*quarter_of[lower] : nullptr;
    };
    const LoopPairs ends = among(pairLoops(set.lower, set.upper), task.lower, task.upper);
    out.lower_left = ends.lower_alone;
    out.upper_left = ends.upper_alone;
    const bool whole = ends.lower_alone.empty() && ends.upper_alone.empty();
    Loops passed(out.middle.loops.size(), false);
    for (const auto& [i, k] : ends.pairs) tryWall(set, i, k, whole, passed, out);
    for (const OpenWall& wall : task.open) tryOpenWall(set, wall, passed, out);
    if (set.thin) {
      out.slab.lower_alone = std::move(out.lower_left);
      out.slab.upper_alone = std::move(out.upper_left);
      out.lower_left.clear();
      out.upper_left.clear();
      return out;
    }
    for (const auto& [i, m] : set.to_lower.pairs) passElsewhere(task.lower[i], i, m, task.from, passed, out);
    for (const auto& [m, k] : set.to_upper.pairs) passElsewhere(task.upper[k], k, m, task.to, passed, out);
    for (std::uint32_t m = 0; m < out.middle.loops.size(); ++m)
      if (!passed[m]) out.middle_left.push_back(m);
    return out;
  }

  /// A wall that is asked about as a whole.
  void tryWall(const Setting& set, std::uint32_t i, std::uint32_t k, bool whole, Loops& passed,
               Try& out) const {
    const std::uint32_t m = set.middle_of_lower[i];
    WallVerdict verdict;
    const bool finer = crossed_.within(set.task.from, set.task.to, set.lower.loops[i], set.upper.loops[k]);
    if (m != kNone && !finer) {
      const RunStarts middle(out.middle.loops[m]);
      verdict = judgeWall({set.lower.loops[i], middle, set.upper.loops[k], [&] { return set.quarter(i); }},
                          tolerance_, !set.thin && whole && mayPart(set, i, k));
    }
    if (verdict.settled.empty() && set.thin && whole) {
      std::optional<Ribbon> ribbon = ribbonBetween(set.lower.loops[i], set.upper.loops[k]);
      if (ribbon && isUpright(*ribbon, set.lower.loops[i], set.upper.loops[k]))
        verdict.settled.push_back(std::move(*ribbon));
    }
    if (verdict.settled.empty()) {
      out.lower_left.push_back(i);
      out.upper_left.push_back(k);
      return;
    }
    take(set, i, k, m, std::move(verdict), passed, out);
  }

  bool mayPart(const Setting& set, std::uint32_t i, std::uint32_t k) const {
    if (!parts_ || middleOf(set, i, k) == kNone) return false;
    const LevelLoop &lower = set.lower.loops[i], &upper = set.upper.loops[k];
    if (!set.alone.empty() && (hasAny(lower, set.alone) || hasAny(upper, set.alone))) return false;
    return std::none_of(troubles_.begin(), troubles_.end(), [&](const Trouble& trouble) {
      return trouble.from < set.task.to && trouble.to > set.task.from &&
             (hasAny(lower, trouble.names) || hasAny(upper, trouble.names));
    });
  }

  /// What is left of a parted wall.
  void tryOpenWall(const Setting& set, const OpenWall& wall, Loops& passed, Try& out) const {
    const LevelLoop &lower = set.lower.loops[wall.lower], &upper = set.upper.loops[wall.upper];
    const std::uint32_t m = middleOf(set, wall.lower, wall.upper);
    WallVerdict all;
    all.failed = !set.alone.empty() && (hasAny(lower, set.alone) || hasAny(upper, set.alone));
    all.failed = all.failed || (m == kNone && !set.thin);
    // At the last heights the middle is not asked for.
    const RunStarts middle(m == kNone ? lower : out.middle.loops[m]);
    for (const WallPart& part : wall.parts) {
      if (all.failed) break;
      const bool finer = crossed_.within(set.task.from, set.task.to, lower, part.lower, upper, part.upper);
      WallVerdict verdict =
          judgePart({lower, middle, upper, [&] { return set.quarter(wall.lower); }}, part, tolerance_,
                    finer      ? PartWish::kHalved
                    : set.thin ? PartWish::kLast
                               : PartWish::kTrue);
      all.failed = verdict.failed;
      std::move(verdict.settled.begin(), verdict.settled.end(), std::back_inserter(all.settled));
      all.open.insert(all.open.end(), verdict.open.begin(), verdict.open.end());
      all.splits.insert(all.splits.end(), verdict.splits.begin(), verdict.splits.end());
      all.curved.insert(all.curved.end(), verdict.curved.begin(), verdict.curved.end());
    }
    if (all.failed) {
      Trouble& trouble = out.troubles.emplace_back(Trouble{set.task.from, set.task.to, Names{}});
      addNames(lower, trouble.names);
      return;
    }
    take(set, wall.lower, wall.upper, m, std::move(all), passed, out);
  }

  static void take(const Setting& set, std::uint32_t i, std::uint32_t k, std::uint32_t m,
                   WallVerdict&& verdict, Loops& passed, Try& out) {
    for (Ribbon& ribbon : verdict.settled) {
      ribbon.lower_loop = i;
      ribbon.upper_loop = k;
      out.slab.ribbons.push_back(std::move(ribbon));
    }
    for (const SplitRung& rung : verdict.splits) out.splits.push_back({i, m, k, rung});
    for (const CurvedRung& rung : verdict.curved) out.curves.push_back({i, k, rung});
    if (m != kNone) passed[m] = true;
    if (!verdict.open.empty()) {
      OpenWall &below = out.below.emplace_back(OpenWall{i, m, {}}),
               &above = out.above.emplace_back(OpenWall{m, k, {}});
      for (const OpenPart& part : verdict.open) {
        below.parts.push_back({part.lower, part.middle});
        above.parts.push_back({part.middle, part.upper});
      }
      return;
    }
    if (m != kNone) out.passed.push_back({m, set.task.from, i});
    const double a = areaOf(set.lower.loops[i]), b = areaOf(set.upper.loops[k]);
    const double half_way = m != kNone ? areaOf(out.middle.loops[m]) : 0.5 * (a + b);
    out.slab.volumes.push_back({i, (set.task.to - set.task.from) / 6.0 * (a + 4.0 * half_way + b)});
  }

  /// A loop of the middle whose wall was settled before, over more height, by that of the section at z.
  static void passElsewhere(bool asked, std::uint32_t loop, std::uint32_t m, double z, Loops& passed,
                            Try& out) {
    if (asked || passed[m]) return;
    passed[m] = true;
    out.passed.push_back({m, z, loop});
  }

  static void divide(const Task& task, Try& tried, std::vector<Task>& next) {
    const double middle = tried.middle.z;
    const Loops in_middle = only(tried.middle.loops.size(), tried.middle_left);
    next.push_back(
        {task.from, middle, only(task.lower.size(), tried.lower_left), in_middle, std::move(tried.below)});
    next.push_back(
        {middle, task.to, in_middle, only(task.upper.size(), tried.upper_left), std::move(tried.above)});
  }

  void keep(const Task& task, Try&& tried, bool needed) {
    const double middle = tried.middle.z;
    for (const auto& [loop, z, other] : tried.passed) passed_.push_back({middle, loop, z, other});
    for (const auto& [lower, m, upper, rung] : tried.splits)
      splits_.push_back(
          {{task.from, lower, rung.lower}, {middle, m, rung.middle}, {task.to, upper, rung.upper}});
    for (const auto& [lower, upper, rung] : tried.curves)
      curves_.push_back({{task.from, lower, rung.lower}, {task.to, upper, rung.upper}, rung});
    if (needed) {
      used_.insert(middle);
      sections_[middle] = std::move(tried.middle);
    } else {
      spare(middle, std::move(tried.middle));
    }
    if (tried.quarter) spare(quarterOf(task), std::move(*tried.quarter));
    LevelSlab& slab = tried.slab;
    if (slab.ribbons.empty() && slab.volumes.empty() && slab.lower_alone.empty() && slab.upper_alone.empty())
      return;
    slabs_.push_back({task.from, task.to, std::move(slab)});
  }

  /// Keeps what the lower half, or the next round, may ask for.
  void spare(double z, LevelSection&& section) {
    std::size_t points = 0;
    for (const LevelLoop& loop : section.loops) points += loop.points.size();
    if (spare_points_ + points > kMostSpare || sections_.contains(z) || spare_.contains(z)) return;
    spare_points_ += points;
    spare_[z] = std::move(section);
  }

  LeanLevels take() {
    LeanLevels out;
    std::map<double, std::uint32_t> number;
    for (const double z : used_) {
      number[z] = static_cast<std::uint32_t>(out.levels.size());
      out.levels.push_back(std::move(sections_.at(z)));
    }
    std::sort(slabs_.begin(), slabs_.end(), [](const Placed& a, const Placed& b) {
      return a.from != b.from ? a.from < b.from : a.to < b.to;
    });
    for (Placed& placed : slabs_) {
      placed.slab.lower = number.at(placed.from);
      placed.slab.upper = number.at(placed.to);
      PROVEOUT_ASSERT(placed.slab.lower < placed.slab.upper);
      out.slabs.push_back(std::move(placed.slab));
    }
    for (const Passed& p : passed_) {
      const auto level = number.find(p.z);
      if (level != number.end()) out.passed.push_back({level->second, p.loop, number.at(p.other_z), p.other});
    }
    const auto at = [&](const PlacedPoint& p) { return LevelPoint{number.at(p.z), p.loop, p.point}; };
    for (const auto& [lower, middle, upper] : splits_)
      out.splits.push_back({at(lower), at(middle), at(upper)});
    for (const auto& [lower, upper, rung] : curves_)
      out.curves.push_back({at(lower), at(upper), rung.middle, rung.rows, rung.between});
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
  struct PlacedPoint {
    double z;
    std::uint32_t loop, point;
  };
  struct PlacedSplit {
    PlacedPoint lower, middle, upper;
  };
  struct PlacedCurve {
    PlacedPoint lower, upper;
    CurvedRung rung;
  };
  const SectionMaker& section_;
  double tolerance_;
  Progress& progress_;
  Sections sections_;  ///< all that were ever kept
  Sections spare_;     ///< and some that were not
  std::size_t spare_points_ = 0;
  std::vector<Trouble> troubles_;  ///< of all rounds
  bool parts_ = true;              ///< walls may be parted
  bool failed_ = false;            ///< this round, for troubles that were not known
  CrossedWalls crossed_;           ///< by the meshes that were made of it before
  // Of this round:
  std::set<double> used_;
  std::vector<Placed> slabs_;
  std::vector<Passed> passed_;
  std::vector<PlacedSplit> splits_;
  std::vector<PlacedCurve> curves_;
};

}  // namespace

Status leanLevels(const SectionMaker& section, double low, double high, double tolerance,
                  const LevelsUse& use, Progress& progress) {
  return LevelMaker(section, tolerance, progress).make(low, high, use);
}

}  // namespace proveout
