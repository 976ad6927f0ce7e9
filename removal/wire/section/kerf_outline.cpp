#include "removal/wire/section/kerf_outline.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/geometry/plane.h"
#include "removal/wire/section/plane_region.h"

namespace proveout::wire_detail {
namespace {

/// Ends nearer to each other than this count as the same point, mm.
constexpr double kJoined = 1e-7;
/// Smaller turns count as straight on, radians.
constexpr double kStraight = 1e-12;
/// Inner corners that turn by more go by way of the corner itself.
constexpr double kSharpTurn = 0.5;
/// Kerfs that reach beyond the center of an arc by no more do not reach it, mm: the corner of the contour
/// that the control rounds with just the kerf. Ended at the center, strips would leave a slit of rounding
/// there that opens to the outside.
constexpr double kBeyondCenter = 2e-5;
/// By how much strips lap over each other at the center of an arc, and how far it is moved for that at most,
/// mm.
constexpr double kLap = 3e-6, kMostLap = 2e-4;

/// The outline is that of a sum of pieces, each wound counter-clockwise: the strip beside each stretch on
/// both sides, the pie at the outer side of each joint, half a disc at both ends. Where two pieces share an
/// edge it is left out. A point of the kerf is in the strip of the stretch, or in the pie of the joint, that
/// is nearest to it, so that their union is all of the kerf.
class OutlineMaker {
 public:
  explicit OutlineMaker(std::span<const WireStretch> run) : run_(run), kerf_(run.front().kerf_mm) {}

  ClipperLib::Path make() {
    const std::size_t n = run_.size();
    for (std::size_t k = 0; k < n; ++k) {
      if (k > 0) joint(k, true);
      side(k, true);
    }
    const Vec2 last = run_.back().directionAtEnd();
    pie(run_.back().to, -leftOf(last), kPi);
    for (std::size_t k = n; k-- > 0;) {
      side(k, false);
      if (k > 0) joint(k, false);
    }
    pie(run_.front().from, leftOf(run_.front().directionAtStart()), kPi);
    return path_.take();
  }

 private:
  void add(const Vec2& p) { path_.add(p); }

  /// An arc about `center` from center + from * radius.
  void arc(const Vec2& center, const Vec2& from, double radius, double sweep) {
    const int count = chordCount(radius, sweep, kKerfChordMm);
    for (int k = 0; k <= count; ++k) {
      add(center + radius * turnedBy(from, sweep * k / count));
    }
  }
  void pie(const Vec2& center, const Vec2& from, double sweep) { arc(center, from, kerf_, sweep); }

  /// Where the kerf reaches beyond the center of an arc, the strip on that side ends there.
  bool reachesCenter(const WireStretch& s, bool right) const {
    return s.isArc() && (s.sweep_rad < 0.0) == right && s.radius() <= kerf_ - kBeyondCenter;
  }

  /// The center of an arc, moved away from it so far that what ends there laps over the strips beside in
  /// spite of rounding; else slits would be left between them, which may open to the outside.
  static Vec2 behindCenter(const WireStretch& s) {
    const double half = 0.5 * std::abs(s.sweep_rad);
    const double shift = std::min(kMostLap, kLap / std::max(std::sin(half), 1e-9));
    const Vec2 to_middle = turnedBy(s.from - s.center, 0.5 * s.sweep_rad) / s.radius();
    return s.center - shift * to_middle;
  }

  /// The side of a stretch: right ones in the direction of travel, left ones against it.
  void side(std::size_t k, bool right) {
    const WireStretch& s = run_[k];
    const Vec2 &from = right ? s.from : s.to, &to = right ? s.to : s.from;
    if (reachesCenter(s, right)) {
      add(from);
      add(behindCenter(s));
      add(to);
      return;
    }
    if (!s.isArc()) {
      const Vec2 off = kerf_ * (right ? Vec2(-leftOf(s.directionAtStart())) : leftOf(s.directionAtStart()));
      if (!isTrimmed(right ? k : k + 1, right)) add(from + off);
      if (!isTrimmed(right ? k + 1 : k, right)) add(to + off);
      return;
    }
    const bool outer = (s.sweep_rad > 0.0) == right;
    const Vec2 spoke = (from - s.center) / (from - s.center).norm();
    arc(s.center, spoke, s.radius() + (outer ? kerf_ : -kerf_), right ? s.sweep_rad : -s.sweep_rad);
  }

  /// How the way turns from run_[k - 1] to run_[k], above 0 to the left.
  double turnAt(std::size_t k) const {
    const Vec2 in = run_[k - 1].directionAtEnd(), out = run_[k].directionAtStart();
    return std::atan2(cross2(in, out), in.dot(out));
  }

  /// Between run_[k - 1] and run_[k].
  void joint(std::size_t k, bool right) {
    const WireStretch &before = run_[k - 1], &next = run_[k];
    const Vec2 in = before.directionAtEnd(), out = next.directionAtStart();
    const double turn = turnAt(k);
    if (isTrimmed(k, right)) {
      const Vec2 sum = leftOf(in) + leftOf(out);
      add(next.from + sum * ((right ? -2.0 : 2.0) * kerf_ / sum.squaredNorm()));
    } else if (std::abs(turn) > kStraight) {
      if ((turn > 0.0) == right)
        pie(next.from, right ? Vec2(-leftOf(in)) : leftOf(out), std::abs(turn));
      else if (!mayBeCut(before, turn, right) || !mayBeCut(next, turn, right))
        add(next.from);
    }
  }

  /// Whether two lines with an inner corner between them end where their sides meet: the kite behind that is
  /// covered by both strips, where they are long enough, and may be counted off once.
  bool isTrimmed(std::size_t k, bool right) const {
    if (k == 0 || k == run_.size() || run_[k - 1].isArc() || run_[k].isArc()) return false;
    const double turn = turnAt(k);
    if (std::abs(turn) > kSharpTurn || ((turn > 0.0) == right && std::abs(turn) > kStraight)) return false;
    const double trim = kerf_ * std::tan(0.5 * std::abs(turn));
    return 2.0 * trim <= std::min(run_[k - 1].length(), run_[k].length());
  }

  /// Whether the needle between the ends of two strips at an inner corner lies in the strip: it is covered
  /// twice then, and may be counted off once, which saves crossings.
  bool mayBeCut(const WireStretch& s, double turn, bool right) const {
    if (std::abs(turn) > kSharpTurn || reachesCenter(s, right)) return false;
    const double needle = kerf_ * std::sin(std::abs(turn));
    if (!s.isArc()) return (s.to - s.from).norm() >= needle;
    return s.radius() > 2.0 * kerf_ && s.length() >= 2.0 * needle;
  }

  std::span<const WireStretch> run_;
  double kerf_;
  OutlinePath path_;
};

}  // namespace

ClipperLib::IntPoint toUnits(const Vec2& p) {
  return {static_cast<ClipperLib::cInt>(std::llround(p.x() / kUnit)),
          static_cast<ClipperLib::cInt>(std::llround(p.y() / kUnit))};
}

Vec2 toMm(const ClipperLib::IntPoint& p) {
  return {kUnit * static_cast<double>(p.X), kUnit * static_cast<double>(p.Y)};
}

bool follows(const WireStretch& before, const WireStretch& next) {
  return before.kerf_mm == next.kerf_mm && (before.to - next.from).norm() <= kJoined;
}

ClipperLib::Path kerfOutline(std::span<const WireStretch> run) {
  PROVEOUT_ASSERT(!run.empty() && run.front().kerf_mm == run.back().kerf_mm);
  return OutlineMaker(run).make();
}

}  // namespace proveout::wire_detail
