#include "core/nc/services/wire_offset.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/geometry/plane.h"
#include "core/nc/services/contour/contour_clearance.h"
#include "core/nc/services/contour/contour_elements.h"
#include "core/nc/services/contour/contour_shift.h"

namespace proveout {

namespace {

constexpr double kNoOffset = 1e-9;    ///< mm; smaller offsets are none
constexpr double kNoLength = 1e-9;    ///< mm
constexpr double kHalfTurn = 1e-9;    ///< rad; a turn that is nearer to half a one goes straight back
constexpr double kStraightOn = 1e-9;  ///< rad
/// rad; the same of lines whose ends come from rounded coordinates.
constexpr double kNearlyStraightOn = 1e-3;

using OffsetKind = OffsetFailure::Kind;

double offsetOn(const OffsetPiece& piece) {
  return piece.starts || std::abs(piece.offset) < kNoOffset ? 0.0 : piece.offset;
}

/// Whether a piece goes on beside the end of the one in front: a taper changes there on the spot.
bool goesOnBeside(const OffsetPiece& a, const OffsetPiece& b, double tangent_mm) {
  return (b.element.from - a.element.to).norm() > tangent_mm &&
         std::abs(turnOf(directionOn(a.element, true), directionOn(b.element, false))) < kNearlyStraightOn;
}

/// Where two pieces meet: how the first one ends, and the second one begins.
class OffsetJoint {
 public:
  OffsetJoint(const OffsetPiece& a, const OffsetPiece& b, double tangent_mm)
      : a_(a), b_(b), tangent_(tangent_mm), before_(offsetOn(a)), after_(offsetOn(b)) {
    t1_ = directionOn(a.element, true);
    t2_ = directionOn(b.element, false);
    end = a.element.to + before_ * leftOf(t1_);
    start = b.element.from + after_ * leftOf(t2_);
    // Back on itself is always an outer corner.
    turn_ = turnOf(t1_, t2_);
    if (std::abs(turn_) > kPi - kHalfTurn) turn_ = before_ > 0.0 ? -kPi : kPi;
  }

  std::optional<OffsetKind> solve() {
    if (before_ == 0.0 || after_ == 0.0) return ramp();
    if (before_ * after_ < 0.0) return changeOfSide();
    if (before_ != after_) return changeOfOffset();
    if ((end - start).norm() < tangent_ || std::abs(turn_) < kStraightOn || goesOnBeside(a_, b_, tangent_))
      return step();
    return before_ * turn_ > 0.0 ? inner() : outer();
  }

  Vec2 end, start;
  bool next_slants = false;
  std::vector<ContourElement> spike, join;

 private:
  std::optional<OffsetKind> ramp() {
    if (before_ == 0.0 && after_ == 0.0) {
      if (!a_.starts) return step();
      start = end += a_.offset * leftOf(t2_);
      next_slants = true;
      if (b_.element.arc) return OffsetKind::kArcCancel;
    } else if (before_ == 0.0) {
      if (a_.element.arc) return OffsetKind::kArcStart;
      end = start;
    } else {
      if (b_.element.arc) return OffsetKind::kArcCancel;
      start = end;
      next_slants = true;
    }
    return std::nullopt;
  }

  /// On the contour itself; a taper that changes between collinear lines leaves a gap in the secondary plane.
  std::optional<OffsetKind> step() {
    if ((end - start).norm() > kNoLength) join.push_back(lineElement(end, start));
    return std::nullopt;
  }

  std::optional<OffsetKind> changeOfSide() {
    if (b_.element.arc) return OffsetKind::kArcChange;
    start = end;
    next_slants = true;
    return std::nullopt;
  }

  std::optional<Vec2> meeting() const {
    const auto first = shiftedCurve(a_.element, before_), second = shiftedCurve(b_.element, after_);
    if (!first || !second) return std::nullopt;
    return nearestMeeting(*first, *second, 0.5 * (a_.element.to + b_.element.from));
  }

