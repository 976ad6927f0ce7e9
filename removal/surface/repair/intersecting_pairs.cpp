#include "removal/surface/repair/intersecting_pairs.h"

#include <algorithm>

namespace proveout {

IntersectingPairs::IntersectingPairs(const MeshEditor& edit, const RepairBlocks& blocks, double reach_mm,
                                     const std::vector<std::uint32_t>& triangles,
                                     std::vector<std::uint32_t>& seen)
    : edit_(edit), space_(blocks), reach_(reach_mm), seen_(seen) {
  for (const std::uint32_t t : triangles) insert(t);
}

void IntersectingPairs::insert(std::uint32_t t) {
  space_.each(boxOf(points(t)), [&](std::uint64_t key) {
    auto& list = blocks_[key];
    if (list.empty() || list.back() != t) list.push_back(t);
  });
}

void IntersectingPairs::findNear(const std::vector<std::uint32_t>& triangles) {
  near_.clear();
  ++search_;
  Box3 box;
  for (const std::uint32_t t : triangles) {
    seen_[t] = search_;
    if (edit_.gone(t)) continue;
    box.extend(boxOf(points(t)));
  }
  if (box.empty()) return;
  box = box.inflated(reach_);
  space_.each(box, [&](std::uint64_t key) {
    const auto found = blocks_.find(key);
    if (found == blocks_.end()) return;
    for (const std::uint32_t u : found->second) {
      if (seen_[u] == search_ || edit_.gone(u)) continue;
      seen_[u] = search_;
      const Near near{u, boxOf(points(u))};
      if (near.box.overlaps(box)) near_.push_back(near);
    }
  });
}

std::size_t IntersectingPairs::find(const std::vector<std::uint32_t>& triangles, std::size_t most,
                                    std::vector<TrianglePair>* found) {
  findNear(triangles);
  std::size_t count = 0;
  const auto look = [&](std::uint32_t t, std::uint32_t u) {
    const TrianglePair pair{std::min(t, u), std::max(t, u)};
    if (!meets(pair)) return;
    ++count;
    if (found != nullptr) found->push_back(pair);
  };
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::uint32_t t = triangles[i];
    if (edit_.gone(t)) continue;
    const Box3 box = boxOf(points(t));
    for (std::size_t j = 0; j <= i && count <= most; ++j) look(t, triangles[j]);
    for (std::size_t j = 0; j < near_.size() && count <= most; ++j) {
      if (near_[j].box.overlaps(box)) look(t, near_[j].triangle);
    }
  }
  return count;
}

bool IntersectingPairs::meets(const TrianglePair& pair) const {
  if (edit_.gone(pair[0]) || edit_.gone(pair[1])) return false;
  return pair[0] == pair[1] ? isNeedle(edit_.mesh(), pair[0]) : trianglesMeet(edit_.mesh(), pair[0], pair[1]);
}

std::vector<TrianglePair> IntersectingPairs::among(const std::vector<std::uint32_t>& triangles) {
  std::vector<TrianglePair> out;
  for (const std::uint32_t t : triangles) {
    if (edit_.gone(t)) continue;
    if (isNeedle(edit_.mesh(), t)) out.push_back({t, t});
    findNear({t});
    for (const Near& near : near_) {
      if (near.triangle > t && trianglesMeet(edit_.mesh(), t, near.triangle))
        out.push_back({t, near.triangle});
    }
  }
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace proveout
