#include "core/nc/services/contour/contour_parallel.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/geometry/box_tree.h"
#include "core/geometry/plane.h"
#include "core/nc/services/contour/contour_shift.h"

namespace proveout {

namespace {

constexpr double kNoLength = 1e-7;      ///< mm; shorter pieces are none
constexpr double kNoPiece = 1e-5;       ///< mm; shorter parts between crossings are none
constexpr double kTooNear = 1e-6;       ///< mm; nearer to a curve is on it
constexpr double kKept = 1e-9;          ///< mm; what rounding takes from the distance
constexpr double kMostGap = 1e-3;       ///< mm; farther apart pieces do not belong together
constexpr double kSmallGap = 0.01;      ///< mm; across less no arc goes
constexpr double kStraightOn = 1e-9;    ///< rad; a corner that turns less is none
constexpr double kStraightBack = 1e-7;  ///< rad; a corner that lacks less of half a turn goes straight back

double lengthOf(const ContourElement& e) {
  return e.arc ? std::abs(e.sweep) * (e.from - e.center).norm() : (e.to - e.from).norm();
}

Box3 boxAround(const ContourElement& e) {
  Box3 box;
  const auto add = [&](const Vec2& p) { box.extend(Vec3(p.x(), p.y(), 0.0)); };
  add(e.from);
  add(e.to);
  if (!e.arc) return box;
  const Vec2 radius = Vec2::Constant((e.from - e.center).norm());
  add(e.center - radius);
  add(e.center + radius);
  return box;
}

PlaneCurve curveOf(const ContourElement& e) {
  if (e.arc) return {true, e.center, Vec2::UnitX(), (e.from - e.center).norm()};
  return {false, e.from, (e.to - e.from).normalized(), 0.0};
}

/// The element at the distance on its left. Nothing: the distance uses it up.
std::optional<ContourElement> shiftedBy(const ContourElement& e, double distance) {
  ContourElement out = e;
  if (!e.arc) {
    const Vec2 by = distance * leftOf(directionOn(e, false));
    out.from += by;
    out.to += by;
    return out;
  }
  const double radius = (e.from - e.center).norm(), now = radius - std::copysign(distance, e.sweep);
  if (now <= kNoLength) return std::nullopt;
  out.from = e.center + (now / radius) * (e.from - e.center);
  out.to = e.center + (now / radius) * (e.to - e.center);
  return out;
}

/// The arc about the corner between two elements, if it is an outside one.
std::optional<ContourElement> aboutCorner(const ContourElement& a, const ContourElement& b, double distance) {
  const Vec2 t1 = directionOn(a, true), t2 = directionOn(b, false);
  double turn = turnOf(t1, t2);
  if (std::abs(turn) > kPi - kStraightBack) turn = t1.y() > 0.0 ? -kPi : kPi;
  if (turn > -kStraightOn) return std::nullopt;
  ContourElement arc = arcElement(a.to, a.to + distance * leftOf(t1), a.to + distance * leftOf(t2), turn);
  arc.source = a.source;
  return arc;
}

/// Elements that stand a little apart at an outside corner go on to where they meet. False: they stay.
bool meetAtCorner(ContourElement& a, ContourElement& b) {
  const double gap = (b.from - a.to).norm();
  if (gap >= kSmallGap) return false;
  const auto at = nearestMeeting(curveOf(a), curveOf(b), 0.5 * (a.to + b.from));
  // Elements that are tangent but for the rounding of the program stay as they are, next to each other.
  if (!at || (*at - a.to).norm() > gap || (*at - b.from).norm() > gap) return gap < kMostGap;
  a = cutTo(a, a.from, *at);
  b = cutTo(b, *at, b.to);
  return true;
}

/// The part of the way of `e` at which its curve passes p; nothing: p is not on it.
std::optional<double> partAtPoint(const ContourElement& e, const Vec2& p) {
  if (!e.arc) {
    const Vec2 way = e.to - e.from;
    const double t = (p - e.from).dot(way) / way.squaredNorm();
    if (t <= 0.0 || t >= 1.0) return std::nullopt;
    return t;
  }
  const double t = sweepUntil(e, p) / std::abs(e.sweep);
  if (t <= 0.0 || t >= 1.0) return std::nullopt;
  return t;
}

/// What may become a part of the parallel.
class ParallelPieces {
 public:
  ParallelPieces(const PlaneContour& contour, double distance) : contour_(contour), distance_(distance) {
    std::optional<ContourElement> e = shiftedBy(contour.front(), distance);
    for (std::size_t k = 0; k < contour.size(); ++k) {
      const bool last = k + 1 == contour.size();
      std::optional<ContourElement> next = last ? std::nullopt : shiftedBy(contour[k + 1], distance);
      auto arc = last ? std::nullopt : aboutCorner(contour[k], contour[k + 1], distance);
      if (arc && e && next && meetAtCorner(*e, *next)) arc.reset();
      if (e) add(*e);
      if (arc) add(*arc);
      e = next;
    }
    std::vector<Box3> boxes;
    boxes.reserve(contour.size());
    for (const ContourElement& element : contour) boxes.push_back(boxAround(element));
    near_ = BoxTree(boxes);
    cut();
    cutAbout(contour.front().from);
    cutAbout(contour.back().to);
    for (std::vector<double>& cuts : cuts_) {
      cuts.push_back(1.0);
      std::sort(cuts.begin(), cuts.end());
    }
  }

