#include "removal/compare/spots.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "core/base/assert.h"
#include "core/mesh/edge_table.h"

namespace proveout {

namespace {

/// Spots of one cause are about as deep as each other.
constexpr double kDepthRatio = 5.0;
/// Whoever made less of a patch does not count.
constexpr double kLeastShare = 0.05;
/// Where no motion is known, in samples.
constexpr double kSamplesApart = 2.0;
/// Of the makers of a patch that neighbours are asked about.
constexpr std::size_t kAskedMakers = 8;

double gapBetween(const Box3& a, const Box3& b) {
  return (a.min - b.max).cwiseMax(b.min - a.max).cwiseMax(Vec3::Zero()).norm();
}

bool alikeDeep(const DeviationPatch& a, const DeviationPatch& b) {
  return a.depth_mm < kDepthRatio * b.depth_mm && b.depth_mm < kDepthRatio * a.depth_mm;
}

class SpotJoiner {
 public:
  SpotJoiner(const std::vector<FoundPatch>& found, const CompareOptions& options)
      : found_(found), options_(options), sets_(found.size()) {}

  DisjointSets run() {
    joinMotions();
    joinNeighbours();
    return std::move(sets_);
  }

 private:
  void joinMotions() {
    std::map<SurfaceMaker, std::vector<std::uint32_t>> patches_of;
    for (std::uint32_t i = 0; i < found_.size(); ++i) {
      for (const MakerShare& m : found_[i].patch.makers) {
        if (m.maker.motion != kNoMotion && m.share >= kLeastShare) patches_of[m.maker].push_back(i);
      }
    }
    for (const auto& [maker, patches] : patches_of) {
      for (const std::uint32_t i : patches) {
        if (alikeDeep(found_[i].patch, found_[patches.front()].patch)) sets_.join(i, patches.front());
      }
    }
  }

  double gapOf(const DeviationPatch& a, const DeviationPatch& b) const {
    if (!options_.spot_gap) return kSamplesApart * options_.resolution_mm;
    double most = -1.0;
    for (std::size_t i = 0; i < std::min(kAskedMakers, a.makers.size()); ++i) {
      for (std::size_t j = 0; j < std::min(kAskedMakers, b.makers.size()); ++j)
        most = std::max(most, options_.spot_gap(a.makers[i].maker, b.makers[j].maker));
    }
    return most;
  }

  /// From low to high X, each with those that it may reach.
  void joinNeighbours() {
    std::vector<std::uint32_t> order(found_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return found_[a].patch.bounds.min.x() < found_[b].patch.bounds.min.x();
    });
    constexpr std::size_t kMostAsked = 256;
    for (std::size_t i = 0; i < order.size(); ++i) {
      const DeviationPatch& a = found_[order[i]].patch;
      for (std::size_t j = i + 1; j < std::min(order.size(), i + kMostAsked); ++j) {
        const DeviationPatch& b = found_[order[j]].patch;
        if (sets_.find(order[i]) == sets_.find(order[j]) || !alikeDeep(a, b)) continue;
        if (gapBetween(a.bounds, b.bounds) <= gapOf(a, b)) sets_.join(order[i], order[j]);
      }
    }
  }

  const std::vector<FoundPatch>& found_;
  const CompareOptions& options_;
  DisjointSets sets_;
};

void join(FoundPatch& from, FoundPatch& into) {
  if (from.patch.depth_mm > into.patch.depth_mm) {
    into.deepest_on_nominal = from.deepest_on_nominal;
    into.opposite = from.opposite;
  }
  into.machined.deepen(from.machined);
  joinPatch(from.patch, into.patch);
  if (from.surest.margin() > into.surest.margin()) into.surest = from.surest;
  for (std::size_t k = 0; k < 2; ++k) into.volumes[k] += from.volumes[k];
  into.places.insert(into.places.end(), from.places.begin(), from.places.end());
}

}  // namespace

std::vector<FoundPatch> joinSpots(std::vector<FoundPatch> found, const CompareOptions& options) {
  DisjointSets sets = SpotJoiner(found, options).run();
  std::vector<FoundPatch> out;
  std::vector<std::size_t> place(found.size());
  for (std::uint32_t i = 0; i < found.size(); ++i) {
    const std::uint32_t first = sets.find(i);
    PROVEOUT_ASSERT(first <= i);  // the representative is the smallest of its set
    if (first == i) {
      place[i] = out.size();
      out.push_back(std::move(found[i]));
    } else {
      join(found[i], out[place[first]]);
    }
  }
  return out;
}

}  // namespace proveout
