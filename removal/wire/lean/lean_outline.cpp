#include "removal/wire/lean/lean_outline.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "core/base/parallel_for.h"
#include "core/geometry/plane.h"
#include "removal/wire/section/kerf_outline.h"
#include "removal/wire/section/kerf_union.h"
#include "removal/wire/section/plane_region.h"

namespace proveout::wire_detail {
namespace {

using ClipperLib::Path;
using ClipperLib::Paths;

/// Stretches that have one outline: at its ends it is round, and between heights walls there have to be
/// halved.
constexpr std::size_t kRunStretches = 192;
/// Ends nearer to each other than this count as the same point, mm; on shorter stretches the wire stands
/// still.
constexpr double kLeanJoined = 1e-7;
/// Inner corners that turn by more go by way of the corner itself.
constexpr double kLeanSharpTurn = 0.5;
/// From the ellipse at a corner to where its sides meet: no more, and they are one line with a point on it,
/// mm.
constexpr double kHardlyTurned = 5e-6;
/// Ellipses that differ by less than this count as equal, mm.
constexpr double kSameEllipse = 1e-6;

bool stands(const LevelStretch& s) { return s.length() <= kLeanJoined; }

/// By how much the ellipses at both ends of a stretch differ, at most, about.
double ellipseChange(const LevelStretch& s) {
  return s.radius_mm * (s.lean_to - s.lean_from).norm() * std::max(s.lean_to.norm(), s.lean_from.norm());
}

/// Where the sides p + t * d and q + u * e meet.
std::optional<Vec2> meeting(const Vec2& p, const Vec2& d, const Vec2& q, const Vec2& e) {
  const double cross = cross2(d, e);
  if (std::abs(cross) < 1e-12 * d.norm() * e.norm()) return std::nullopt;
  return p + d * (cross2(q - p, e) / cross);
}

/// The outline of stretches that follow each other and do not stand: their strips, a piece of the ellipse at
/// the outer side of each joint and half of it at both ends (see kerf_outline.cpp, where it is a circle).
class LeanOutline {
 public:
  explicit LeanOutline(std::span<const LevelStretch> run) : run_(run) {}

  Path make() {
    const std::size_t n = run_.size();
    for (std::size_t k = 0; k < n; ++k) {
      if (k > 0) joint(k, true);
      side(k, true);
    }
    const LevelStretch &last = run_.back(), &first = run_.front();
    pie(last.to, last.lean_to, -leftOf(last.direction()), kPi);
    for (std::size_t k = n; k-- > 0;) {
      side(k, false);
      if (k > 0) joint(k, false);
    }
    pie(first.from, first.lean_from, leftOf(first.direction()), kPi);
    return path_.take();
  }

 private:
  void add(const Vec2& p) { path_.add(p); }

  void pie(const Vec2& center, const Vec2& lean, const Vec2& from, double sweep) {
    const double radius = run_.front().radius_mm;
    const int count = chordCount(radius * std::sqrt(1.0 + lean.squaredNorm()), sweep, kKerfChordMm);
    for (int k = 0; k <= count; ++k)
      add(center + kerfSupport(turnedBy(from, sweep * k / count), lean, radius));
  }

  struct Side {
    Vec2 from, to;  ///< in the direction of travel
  };
  Side sideOf(const LevelStretch& s, bool right) const {
    const Vec2 normal = right ? Vec2(-leftOf(s.direction())) : leftOf(s.direction());
    return {s.from + kerfSupport(normal, s.lean_from, s.radius_mm),
            s.to + kerfSupport(normal, s.lean_to, s.radius_mm)};
  }

  /// Right sides in the direction of travel, left ones against it.
  void side(std::size_t k, bool right) {
    const Side side = sideOf(run_[k], right);
    const bool from_cut = trimmed(k, right).has_value(), to_cut = trimmed(k + 1, right).has_value();
    if (right ? !from_cut : !to_cut) add(right ? side.from : side.to);
    if (right ? !to_cut : !from_cut) add(right ? side.to : side.from);
  }

  /// Between run_[k - 1] and run_[k], above 0 to the left.
  double turnAt(std::size_t k) const {
    const Vec2 in = run_[k - 1].direction(), out = run_[k].direction();
    return std::atan2(cross2(in, out), in.dot(out));
  }

