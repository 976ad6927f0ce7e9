#include "removal/turning/threads/slice_strips.h"

#include <optional>

#include "core/base/assert.h"

namespace proveout::thread_detail {

SliceStrips::SliceStrips(std::span<const Slice* const> slices,
                         std::span<const std::vector<LoopMatch>> matches)
    : slices_(slices), covered_(slices.size()) {
  PROVEOUT_ASSERT(!slices.empty() && matches.size() + 1 == slices.size());
  for (std::size_t k = 0; k < slices.size(); ++k) {
    for (const CornerLoop& loop : slices[k]->loops) covered_[k].emplace_back(loop.size());
  }
  follow(matches);
  for (std::size_t l = 0; l < ways_.size(); ++l) {
    for (std::size_t i = 0; i < ways_[l].size(); ++i) {
      if (!goesThrough(l, i)) continue;
      for (std::size_t k = 0; k < slices.size(); ++k)
        covered_[k][ways_[l][i][k].loop][ways_[l][i][k].corner] = 1;
    }
  }
  for (std::size_t l = 0; l < ways_.size(); ++l) {
    for (std::size_t i = 0; i < ways_[l].size(); ++i) {
      if (covers(0, l, i)) addStrip(l, i);
    }
  }
}

void SliceStrips::follow(std::span<const std::vector<LoopMatch>> matches) {
  for (std::size_t l = 0; l < slices_.front()->loops.size(); ++l) {
    std::vector<Way>& ways = ways_.emplace_back();
    for (std::size_t i = 0; i < slices_.front()->loops[l].size(); ++i) ways.push_back({Place{l, i}});
  }
  for (std::size_t k = 0; k < matches.size(); ++k) {
    std::vector<std::vector<std::optional<Place>>> next;
    for (const CornerLoop& loop : slices_[k]->loops) next.emplace_back(loop.size());
    for (const LoopMatch& match : matches[k]) {
      for (const auto& [a, b] : match.corners) next[match.a][a] = Place{match.b, b};
    }
    for (std::vector<Way>& ways : ways_) {
      for (Way& way : ways) {
        if (way.empty()) continue;
        if (const std::optional<Place>& to = next[way.back().loop][way.back().corner])
          way.push_back(*to);
        else
          way.clear();
      }
    }
  }
}

/// Whether the edge behind a corner of the first section is an edge in all others.
bool SliceStrips::goesThrough(std::size_t loop, std::size_t corner) const {
  const std::vector<Way>& ways = ways_[loop];
  const Way &from = ways[corner], &to = ways[(corner + 1) % ways.size()];
  if (from.empty() || to.empty()) return false;
  for (std::size_t k = 0; k < slices_.size(); ++k) {
    const std::size_t size = slices_[k]->loops[from[k].loop].size();
    if (from[k].loop != to[k].loop || (from[k].corner + 1) % size != to[k].corner) return false;
  }
  return true;
}

void SliceStrips::addStrip(std::size_t loop, std::size_t corner) {
  const std::vector<Way>& ways = ways_[loop];
  const std::size_t n = ways.size(), before = (corner + n - 1) % n, behind = (corner + 1) % n;
  strips_.push_back({slices_.front()->loops[loop][corner].out,
                     pointsOf(ways[corner], !covers(0, loop, before)),
                     pointsOf(ways[behind], !covers(0, loop, behind))});
}

std::vector<Strip::Point> SliceStrips::pointsOf(const Way& way, bool all) const {
  std::vector<Strip::Point> points;
  for (std::size_t k = 0; k < way.size(); ++k) {
    if (all || k == 0 || k + 1 == way.size())
      points.push_back({k, slices_[k]->loops[way[k].loop][way[k].corner].vertex});
  }
  return points;
}

}  // namespace proveout::thread_detail
