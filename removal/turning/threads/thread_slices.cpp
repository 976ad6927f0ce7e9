#include "removal/turning/threads/thread_slices.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/assert.h"
#include "core/geometry/ears.h"
#include "removal/turning/section/revolve.h"
#include "removal/turning/threads/thread_group.h"

namespace proveout::thread_detail {

namespace {

/// Edges from this label on were made by thread sweeps.
constexpr MotionId kSweepLabel = 0x40000000;
/// Ends of passes this near to each other have one angle, rad: no slices so thin between them.
constexpr double kSameAngle = 1e-4;
/// Edges shorter than this are none: float coordinates of a mesh could not tell their ends apart, mm.
constexpr double kShortest = 2e-4;
/// A point on an edge is off it by rounding of its ends, mm.
constexpr double kOnEdge = 5e-6;

/// A number for each edge of a loop: the stretch between two points that stay.
std::vector<std::int32_t> runsOf(const SectionLoop& loop, const std::vector<std::size_t>& kept,
                                 std::int32_t first) {
  const std::size_t n = loop.points.size();
  std::vector<std::int32_t> run(n);
  PROVEOUT_ASSERT(!kept.empty() && kept.back() < n);
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const std::size_t end = k + 1 < kept.size() ? kept[k + 1] : kept[0] + n;
    for (std::size_t i = kept[k]; i < end; ++i) run[i % n] = first + static_cast<std::int32_t>(k);
  }
  return run;
}

SectionLoop chordsOf(const ConvexOutline& outline, MotionId motion) {
  SectionLoop loop;
  outline.chain(0.0, 2.0 * kPi, kSectionChordMm, loop.points);
  while (loop.points.size() > 1 && (loop.points.front() - loop.points.back()).norm() < kOnEdge)
    loop.points.pop_back();
  loop.motion.assign(loop.points.size(), motion);
  return loop;
}

bool reachesOverAxis(const ThreadSweep& thread) {
  return std::min(thread.from.x(), thread.to.x()) + thread.outline->min().x() < 0.0;
}

/// Points and the names of the edges behind them, without edges that are none. Points on the axis stay.
void dropShort(std::vector<Vec2>& points, std::vector<EdgeName>& names) {
  const std::vector<Vec2> all = std::move(points);
  const std::vector<EdgeName> old = std::move(names);
  points.clear();
  names.clear();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Vec2& next = all[(i + 1) % all.size()];
    if ((next - all[i]).norm() < kShortest) {
      // The next point takes the place of this one, unless this one lies on the axis.
      if (all[i].x() > 0.0 || next.x() <= 0.0) continue;
    }
    if (!points.empty() && points.back().x() <= 0.0 && all[i].x() > 0.0 &&
        (all[i] - points.back()).norm() < kShortest) {
      names.back() = old[i];
      continue;
    }
    points.push_back(all[i]);
    names.push_back(old[i]);
  }
}

}  // namespace

ThreadSlicer::ThreadSlicer(const SectionBody& body, const std::vector<ThreadSweep>& threads, double tolerance,
                           double thinnest)
    : thinnest_(thinnest) {
  std::vector<SectionLoop> loops = body.loops;
  for (SectionLoop& loop : loops) {
    const std::vector<std::size_t> kept = keptPoints(loop, tolerance);
    const auto first = static_cast<std::int32_t>(of_run_.size());
    for (const std::int32_t run : runsOf(loop, kept, first)) run_.push_back(run);
    for (const MotionId motion : simplified(loop, kept).motion) of_run_.push_back(motion);
    const auto number = static_cast<MotionId>(run_.size() - loop.points.size());
    for (std::size_t i = 0; i < loop.points.size(); ++i) loop.motion[i] = number + static_cast<MotionId>(i);
  }
  section_ = SectionArea(loops);
  for (const std::vector<std::size_t>& group : threadGroups(threads)) addGroup(threads, group, tolerance);
  std::sort(ends_.begin(), ends_.end(), [](const PassEnd& a, const PassEnd& b) { return a.phi < b.phi; });
  for (std::size_t k = 1; k < ends_.size(); ++k) {
    if (ends_[k].phi - ends_[k - 1].phi < kSameAngle) ends_[k].phi = ends_[k - 1].phi;
  }
  // Where one way goes on from another the groove is never filled in between.
  std::stable_sort(ends_.begin(), ends_.end(), [](const PassEnd& a, const PassEnd& b) {
    return a.phi != b.phi ? a.phi < b.phi : a.appears && !b.appears;
  });
}

