#include "core/nc/services/wire_taper.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/geometry/plane.h"
#include "core/nc/services/contour/contour_elements.h"
#include "core/nc/services/contour/contour_shift.h"

namespace proveout {

namespace {

constexpr double kUpright = 1e-9;         ///< mm; smaller leans are none
constexpr double kParallel = 1e-9;        ///< sine of the turn
constexpr double kNearlyParallel = 1e-3;  ///< the same, of directions that come from rounded coordinates
constexpr double kFarthestMiter = 10.0;   ///< leans

using TaperKind = TaperFailure::Kind;

bool beginsTaper(const std::vector<TaperPiece>& pieces, std::size_t k) {
  return pieces[k].on && (k == 0 || !pieces[k - 1].on);
}

/// The corner behind a piece in the secondary plane.
class TaperCorner {
 public:
  /// `starts`: the wire begins to lean on `a`.
  TaperCorner(const TaperPiece& a, const TaperPiece& b, bool starts, const TaperRules& rules)
      : a_(a), b_(b), rules_(rules), starts_(starts) {
    before_ = starts || !a.on ? 0.0 : a.lean;
    after_ = b.on ? b.lean : 0.0;
    t1_ = directionOn(a.element, true);
    t2_ = directionOn(b.element, false);
    end = a.element.to + before_ * leftOf(t1_);
    start = b.element.from + after_ * leftOf(t2_);
  }

  std::optional<TaperKind> solve() {
    if (starts_) {
      end = start = b_.element.from + (after_ != 0.0 ? after_ : a_.lean) * leftOf(t2_);
      return std::nullopt;
    }
    if (a_.on && !b_.on) {
      start = end;
      return std::nullopt;
    }
    if (std::abs(before_) < kUpright && std::abs(after_) < kUpright) return rounded();
    if (std::abs(before_ - after_) > kUpright) return changeOfLean();
    if ((end - start).norm() < rules_.tangent_mm) {
      start = end;
      return std::nullopt;
    }
    const bool inner = before_ * turnOf(t1_, t2_) > 0.0;
    return inner ? intersection(TaperKind::kNoIntersection) : outer();
  }

  Vec2 end, start;
  bool sharp = false;  ///< both elements end at their intersection
  bool tilts_in_place = false;
  std::optional<ContourElement> transition;

 private:
  std::optional<TaperKind> rounded() {
    start = end;
    sharp = true;
    return std::nullopt;
  }

  std::optional<TaperKind> changeOfLean() {
    if (std::abs(cross2(t1_, t2_)) < parallel()) {
      if (a_.element.arc || b_.element.arc || t1_.dot(t2_) < 0.0) return TaperKind::kProcessing;
      tilts_in_place = true;
      return std::nullopt;
    }
    return intersection(TaperKind::kProcessing);
  }

  /// Sine of the turn below which the corner is none: a contour is tangent there to within the tolerance.
  double parallel() const {
    const double lean = std::max(std::abs(before_), std::abs(after_));
    return std::clamp(rules_.tangent_mm / lean, kParallel, kNearlyParallel);
  }

  std::optional<TaperKind> outer() {
    const bool arc = a_.element.arc || b_.element.arc || rules_.arc_corners;
    if (!arc || a_.rounded) return intersection(TaperKind::kMiter);
    transition = arcElement(a_.element.to, end, start, turnOf(t1_, t2_));
    return std::nullopt;
  }

  std::optional<TaperKind> intersection(TaperKind none) {
    const auto first = shiftedCurve(a_.element, before_), second = shiftedCurve(b_.element, after_);
    if (!first || !second) return TaperKind::kRadius;
    const auto common = nearestMeeting(*first, *second, a_.element.to);
    if (!common) return none;
    const double farthest = kFarthestMiter * std::max(std::abs(before_), std::abs(after_));
    if (none != TaperKind::kNoIntersection && (*common - a_.element.to).norm() > farthest) return none;
    end = start = *common;
    sharp = true;
    return std::nullopt;
  }

  const TaperPiece &a_, &b_;
  const TaperRules& rules_;
  bool starts_;
  double before_ = 0.0, after_ = 0.0;
  Vec2 t1_, t2_;
};

class Tapering {
 public:
  Tapering(const std::vector<TaperPiece>& pieces, const TaperRules& rules) : pieces_(pieces), rules_(rules) {}

