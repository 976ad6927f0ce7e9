// Interference check of cutter compensation and its repair by leaving out blocks (digest nct-3, 3.11).
#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/nc/services/cutter_comp.h"
#include "core/nc/services/cutter_comp_corner.h"
#include "core/nc/services/cutter_comp_roll.h"

namespace proveout {

using namespace comp_detail;

namespace comp_detail {

/// New corner between N1 and N3 from the corners around N2: the point pairs next to N2 are peeled off until
/// the way between them no longer runs against N2; the lines behind them meet in the new point.
std::optional<Corner> peelCorners(const Corner& first, const Corner& second, const Element& left_out) {
  if (first.arc_join || second.arc_join) return std::nullopt;
  const std::vector<Vec2>&a = first.points, &b = second.points;
  const Vec2 programmed = planar(left_out.p1) - planar(left_out.p0);
  for (std::size_t j = 1; j <= 3 && j < a.size() && j < b.size(); ++j) {
    const std::size_t last = a.size() - 1 - j;
    if (programmed.dot(b[j] - a[last]) < 0.0) continue;
    const auto x = meetLines(a[last], a[last + 1], b[j - 1], b[j]);
    if (!x) return std::nullopt;
    Corner corner;
    corner.points.assign(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(last + 1));
    corner.points.push_back(*x);
    corner.points.insert(corner.points.end(), b.begin() + static_cast<std::ptrdiff_t>(j), b.end());
    return corner;
  }
  return std::nullopt;
}

/// Meeting point of the offset curves of two elements of the same side.
std::optional<Vec2> mends(const Element& a, const Element& b) {
  if (!a.plain() || !b.plain() || a.rho_end * b.rho_start <= 0.0) return std::nullopt;
  return meetOffsets(a, b);
}

/// Elements that the disk looks over at most.
constexpr std::size_t kMostAhead = 500;
/// mm; a disk that overlaps the contour by less keeps off it.
constexpr double kKeepsOff = 1e-6;

/// Length of contour ahead that can stop the disk before what it passes over counts. Between two points `s`
/// apart it leaves s^2 (1/r - 1/R) / 8 of a contour of radius R. For R >= 1.05 r.
double reachAhead(double r, double tolerance) { return std::sqrt(160.0 * tolerance * r); }

double lengthOf(const Element& e) {
  if (e.kind == ElementKind::kLine) return (planar(e.p1) - planar(e.p0)).norm();
  return std::abs(e.sweep) * (planar(e.p0) - e.center).norm();
}

/// True if the disk can come from `e` to the elements behind it.
bool leadsOn(const Element& e) {
  if (e.plain()) return true;
  return e.phase != ElementPhase::kCancel && !e.keep_vector && !e.direction &&
         (e.phase == ElementPhase::kStartUp || e.kind == ElementKind::kZero);
}

}  // namespace comp_detail

/// Elements that have to be known before the first one is carried out.
std::size_t CutterComp::lookAhead() const {
  if (policy_.interference_check) {
    return 3 + static_cast<std::size_t>(std::clamp(policy_.extra_look_ahead, 0, 8));
  }
  return 2;
}

/// The last of the elements behind the front that are plain and have its offset, or 0.
std::size_t CutterComp::lastOfRun() const {
  const double rho = elements_.size() > 1 ? elements_[1].rho_start : 0.0;
  std::size_t last = 0;
  while (last + 1 < elements_.size() && last < kMostAhead) {
    const Element& e = elements_[last + 1];
    if (!e.plain() || e.rho_start != rho || e.rho_end != rho) break;
    ++last;
    if (e.square_end) break;
  }
  return last;
}

/// That of the policy, or of the finest decimal that the contour behind the front is told to: some points of
/// a finer one end in 0, all of them never do.
double CutterComp::roundingTolerance() const {
  if (policy_.rounding_tolerance <= 0.0) return 0.0;
  const std::size_t last = lastOfRun();
  double finest = last > 0 ? elements_[1].decimal : 0.0;
  for (std::size_t i = 2; i <= last; ++i) finest = std::min(finest, elements_[i].decimal);
  return std::max(policy_.rounding_tolerance, 2.0 * finest);
}

/// True while the contour behind the front is not known as far as the cutter reaches.
bool CutterComp::waitsForContour() const {
  const Element& front = elements_.front();
  if (policy_.rounding_tolerance <= 0.0 || !leadsOn(front)) return false;
  const std::size_t last = lastOfRun();
  if (last + 1 < elements_.size() || last >= kMostAhead || last == 0) return false;
  const double reach = reachAhead(std::abs(elements_[1].rho_start), roundingTolerance());
  double length = 0.0;
  for (std::size_t i = 1; i <= last && length < reach; ++i) length += lengthOf(elements_[i]);
  return length < reach;
}

/// True if the front's corner, or the cutter as it comes to touch the element behind it, cuts into what is
/// known of the contour ahead, or the corner lies past that element, where the cutter touches nothing any
/// more.
bool CutterComp::missesContour() {
  const Corner& corner = cornerAfter(0);
  const std::size_t last = lastOfRun();
  if (last == 0 || corner.points.empty()) return false;
  const Element& next = elements_[1];
  const Vec2 along = corner.points.back() - planar(next.p0);
  if (next.kind == ElementKind::kLine && along.dot(startTangent(next)) > lengthOf(next) + kKeepsOff)
    return true;
  const Roll roll(elements_, last, elements_[1].rho_start);
  const Vec2 touching = planar(next.p0) + next.rho_start * leftOf(startTangent(next));
  const bool outside = along.dot(startTangent(next)) < kKeepsOff;
  return roll.depth(corner.points.front(), 1) > kKeepsOff || (outside && roll.depth(touching, 1) > kKeepsOff);
}

/// Where the disk stands before it rolls over the contour behind the front: on the front, or, where the front
/// has no offset of its own, behind the point at which the contour starts.
std::optional<RollPlace> CutterComp::rollStart() const {
  const std::size_t last = lastOfRun();
  const Element& front = elements_.front();
  if (last == 0 || elements_[1].rho_start == 0.0 || !leadsOn(front)) return std::nullopt;
  const double rho = elements_[1].rho_start;
  if (!front.plain()) {
    return RollPlace{planar(front.p1) - std::abs(rho) * startTangent(elements_[1]), 1, true};
  }
  if (front.rho_start != rho || front.rho_end != rho) return std::nullopt;
  return RollPlace{frontStart(), 0, front.pivot};
}

/// Rolls the cutter over the contour from the front on until it has passed element `index`. True if it leaves
/// nothing but rounding; the front then ends where the cutter touches the next element that it reaches.
bool CutterComp::rollsOver(std::size_t index) {
  const std::optional<RollPlace> start = rollStart();
  if (!start) return false;
  const Roll roll(elements_, lastOfRun(), elements_[1].rho_start);
  std::vector<RollPlace> stops{*start};
  const bool on_front = start->index == 0;
  const double tolerance = roundingTolerance();
  std::size_t own = 0;  // the stop at which the front's own part ends
  while (own == 0 || stops.back().index <= index) {
    if (stops.back().index > roll.last()) break;
    const RollPlace& at = stops.back();
    if (roll.depth(at.center, at.pivot ? at.index + 1 : at.index) > tolerance) return false;
    stops.push_back(roll.next(at));
    if (roll.unreached(stops[stops.size() - 2], stops.back()) > tolerance) return false;
    if (own == 0 && stops.back().index > 0) own = stops.size() - 1;
  }
  if (elements_.front().pivot && elements_.front().kind == ElementKind::kArc && own > 1) return false;
  // A point about which the cutter turns onto the element behind it belongs to the corner.
  std::size_t end = own;
  if (stops[own].pivot && stops[own].index <= roll.last()) {
    const RollPlace behind = own + 1 < stops.size() ? stops[own + 1] : roll.next(stops[own]);
    if (behind.index == stops[own].index) {
      if (own + 1 == stops.size()) stops.push_back(behind);
      end = own + 1;
    }
  }
  const bool own_end = stops[own].index == 1 && (on_front ? end > own && !start->pivot : !stops[own].pivot);
  if (own_end && cornerAfter(0).error == CompError::kNone) return true;  // its corner is right as it is
  Corner corner;
  for (std::size_t i = 1; i <= end; ++i) {
    if (i == 1 && !on_front) {
      corner.points.push_back(stops[1].center);
    } else {
      roll.way(stops[i - 1], stops[i], corner.points);
    }
  }
  endFrontAt(stops[end], roll.last(), std::move(corner));
  return true;
}

/// The front ends with `corner`; the next element is the one at `stop`.
void CutterComp::endFrontAt(const RollPlace& stop, std::size_t last, Corner corner) {
  const bool nothing_behind = stop.index > last && last + 1 == elements_.size();
  const std::size_t next = nothing_behind ? last : stop.index;
  PROVEOUT_ASSERT(next >= 1 && next < elements_.size());
  dropBehindFront(next - 1, std::move(corner));
  elements_[1].pivot = stop.pivot && stop.index <= last;
}

/// Decides whether the path may go on as the corners say, or with what else.
CompStatus CutterComp::checkFront(CompOutput& out) {
  for (std::size_t i = 0; policy_.arc_needs_room && i < 2 && i < elements_.size(); ++i) {
    if (lacksRoom(i)) return {CompError::kInterference, elements_[i].tag, elements_.front().tag};
  }
  if (policy_.rounding_tolerance > 0.0 && elements_.size() > 1 && !elements_.front().square_end) {
    Element& front = elements_.front();
    bool by_chord = false, rough = front.pivot || cornerAfter(0).error != CompError::kNone;
    std::size_t index = 1;
    if (cornerAfter(0).error == CompError::kNone) {
      index = firstInterference(by_chord);
      rough = rough || index > 0 || frontRunsBackwards() || (policy_.contour_check && missesContour());
    }
    if (rough && rollsOver(index)) return {};
    front.pivot = false;
  }
  const Corner& corner = cornerAfter(0);
  const std::uint64_t tag = elements_.front().tag;
  if (corner.error != CompError::kNone) {
    const bool in_next = corner.error == CompError::kNoIntersection && elements_.size() > 1;
    return {corner.error, in_next ? elements_[1].tag : tag, tag};
  }
  return policy_.interference_check ? checkInterference(out) : CompStatus{};
}

/// An arc inside that is no larger than the cutter.
bool CutterComp::lacksRoom(std::size_t index) const {
  const Element& e = elements_[index];
  if (e.kind != ElementKind::kArc || !e.plain() || (e.rho_start == 0.0 && e.rho_end == 0.0)) return false;
  return std::min(offsetRadiusAtStart(e), offsetRadiusAtEnd(e)) <= kReverseTolerance;
}

/// Index of the first element behind the front that interferes, within the look-ahead; 0 if none does. Sets
/// `by_chord` if no single element runs backwards, only the way from the front to the found one.
std::size_t CutterComp::firstInterference(bool& by_chord) {
  by_chord = false;
  const Element& front = elements_.front();
  const std::size_t limit = 1 + static_cast<std::size_t>(std::clamp(policy_.extra_look_ahead, 0, 8));
  for (std::size_t i = 1; i + 1 < elements_.size() && i <= limit; ++i) {
    const Element& e = elements_[i];
    if (!e.plain()) break;
    if (cornerAfter(i).error != CompError::kNone) break;
    const Vec2 end = cornerAfter(i).points.front();
    if (!cornerAfter(i).chord_arc && runsBackwards(e, cornerAfter(i - 1).points.back(), end)) return i;
    if (e.rho_start * front.rho_end < 0.0) break;  // behind a change of side chords mean nothing
    const Vec2 programmed = planar(e.p1) - planar(front.p1);
    const Vec2 compensated = end - cornerAfter(0).points.front();
    by_chord =
        policy_.chord_check && i >= 2 && programmed.dot(compensated) < -kReverseTolerance * programmed.norm();
    if (by_chord) return i;
  }
  return 0;
}

void CutterComp::dropBehindFront(std::size_t count, Corner corner) {
  PROVEOUT_ASSERT(count < elements_.size());
  Element& front = elements_.front();
  for (std::size_t i = 1; i <= count; ++i) {
    const auto& after = elements_[i].after;
    front.after.insert(front.after.end(), after.begin(), after.end());
  }
  elements_.erase(elements_.begin() + 1, elements_.begin() + 1 + static_cast<std::ptrdiff_t>(count));
  elements_.front().corner = std::move(corner);
}

/// True if an element between the front and element `k`, which runs backwards, can leave `k` out when its own
/// turn comes. Mending there loses less of the contour than mending at the front.
bool CutterComp::repairableLater(std::size_t k) {
  PROVEOUT_ASSERT(k >= 1 && k + 1 < elements_.size());
  const Element& next = elements_[k + 1];
  for (std::size_t m = k - 1; m >= 1; --m) {
    if (m == k - 1 && peelCorners(cornerAfter(m), cornerAfter(k), elements_[k])) return true;
    if (mends(elements_[m], next)) return true;
  }
  return false;
}

/// Leaves out elements 1..k so that the front meets what follows. Where that has no solution and element k
/// itself runs backwards (`extend`), leaves out more, as far as the look-ahead shows.
bool CutterComp::repair(std::size_t k, bool extend, CompOutput& out) {
  std::optional<Corner> corner;
  std::size_t dropped = k;
  if (k == 1) corner = peelCorners(cornerAfter(0), cornerAfter(1), elements_[1]);
  const std::size_t known = std::min(elements_.size(), lookAhead());
  for (; !corner && dropped + 1 < known; ++dropped) {
    if (const auto x = mends(elements_.front(), elements_[dropped + 1])) {
      corner.emplace().points = {*x};
      break;
    }
    if (!extend || !elements_[dropped + 1].plain()) break;
  }
  if (!corner) return false;
  out.notes.push_back({CompWarning::kRepaired, elements_[1].tag});
  dropBehindFront(dropped, std::move(*corner));
  return true;
}

/// What the look-ahead of earlier blocks could not see: the front itself, between fixed corners.
bool CutterComp::frontRunsBackwards() {
  const Element& front = elements_.front();
  const Corner& corner = cornerAfter(0);
  if (elements_.size() < 2 || !front.plain() || corner.chord_arc) return false;
  return runsBackwards(front, frontStart(), corner.points.front());
}

CompStatus CutterComp::checkInterference(CompOutput& out) {
  bool by_chord = false;
  while (const std::size_t k = firstInterference(by_chord)) {
    const CompStatus alarm{CompError::kInterference, elements_[k].tag, elements_.front().tag};
    if (policy_.interference_alarm) return alarm;
    if (k >= 2 && !by_chord && repairableLater(k)) break;
    if (!repair(k, !by_chord, out)) return alarm;
  }
  const std::uint64_t tag = elements_.front().tag;
  return frontRunsBackwards() ? CompStatus{CompError::kInterference, tag, tag} : CompStatus{};
}

}  // namespace proveout
