#include "removal/process/part_choice.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/assert.h"

namespace proveout {
namespace {

std::optional<std::size_t> largestBeside(std::size_t body, const std::vector<double>& volumes) {
  std::optional<std::size_t> best;
  for (std::size_t k = 0; k < volumes.size(); ++k) {
    if (k != body && (!best || volumes[k] > volumes[*best])) best = k;
  }
  return best;
}

}  // namespace

PartChoice doubted(std::size_t body, const std::vector<double>& volumes) {
  PROVEOUT_ASSERT(body < volumes.size());
  PartChoice choice{body, largestBeside(body, volumes)};
  if (choice.rival && volumes[*choice.rival] < kNotableShare * volumes[body]) choice.rival.reset();
  return choice;
}

PartChoice largestOf(const std::vector<double>& volumes) {
  PROVEOUT_ASSERT(!volumes.empty());
  const auto largest = std::max_element(volumes.begin(), volumes.end());
  return doubted(static_cast<std::size_t>(largest - volumes.begin()), volumes);
}

std::string pointInNoBody(const Vec3& p) {
  return fmt::format("the point of the part (part_point) X{:g} Y{:g} Z{:g} lies in no body that is left",
                     p.x(), p.y(), p.z());
}

}  // namespace proveout
