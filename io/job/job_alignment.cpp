// How the nominal is brought to the part: `align` and its kin of [nominal].
#include <fmt/format.h>

#include <algorithm>

#include "io/job/job_sections.h"

namespace proveout {

namespace {

constexpr std::size_t kDatums = 3;

/// Points on the datum features, in their order.
void readDatums(ConfigTable& table, AlignWish& wish) {
  const bool wanted = wish.kind == AlignKind::kDatums;
  const std::vector<ConfigValue>* points = table.list("datums", kDatums);
  if (table.find("datums") == nullptr) {
    if (wanted)
      table.error("align", "job-missing",
                  "align = \"datums\" needs `datums`: points on a plane, a hole and another hole, "
                  "[[x, y, z], [x, y, z], [x, y, z]]");
    return;
  }
  if (!wanted) table.error("datums", "job-value", "`datums` are for align = \"datums\"");
  if (points == nullptr) return;
  if (points->size() != kDatums) {
    table.error(
        "datums", "job-value",
        fmt::format("datums are three points, on a plane, a hole and another hole, not {}", points->size()));
    return;
  }
  for (std::size_t k = 0; k < kDatums; ++k) {
    if (const auto at = readPoint(table.document(), (*points)[k], fmt::format("datum {}", k + 1), kAnyLength))
      wish.datums.push_back(*at);
  }
}

}  // namespace

void readAlignment(ConfigTable& table, NominalSpec& nominal) {
  static const std::vector<std::string> kKinds = {"none", "fit", "datums"};
  AlignWish& wish = nominal.align;
  if (const auto kind = table.choice("align", kKinds))
    wish.kind = static_cast<AlignKind>(std::find(kKinds.begin(), kKinds.end(), *kind) - kKinds.begin());
  if (const auto limit = table.number("align_limit", kPositiveLength)) wish.limit_mm = *limit;
  if (wish.kind == AlignKind::kNone && table.find("align_limit") != nullptr)
    table.error("align_limit", "job-value", "`align_limit` is for align = \"fit\" or \"datums\"");
  readDatums(table, wish);
}

}  // namespace proveout
