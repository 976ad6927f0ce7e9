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

}  // namespace comp_detail

/// Index of the first element behind the front that interferes, within the look-ahead; 0 if none does.
std::size_t CutterComp::firstInterference() {
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
    if (i >= 2 && programmed.dot(compensated) < -kReverseTolerance * programmed.norm()) return i;
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

/// Leaves out elements 1..k; false if no new corner can be found.
bool CutterComp::repair(std::size_t k, CompOutput& out) {
  if (policy_.interference_alarm) return false;
  std::optional<Corner> corner;
  if (k == 1) corner = peelCorners(cornerAfter(0), cornerAfter(1), elements_[1]);
  if (!corner) {
    const Element &front = elements_.front(), &next = elements_[k + 1];
    if (!front.plain() || !next.plain() || front.rho_end * next.rho_start <= 0.0) return false;
    const auto x = meetOffsets(front, next);
    if (!x) return false;
    corner.emplace().points = {*x};
  }
  out.notes.push_back({CompWarning::kRepaired, elements_[1].tag});
  dropBehindFront(k, std::move(*corner));
  return true;
}

CompStatus CutterComp::checkInterference(CompOutput& out) {
  while (const std::size_t k = firstInterference()) {
    const std::uint64_t offending = elements_[k].tag;
    if (!repair(k, out)) return {CompError::kInterference, offending, elements_.front().tag};
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