  std::optional<OffsetKind> changeOfOffset() {
    const double straight = std::clamp(tangent_ / std::abs(before_ - after_), kStraightOn, kNearlyStraightOn);
    if (const auto common = meeting(); common && std::abs(std::sin(turn_)) > straight) {
      end = start = *common;
    } else {
      join.push_back(lineElement(end, start));
    }
    return std::nullopt;
  }

  std::optional<OffsetKind> inner() {
    const auto common = meeting();
    if (!common) return OffsetKind::kNoIntersection;
    end = start = *common;
    const Vec2 way = a_.element.to - end;
    if (a_.overcut > 0.0 && way.norm() > kNoLength) addSpike(end + a_.overcut * way.normalized());
    return std::nullopt;
  }

  std::optional<OffsetKind> outer() {
    const double turn = std::abs(turn_);
    // At acute corners of the part the overcut gives way to the straight corner.
    const bool acute = turn > kPi / 2.0 + kHalfTurn;
    if (a_.overcut > 0.0 && !acute) addSpike(end + a_.overcut * t1_);
    const bool straight = a_.outer != OuterJoin::kArc || (a_.overcut > 0.0 && acute);
    const double r = std::abs(before_);
    if (!straight) {
      join.push_back(arcElement(a_.element.to, end, start, turn_));
      return std::nullopt;
    }
    const double extension =
        a_.outer == OuterJoin::kTangent ? r * std::tan(turn / 4.0) : r * std::min(1.0, std::tan(turn / 2.0));
    const Vec2 q1 = end + extension * t1_, q2 = start - extension * t2_;
    join.push_back(lineElement(end, q1));
    if ((q2 - q1).norm() > kNoLength) join.push_back(lineElement(q1, q2));
    join.push_back(lineElement((q2 - q1).norm() > kNoLength ? q2 : q1, start));
    return std::nullopt;
  }

  void addSpike(const Vec2& tip) {
    spike.push_back(lineElement(end, tip));
    spike.push_back(lineElement(tip, end));
  }

  const OffsetPiece &a_, &b_;
  double tangent_, before_, after_, turn_ = 0.0;
  Vec2 t1_, t2_;
};

class Offsetting {
 public:
  Offsetting(const std::vector<OffsetPiece>& pieces, double tangent_mm)
      : pieces_(pieces), tangent_(tangent_mm) {}

  OffsetContour run() {
    Vec2 start = pieces_.empty() ? Vec2::Zero() : pieces_.front().element.from;
    if (!pieces_.empty() && !pieces_.front().starts)
      start += offsetOn(pieces_.front()) * leftOf(directionOn(pieces_.front().element, false));
    bool slanted = false;
    for (std::size_t k = 0; k < pieces_.size() && !out_.failure; ++k) addPiece(k, start, slanted);
    return std::move(out_);
  }

 private:
  void fail(OffsetKind kind, std::size_t piece, const Vec2& where) {
    out_.failure = OffsetFailure{kind, piece, where};
  }

  void addPiece(std::size_t k, Vec2& start, bool& slanted) {
    const OffsetPiece& piece = pieces_[k];
    const double offset = offsetOn(piece);
    if (!shiftedCurve(piece.element, offset)) return fail(OffsetKind::kRadius, k, piece.element.from);
    OffsetTrack track;
    track.slanted = slanted || piece.starts;
    Vec2 end =
        piece.element.to + (piece.starts ? piece.offset : offset) * leftOf(directionOn(piece.element, true));
    Vec2 next = end;
    slanted = false;
    if (k + 1 < pieces_.size()) {
      OffsetJoint joint(piece, pieces_[k + 1], tangent_);
      if (const auto kind = joint.solve()) return fail(*kind, failedAt(*kind, k), piece.element.to);
      track.slanted = track.slanted || (offset == 0.0 && offsetOn(pieces_[k + 1]) != 0.0);
      end = joint.end;
      next = joint.start;
      slanted = joint.next_slants;
      track.spike = std::move(joint.spike);
      track.join = std::move(joint.join);
    }
    if (piece.starts && piece.element.arc) return fail(OffsetKind::kArcStart, k, piece.element.from);
    track.track = track.slanted ? lineElement(start, end) : cutTo(piece.element, start, end);
    track.track.source = piece.element.source;
    if (!track.slanted && offset != 0.0 && runsBack(piece.element, track.track))
      return fail(OffsetKind::kReversed, k, end);
    if (piece.extension > 0.0 && !piece.element.arc) extend(piece, track);
    out_.tracks.push_back(std::move(track));
    start = next;
  }