  void joint(std::size_t k, bool right) {
    const double turn = turnAt(k);
    if (const std::optional<Vec2> corner = trimmed(k, right))
      add(*corner);
    else if ((turn > 0.0) == right)
      pie(run_[k].from, run_[k].lean_from,
          right ? Vec2(-leftOf(run_[k - 1].direction())) : leftOf(run_[k].direction()), std::abs(turn));
    else
      add(run_[k].from);
  }

  /// The corner of two sides. Where they hardly turn it is half way between their ends: their meeting would
  /// jump along the wall from height to height. At other inner corners, if both are long enough, where they
  /// meet: what lies behind is covered twice and may be counted off once.
  std::optional<Vec2> trimmed(std::size_t k, bool right) const {
    if (k == 0 || k == run_.size()) return std::nullopt;
    const double turn = turnAt(k);
    const LevelStretch &before = run_[k - 1], &next = run_[k];
    if (0.125 * next.reach() * turn * turn <= kHardlyTurned)
      return 0.5 * (sideOf(before, right).to + sideOf(next, right).from);
    if (std::abs(turn) > kLeanSharpTurn || (turn > 0.0) == right) return std::nullopt;
    const double trim = next.reach() * std::tan(0.5 * std::abs(turn));
    if (2.5 * trim > std::min(before.length(), next.length())) return std::nullopt;
    const Side a = sideOf(before, right), b = sideOf(next, right);
    const std::optional<Vec2> corner = meeting(a.from, a.to - a.from, b.from, b.to - b.from);
    const bool near = corner && (*corner - a.to).norm() <= 1.25 * trim + kSameEllipse;
    return near ? corner : std::nullopt;
  }

  std::span<const LevelStretch> run_;
  OutlinePath path_;
};

/// All round the wire where it stands.
Path ellipseOf(const Vec2& at, const Vec2& lean, double radius) {
  const int count =
      std::max(8, chordCount(radius * std::sqrt(1.0 + lean.squaredNorm()), 2.0 * kPi, kKerfChordMm));
  Path path;
  for (int k = 0; k < count; ++k)
    path.push_back(toUnits(at + kerfSupport(turnedBy(Vec2::UnitX(), 2.0 * kPi * k / count), lean, radius)));
  return path;
}

/// Where a stretch is short for the change of its ellipse its strip may not hold both.
bool needsEllipses(const LevelStretch& s) {
  const double change = ellipseChange(s);
  return change > kSameEllipse && 0.1 * s.length() < change;
}

struct Batch {
  std::vector<LevelStretch> run;
  Paths ellipses;
};

/// Runs of stretches that follow each other; those that stand are left out where others join them.
std::vector<Batch> batchesOf(const std::vector<LevelStretch>& stretches) {
  std::vector<Batch> batches;
  for (const LevelStretch& s : stretches) {
    const bool goes_on =
        !batches.empty() && !batches.back().run.empty() &&
        batches.back().run.size() + batches.back().ellipses.size() < kRunStretches &&
        batches.back().run.back().radius_mm == s.radius_mm &&
        (batches.back().run.back().to - s.from).norm() <= kLeanJoined &&
        (batches.back().run.back().lean_to - s.lean_from).norm() * s.radius_mm <= kSameEllipse;
    if (!goes_on) batches.emplace_back();
    Batch& batch = batches.back();
    if (needsEllipses(s) || (stands(s) && !goes_on)) {
      batch.ellipses.push_back(ellipseOf(s.from, s.lean_from, s.radius_mm));
      batch.ellipses.push_back(ellipseOf(s.to, s.lean_to, s.radius_mm));
    }
    if (!stands(s)) batch.run.push_back(s);
  }
  return batches;
}

Paths pathsOf(const Batch& batch) {
  Paths paths = batch.ellipses;
  if (!batch.run.empty()) paths.push_back(LeanOutline(batch.run).make());
  return united(paths);
}

}  // namespace

Paths leanKerf(const std::vector<LevelStretch>& stretches) {
  const std::vector<Batch> batches = batchesOf(stretches);
  std::vector<Paths> parts(batches.size());
  parallelFor(std::size_t{0}, batches.size(), [&](std::size_t i) { parts[i] = pathsOf(batches[i]); });
  return unitedInLevels(std::move(parts));
}

}  // namespace proveout::wire_detail
