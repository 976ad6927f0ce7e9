// [[stock.start_hole]]: holes that a wire is threaded through.
#include <optional>

#include "io/job/job_sections.h"

namespace proveout {
namespace {

/// `at = [x, y]`; the key is there.
std::optional<Vec2> readPlace(ConfigTable& hole) {
  const ConfigValue* value = hole.find("at");
  if (value->type != ConfigValue::Type::kArray || value->items.size() != 2) {
    hole.error("at", "job-type", "at must be a list of two numbers, [x, y]: holes go along Z");
    return std::nullopt;
  }
  const auto x = readNumber(hole.document(), value->items[0], "at x", kAnyLength);
  const auto y = readNumber(hole.document(), value->items[1], "at y", kAnyLength);
  if (!x || !y) return std::nullopt;
  return Vec2(*x, *y);
}

}  // namespace

void readStartHoles(ConfigTable& stock, Job& job) {
  for (ConfigTable& table : stock.tables("start_hole")) {
    const auto at = table.require("at") != nullptr ? readPlace(table) : std::nullopt;
    const auto diameter = table.must("diameter").number("diameter", kPositiveLength);
    table.refuseOthers();
    if (at && diameter) job.start_holes.push_back({*at, *diameter});
  }
}

}  // namespace proveout
