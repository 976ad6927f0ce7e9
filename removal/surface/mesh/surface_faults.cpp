#include "removal/surface/mesh/surface_faults.h"

#include <algorithm>
#include <array>

#include "core/mesh/vertex_links.h"

namespace proveout {

void findBrokenFans(const TriMesh& mesh, const std::vector<std::uint32_t>& name,
                    std::vector<std::uint32_t>& broken) {
  std::array<std::vector<std::uint32_t>, kLinkStretches> found;
  const auto watched = [&](std::uint32_t v) { return name[v] != kNoWatch; };
  forEachLink(mesh, watched, [&](std::size_t stretch, std::uint32_t v, std::span<LinkEdge> link) {
    if (link.size() > 2 && isOneCycle(link)) return;
    found[stretch].push_back(name[v]);
    std::sort(link.begin(), link.end());
    for (std::size_t i = 1; i < link.size(); ++i) {
      const std::uint32_t end = link[i].front();
      if (end == link[i - 1].front() && watched(end)) found[stretch].push_back(name[end]);
    }
  });
  for (const auto& list : found) broken.insert(broken.end(), list.begin(), list.end());
}

}  // namespace proveout
