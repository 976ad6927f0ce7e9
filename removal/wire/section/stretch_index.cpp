#include "removal/wire/section/stretch_index.h"

#include <algorithm>
#include <cmath>

namespace proveout {
namespace {

/// Boxes of arcs and slanting lines are cut into pieces, so that they hold little that is far away.
constexpr double kArcPiece = 0.25 * kPi;
/// Lines are cut where their box is longer than so many kerfs; into so many pieces at most.
constexpr double kLongLine = 64.0;
constexpr int kMostPieces = 64;
/// Distances that differ by less are equal, mm: the same way, gone twice.
constexpr double kEqual = 1e-8;

int piecesOf(const WireStretch& s) {
  if (s.isArc()) return std::max(1, static_cast<int>(std::ceil(std::abs(s.sweep_rad) / kArcPiece)));
  if (s.kerf_mm <= 0.0) return 1;
  const Vec2 d = (s.to - s.from).cwiseAbs();
  return std::clamp(static_cast<int>(d.minCoeff() / (kLongLine * s.kerf_mm)), 1, kMostPieces);
}

}  // namespace

StretchIndex::StretchIndex(const std::vector<WireStretch>& stretches) : stretches_(stretches) {
  std::vector<Box3> boxes;
  boxes.reserve(stretches.size());
  owner_.reserve(stretches.size());
  for (std::uint32_t i = 0; i < stretches.size(); ++i) {
    const WireStretch& s = stretches[i];
    const int count = piecesOf(s);
    for (int k = 0; k < count; ++k) {
      WireStretch piece = s;
      if (k > 0) piece.from = s.at(static_cast<double>(k) / count);
      if (k + 1 < count) piece.to = s.at((k + 1.0) / count);
      piece.sweep_rad = s.sweep_rad / count;
      boxes.push_back(boundsOf(piece).inflated(s.kerf_mm));
      owner_.push_back(i);
    }
  }
  tree_ = BoxTree(boxes);
}

StretchIndex::Found StretchIndex::nearest(const Vec2& p, double reach, std::uint32_t end) const {
  Found best;
  best.off_mm = reach;
  const Box3 box = Box3{Vec3(p.x(), p.y(), 0.0), Vec3(p.x(), p.y(), 0.0)}.inflated(reach);
  tree_.forEachPlace(box, [&](std::uint32_t place) {
    const std::uint32_t i = owner_[tree_.order()[place]];
    if (i >= end) return;
    const StretchDistance distance = distanceTo(stretches_[i], p);
    const double off = distance.mm - stretches_[i].kerf_mm;
    const double gain = best.off_mm - off;
    // Among equals the first counts, and its own distance, so that a row of equals cannot drift.
    if (gain > kEqual || (gain >= -kEqual && i < best.stretch))
      best = {i, distance.part, std::min(off, best.off_mm)};
  });
  return best;
}

std::vector<std::uint32_t> StretchIndex::near(const Box3& box, std::uint32_t end) const {
  std::vector<std::uint32_t> out;
  tree_.forEachPlace(box, [&](std::uint32_t place) {
    const std::uint32_t i = owner_[tree_.order()[place]];
    if (i < end) out.push_back(i);
  });
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace proveout
