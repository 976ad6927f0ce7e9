// The triangles around each vertex of a mesh that changes.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace proveout {

/// Fans that change are kept apart, so that the first state can be had back.
class VertexFans {
 public:
  explicit VertexFans(const TriMesh& mesh)
      : start_(mesh.positions.size() + 1, 0), all_(3 * mesh.triangles.size()) {
    for (const auto& t : mesh.triangles) {
      for (const std::uint32_t v : t) ++start_[v + 1];
    }
    for (std::size_t v = 1; v < start_.size(); ++v) start_[v] += start_[v - 1];
    std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      for (const std::uint32_t v : mesh.triangles[t]) all_[next[v]++] = t;
    }
  }
  std::span<const std::uint32_t> operator[](std::uint32_t v) const {
    const auto it = changed_.find(v);
    if (it != changed_.end()) return it->second;
    return {all_.data() + start_[v], all_.data() + start_[v + 1]};
  }
  /// Of a vertex, new ones too. Valid until reset().
  std::vector<std::uint32_t>& change(std::uint32_t v) {
    auto it = changed_.find(v);
    if (it == changed_.end()) {
      it = changed_.try_emplace(v).first;
      if (v + 1 < start_.size()) it->second = {all_.begin() + start_[v], all_.begin() + start_[v + 1]};
    }
    before_.emplace_back(v, it->second);
    return it->second;
  }
  /// What was changed is not to be taken back any more.
  void keep() { before_.clear(); }
  /// To how they were at keep().
  void takeBack() {
    for (auto it = before_.rbegin(); it != before_.rend(); ++it) changed_[it->first] = it->second;
    before_.clear();
  }
  /// To the first state.
  void reset() {
    changed_.clear();
    before_.clear();
  }

 private:
  std::vector<std::uint32_t> start_, all_;
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> changed_;
  std::vector<std::pair<std::uint32_t, std::vector<std::uint32_t>>> before_;  ///< since keep()
};

}  // namespace proveout
