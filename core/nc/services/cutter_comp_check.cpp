// Interference check of cutter compensation and its repair by leaving out blocks (digest nct-3, 3.11).
#include <algorithm>

#include "core/nc/services/cutter_comp.h"
#include "core/nc/services/cutter_comp_corner.h"

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

}  // namespace comp_detail

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
    by_chord = i >= 2 && programmed.dot(compensated) < -kReverseTolerance * programmed.norm();
    if (by_chord) return i;
  }
  return 0;
}

void CutterComp::dropBehindFront(std::size_t count, Corner corner) {
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
  for (; !corner && dropped + 1 < elements_.size(); ++dropped) {
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

CompStatus CutterComp::checkInterference(CompOutput& out) {
  bool by_chord = false;
  while (const std::size_t k = firstInterference(by_chord)) {
    const CompStatus alarm{CompError::kInterference, elements_[k].tag, elements_.front().tag};
    if (policy_.interference_alarm) return alarm;
    if (k >= 2 && !by_chord && repairableLater(k)) break;
    if (!repair(k, !by_chord, out)) return alarm;
  }
  // What the look-ahead of earlier blocks could not see: the front itself, between fixed corners.
  const Element& front = elements_.front();
  const Corner& corner = cornerAfter(0);
  const bool judged = elements_.size() > 1 && front.plain() && !corner.chord_arc;
  if (judged && runsBackwards(front, frontStart(), corner.points.front())) {
    return {CompError::kInterference, front.tag, front.tag};
  }
  return {};
}

}  // namespace proveout