  /// The pieces between their crossings that keep the distance, in order.
  PlaneContour kept() const {
    PlaneContour out;
    for (std::size_t k = 0; k < raw_.size(); ++k) {
      double last = 0.0, begin = -1.0;  // of the parts in hand that keep it
      for (const double t : cuts_[k]) {
        const ContourElement part = partOf(raw_[k], last, t);
        if (lengthOf(part) < kNoPiece) continue;  // touching curves meet at no sure point
        if (!keeps(pointOn(part, 0.5))) {
          if (begin >= 0.0) out.push_back(partOf(raw_[k], begin, last));
          begin = -1.0;
        } else if (begin < 0.0) {
          begin = last;
        }
        last = t;
      }
      if (begin >= 0.0) out.push_back(partOf(raw_[k], begin, last));
    }
    return out;
  }

 private:
  void add(const ContourElement& e) {
    if (lengthOf(e) >= kNoLength) raw_.push_back(e);
  }

  void cut() {
    std::vector<Box3> boxes;
    boxes.reserve(raw_.size());
    for (const ContourElement& e : raw_) boxes.push_back(boxAround(e));
    cuts_.resize(raw_.size());
    if (raw_.empty()) return;
    const BoxTree tree(boxes);
    for (std::size_t k = 0; k < raw_.size(); ++k) {
      const PlaneCurve own = curveOf(raw_[k]);
      tree.forEachPlace(boxes[k].inflated(kNoLength), [&](std::uint32_t place) {
        const std::size_t other = tree.order()[place];
        if (other != k) cutBy(k, own, raw_[other]);
      });
    }
  }

  /// Where pieces come to the distance from an end of the contour.
  void cutAbout(const Vec2& end) {
    const PlaneCurve circle{true, end, Vec2::UnitX(), distance_};
    for (std::size_t k = 0; k < raw_.size(); ++k) {
      if (distanceFrom(raw_[k], end) > distance_ - kTooNear)
        continue;  // one that only touches the circle too
      const Meeting common = meet(curveOf(raw_[k]), circle);
      for (std::size_t i = 0; i < common.count; ++i)
        if (const auto t = partAtPoint(raw_[k], common.points[i])) cuts_[k].push_back(*t);
    }
  }

  void cutBy(std::size_t k, const PlaneCurve& own, const ContourElement& other) {
    const Meeting common = meet(own, curveOf(other));
    for (std::size_t i = 0; i < common.count; ++i) {
      const Vec2& p = common.points[i];
      if (distanceFrom(other, p) > kTooNear) continue;
      if (const auto t = partAtPoint(raw_[k], p)) cuts_[k].push_back(*t);
    }
    // Where the other one ends on this one, whatever their curves do.
    for (const Vec2& p : {other.from, other.to}) {
      if (distanceFrom(raw_[k], p) > kTooNear) continue;
      if (const auto t = partAtPoint(raw_[k], p)) cuts_[k].push_back(*t);
    }
  }

  bool keeps(const Vec2& p) const {
    const Vec3 at(p.x(), p.y(), 0.0);
    bool far = true;
    near_.forEachPlace(Box3{at, at}.inflated(distance_), [&](std::uint32_t place) {
      if (far) far = distanceFrom(contour_[near_.order()[place]], p) >= distance_ - kKept;
    });
    return far;
  }

  const PlaneContour& contour_;
  const double distance_;
  PlaneContour raw_;
  std::vector<std::vector<double>> cuts_;  ///< parts of the way of each raw piece, the last one 1
  BoxTree near_;
};

}  // namespace

PlaneContour parallelContour(const PlaneContour& contour, double distance) {
  if (contour.empty()) return {};
  PlaneContour out = ParallelPieces(contour, distance).kept();
  for (std::size_t k = 1; k < out.size(); ++k) {
    if ((out[k].from - out[k - 1].to).norm() > kMostGap) return {};
    out[k].from = out[k - 1].to;
  }
  return out;
}

}  // namespace proveout