  /// Cancel and change of side fail at the piece behind the joint.
  static std::size_t failedAt(OffsetKind kind, std::size_t k) {
    return kind == OffsetKind::kArcCancel || kind == OffsetKind::kArcChange ? k + 1 : k;
  }

  static void extend(const OffsetPiece& piece, OffsetTrack& track) {
    const Vec2 way =
        track.slanted ? Vec2(track.track.to - track.track.from) : directionOn(piece.element, true);
    if (way.norm() < kNoLength) return;
    const Vec2 tip = track.track.to + piece.extension * way.normalized();
    track.spike.insert(track.spike.begin(),
                       {lineElement(track.track.to, tip), lineElement(tip, track.track.to)});
  }

  const std::vector<OffsetPiece>& pieces_;
  double tangent_;
  OffsetContour out_;
};

/// A stretch of pieces with one offset. It ends where a taper changes on the spot: there the wire goes over
/// the end of the piece in front.
struct OffsetLoop {
  std::size_t first = 0, last = 0;  ///< from and behind
  double offset = 0.0;
};

OffsetLoop loopFrom(const std::vector<OffsetPiece>& pieces, std::size_t first, double tangent_mm) {
  OffsetLoop loop{first, first + 1, offsetOn(pieces[first])};
  const auto goesOn = [&](const OffsetPiece& a, const OffsetPiece& b) {
    return offsetOn(b) == loop.offset && !goesOnBeside(a, b, tangent_mm);
  };
  while (loop.last < pieces.size() && goesOn(pieces[loop.last - 1], pieces[loop.last])) ++loop.last;
  return loop;
}

/// What comes nearer to an element of its own loop than the offset.
void checkLoop(const std::vector<OffsetPiece>& pieces, const OffsetLoop& loop, double tangent_mm,
               OffsetContour& out) {
  std::vector<ContourElement> contour, path;
  for (std::size_t k = loop.first; k < loop.last; ++k) {
    if (k < out.tracks.size() && out.tracks[k].slanted) continue;
    contour.push_back(pieces[k].element);
    if (k >= out.tracks.size()) continue;
    const auto add = [&](ContourElement e) {
      e.source = static_cast<int>(k);
      path.push_back(e);
    };
    add(out.tracks[k].track);
    if (k + 1 < loop.last) std::for_each(out.tracks[k].join.begin(), out.tracks[k].join.end(), add);
  }
  const auto pass = firstNearPass(path, contour, std::abs(loop.offset) - tangent_mm);
  if (!pass) return;
  const auto piece = static_cast<std::size_t>(path[pass->path].source);
  out.failure = OffsetFailure{OffsetKind::kTooNear, piece, path[pass->path].from};
  out.tracks.resize(piece);
}

}  // namespace

OffsetContour offsetContour(const std::vector<OffsetPiece>& pieces, double tangent_mm) {
  OffsetContour out = Offsetting(pieces, tangent_mm).run();
  for (std::size_t k = 0; k < pieces.size();) {
    const OffsetLoop loop = loopFrom(pieces, k, tangent_mm);
    if (loop.offset != 0.0) checkLoop(pieces, loop, tangent_mm, out);
    k = loop.last;
    if (k > out.tracks.size()) break;
  }
  return out;
}

}  // namespace proveout
