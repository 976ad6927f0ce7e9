// The triangles around each vertex of a mesh that changes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace proveout {

/// Fans that change are kept apart from those of a whole mesh, which lie in one list.
class VertexFans {
 public:
  /// Of all triangles.
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
  /// Of some triangles, in their order: takes no memory for the others.
  VertexFans(const TriMesh& mesh, std::span<const std::uint32_t> triangles) {
    for (const std::uint32_t t : triangles) {
      for (const std::uint32_t v : mesh.triangles[t]) changed_[v].push_back(t);
    }
  }

  /// None of a vertex that has no triangles here. Valid until the fan changes.
  std::span<const std::uint32_t> operator[](std::uint32_t v) const {
    const auto it = changed_.find(v);
    if (it != changed_.end()) return it->second;
    if (v + 1 >= start_.size()) return {};
    return {all_.data() + start_[v], all_.data() + start_[v + 1]};
  }
  /// Of a vertex, new ones too.
  std::vector<std::uint32_t>& change(std::uint32_t v) {
    auto it = changed_.find(v);
    if (it == changed_.end()) {
      it = changed_.try_emplace(v).first;
      if (v + 1 < start_.size()) it->second = {all_.begin() + start_[v], all_.begin() + start_[v + 1]};
    }
    return it->second;
  }

 private:
  std::vector<std::uint32_t> start_, all_;
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> changed_;
};

}  // namespace proveout