  TaperedContour run() {
    Vec2 start = pieces_.empty() ? Vec2::Zero() : startOf();
    for (std::size_t k = 0; k < pieces_.size() && !out_.failure; ++k) addPiece(k, start);
    if (!out_.failure) roundCorners();
    return std::move(out_);
  }

 private:
  struct Rounding {
    std::size_t element;  ///< in front of the corner
    double radius;
  };

  /// A contour that leans from its first element on.
  Vec2 startOf() const {
    const TaperPiece& first = pieces_.front();
    const double lean = first.on && !beginsTaper(pieces_, 0) ? first.lean : 0.0;
    return first.element.from + lean * leftOf(directionOn(first.element, false));
  }

  void fail(TaperKind kind, std::size_t piece) { out_.failure = TaperFailure{kind, piece}; }

  void addPiece(std::size_t k, Vec2& start) {
    const TaperPiece& piece = pieces_[k];
    const bool begins = beginsTaper(pieces_, k), ends = k > 0 && pieces_[k - 1].on && !piece.on;
    const bool starts = begins && std::abs(piece.lean) > kUpright;
    if (begins && piece.element.arc) return fail(TaperKind::kArcStart, k);
    if (ends && piece.element.arc) return fail(TaperKind::kArcCancel, k);
    Vec2 end = piece.element.to + (piece.on ? piece.lean : 0.0) * leftOf(directionOn(piece.element, true));
    Vec2 next = end;
    std::optional<ContourElement> transition;
    bool sharp = false;
    if (k + 1 < pieces_.size()) {
      TaperCorner corner(piece, pieces_[k + 1], starts, rules_);
      if (const auto kind = corner.solve()) return fail(*kind, *kind == TaperKind::kProcessing ? k + 1 : k);
      end = corner.end;
      next = corner.start;
      transition = corner.transition;
      sharp = corner.sharp;
      if (corner.tilts_in_place) out_.tilts_in_place.push_back(k);
    }
    put(k, starts || ends ? lineElement(start, end) : cutTo(piece.element, start, end), starts || ends);
    if (sharp && piece.rounded) rounding(k);
    if (transition) out_.elements.push_back({*transition, k, true, true});
    start = next;
  }

  void put(std::size_t k, const ContourElement& element, bool slanted) {
    const TaperPiece& piece = pieces_[k];
    const double lean = piece.on ? piece.lean : 0.0;
    if (!slanted && lean != 0.0) {
      if (!shiftedCurve(piece.element, lean)) return fail(TaperKind::kRadius, k);
      if (runsBack(piece.element, element)) return fail(TaperKind::kReversed, k);
    }
    out_.elements.push_back({element, k, false, false});
  }

  /// The arc about the centre of the main one, or the radius that the program says.
  void rounding(std::size_t k) {
    const TaperPiece& piece = pieces_[k];
    const double turn = turnOf(directionOn(piece.element, true), directionOn(pieces_[k + 1].element, false));
    const double lean = piece.on ? piece.lean : 0.0;
    const double radius = piece.round_2.value_or(piece.round - (turn > 0.0 ? lean : -lean));
    if (radius > kUpright) roundings_.push_back({out_.elements.size() - 1, radius});
  }

  void roundCorners() {
    if (roundings_.empty()) return;
    std::vector<TaperedElement> elements = std::move(out_.elements);
    out_.elements.clear();
    auto next = roundings_.begin();
    for (std::size_t k = 0; k < elements.size() && !out_.failure; ++k) {
      out_.elements.push_back(elements[k]);
      if (next == roundings_.end() || next->element != k) continue;
      roundCornerBehind(next->radius, elements[k + 1]);
      ++next;
    }
  }

  /// The corner between the last element and the next one.
  void roundCornerBehind(double radius, TaperedElement& b) {
    TaperedElement& a = out_.elements.back();
    std::optional<ContourElement> arc;
    if (roundBetween(a.element, b.element, radius, arc) != CornerError::kNone)
      return fail(TaperKind::kRound, a.piece);
    if (arc) out_.elements.push_back({*arc, a.piece, true, false});
  }

  const std::vector<TaperPiece>& pieces_;
  const TaperRules& rules_;
  TaperedContour out_;
  std::vector<Rounding> roundings_;
};

}  // namespace

TaperedContour taperContour(const std::vector<TaperPiece>& pieces, const TaperRules& rules) {
  return Tapering(pieces, rules).run();
}

}  // namespace proveout