void ThreadSlicer::addGroup(const std::vector<ThreadSweep>& threads, const std::vector<std::size_t>& group,
                            double tolerance) {
  const auto crosses = [&](std::size_t i) { return reachesOverAxis(threads[i]); };
  if (group.size() > 1 && std::none_of(group.begin(), group.end(), crosses)) {
    GroupOutline all(threads, group);
    for (std::size_t k = 0; k < group.size(); ++k) all.add(k);
    std::vector<SectionLoop> borders = all.borders();
    if (borders.size() == 1) {
      for (MotionId& made_by : borders.front().motion) made_by = threads[group[made_by]].motion;
      addSweep(threads[group.front()], borders.front(), tolerance);
      return;
    }
  }
  for (const std::size_t i : group) addPass(threads[i], tolerance);
}

void ThreadSlicer::addPass(const ThreadSweep& thread, double tolerance) {
  addSweep(thread, chordsOf(*thread.outline, thread.motion), tolerance);
  if (!reachesOverAxis(thread)) return;
  addSweep(thread.acrossAxis(), chordsOf(mirrored(*thread.outline, 0), thread.motion), tolerance);
}

void ThreadSlicer::addSweep(const ThreadSweep& thread, const SectionLoop& outline, double tolerance) {
  if (thread.turns == 0.0) return;
  Sweep sweep{thread, 0.0, 2.0 * kPi * thread.turns, outline.points, {}, {}, {}, {}};
  sweep.thread.outline = nullptr;  // it is not kept; its chords are
  sweep.start = thread.start_rad - 2.0 * kPi * std::floor(thread.start_rad / (2.0 * kPi));
  sweep.low = sweep.high = outline.points.front();
  for (const Vec2& p : outline.points) {
    sweep.low = sweep.low.cwiseMin(p);
    sweep.high = sweep.high.cwiseMax(p);
  }
  SectionLoop beside = outline;  // off the axis, where all points are kept
  for (Vec2& p : beside.points) p.x() += 1.0 - sweep.low.x();
  const std::vector<std::size_t> kept = keptPoints(beside, tolerance);
  sweep.run = runsOf(outline, kept, 0);
  sweep.made_by = simplified(outline, kept).motion;
  sweeps_.push_back(std::move(sweep));
  addEnds(static_cast<std::int32_t>(sweeps_.size()) - 1);
}

void ThreadSlicer::addEnds(std::int32_t number) {
  const Sweep& sweep = sweeps_[static_cast<std::size_t>(number)];
  for (const bool last : {false, true}) {
    if (!reaches(sweep, sweep.thread.at(last ? 1.0 : 0.0))) continue;
    const double angle = sweep.start + (last ? sweep.turn : 0.0);
    double turns = std::floor(angle / (2.0 * kPi));
    double phi = angle - 2.0 * kPi * turns;
    if (phi > 2.0 * kPi - kSameAngle) {
      phi = 0.0;
      turns += 1.0;
    }
    ends_.push_back({phi, number, static_cast<std::int32_t>(turns), (sweep.turn > 0.0) != last});
  }
}

bool ThreadSlicer::reaches(const Sweep& sweep, const Vec2& at) const {
  return ((at + sweep.low).array() < section_.max().array()).all() &&
         ((at + sweep.high).array() > section_.min().array()).all();
}

std::vector<ThreadSlicer::Pass> ThreadSlicer::passes(std::int32_t number, double phi,
                                                     std::span<const PassEnd> ends,
                                                     std::size_t passed) const {
  const Sweep& sweep = sweeps_[static_cast<std::size_t>(number)];
  const double low = sweep.start + std::min(0.0, sweep.turn), high = sweep.start + std::max(0.0, sweep.turn);
  const auto first = static_cast<std::int32_t>(std::floor((low - phi) / (2.0 * kPi))),
             last = static_cast<std::int32_t>(std::ceil((high - phi) / (2.0 * kPi)));
  std::vector<Pass> out;
  for (std::int32_t turn = first; turn <= last; ++turn) {
    const double t = sweep.partAt(phi, turn);
    bool there = t >= 0.0 && t <= 1.0;
    for (std::size_t k = 0; k < ends.size(); ++k) {
      if (ends[k].sweep == number && ends[k].turn == turn) there = (k < passed) == ends[k].appears;
    }
    const Vec2 at = sweep.thread.at(std::clamp(t, 0.0, 1.0));
    if (there && reaches(sweep, at)) out.push_back({turn, at});
  }
  return out;
}

EdgeName ThreadSlicer::nameOf(const Vec2& middle, std::int32_t number, const std::vector<Pass>& passes,
                              Hint& hint) const {
  const Sweep& sweep = sweeps_[static_cast<std::size_t>(number)];
  const std::size_t n = sweep.outline.size();
  const auto off = [&](std::size_t pass, std::size_t chord) {
    return distanceToSegment(middle - passes[pass].at, sweep.outline[chord], sweep.outline[(chord + 1) % n]);
  };
  const auto name = [&] { return EdgeName{number, passes[hint.pass].turn, sweep.run[hint.chord]}; };
  // A groove's border goes against the outline's sense, mostly from one chord to the next.
  for (const std::size_t back : {std::size_t{1}, std::size_t{0}, n - 1}) {
    const std::size_t chord = (hint.chord + n - back) % n;
    if (hint.pass >= passes.size() || off(hint.pass, chord) > kOnEdge) continue;
    hint.chord = chord;
    return name();
  }
  double least = std::numeric_limits<double>::infinity();
  const Vec2 hair = Vec2::Constant(10.0 * kOnEdge);
  for (std::size_t pass = 0; pass < passes.size(); ++pass) {
    const Vec2 p = middle - passes[pass].at;
    if (((p + hair).array() < sweep.low.array()).any() || ((p - hair).array() > sweep.high.array()).any())
      continue;
    for (std::size_t chord = 0; chord < n; ++chord) {
      const double distance = off(pass, chord);
      if (distance >= least) continue;
      least = distance;
      hint = {pass, chord};
    }
  }
  return std::isfinite(least) ? name() : EdgeName{number, 0, -1};
}

Slice ThreadSlicer::slice(double phi, std::span<const PassEnd> ends, std::size_t passed) const {
  Slice out;
  SectionArea area = section_;
  std::vector<std::vector<Pass>> all(sweeps_.size());
  for (std::size_t s = 0; s < sweeps_.size(); ++s) {
    all[s] = passes(static_cast<std::int32_t>(s), phi, ends, passed);
    std::vector<SectionPath> polygons;
    for (const Pass& pass : all[s]) {
      SectionPath& polygon = polygons.emplace_back(sweeps_[s].outline);
      for (Vec2& p : polygon) p += pass.at;
    }
    out.taken_mm3 += area.subtractMany(polygons, kSweepLabel + static_cast<MotionId>(s));
  }
  for (const SectionBody& body : area.bodies()) {
    for (const SectionLoop& loop : body.loops) {
      std::vector<Vec2> points = loop.points;
      std::vector<EdgeName> names(points.size());
      Hint hint;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const MotionId label = loop.motion[i];
        if (label < kSweepLabel) {
          names[i].run = run_[label];
          continue;
        }
        const std::size_t s = label - kSweepLabel;
        PROVEOUT_ASSERT(s < sweeps_.size());
        names[i] = nameOf(0.5 * (points[i] + points[(i + 1) % points.size()]), static_cast<std::int32_t>(s),
                          all[s], hint);
      }
      dropShort(points, names);
      CornerLoop corners;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const EdgeName& in = names[(i + points.size() - 1) % points.size()];
        if (in != names[i]) corners.push_back({points[i], in, names[i]});
      }
      if (corners.size() > 2)
        out.loops.push_back(std::move(corners));
      else if (std::abs(signedArea2(points)) > 2.0 * kShortest * kShortest)
        out.sound = false;
    }
  }
  leaveOutThin(out);
  return out;
}

/// Ridges between passes stand alone for a moment where the face of a part cuts them.
void ThreadSlicer::leaveOutThin(Slice& slice) const {
  if (slice.loops.size() < 2) return;
  std::vector<double> area, thick;
  for (const CornerLoop& loop : slice.loops) {
    double sum = 0.0, around = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2 &a = loop[i].at, &b = loop[(i + 1) % loop.size()].at;
      sum += a.x() * b.y() - a.y() * b.x();
      around += (b - a).norm();
    }
    area.push_back(0.5 * std::abs(sum));
    thick.push_back(around > 0.0 ? std::abs(sum) / around : 0.0);
  }
  const auto largest = std::max_element(area.begin(), area.end()) - area.begin();
  for (std::size_t l = slice.loops.size(); l-- > 0;) {
    if (static_cast<std::ptrdiff_t>(l) == largest || thick[l] > thinnest_) continue;
    slice.left_out_mm = std::max(slice.left_out_mm, thick[l]);
    slice.loops.erase(slice.loops.begin() + static_cast<std::ptrdiff_t>(l));
  }
}

MotionId ThreadSlicer::motionOf(const EdgeName& name) const {
  if (name.sweep == EdgeName::kSection) return of_run_[static_cast<std::size_t>(name.run)];
  const Sweep& sweep = sweeps_[static_cast<std::size_t>(name.sweep)];
  if (name.run < 0) return sweep.thread.motion;
  PROVEOUT_ASSERT(static_cast<std::size_t>(name.run) < sweep.made_by.size());
  return sweep.made_by[static_cast<std::size_t>(name.run)];
}

}  // namespace proveout::thread_detail
