// What the wire EDM control supports: from the codes that execute, and the rows of the manual.
#include <fmt/core.h>

#include <array>

#include "core/nc/wedm/wedm_codes.h"

namespace proveout::nc {

namespace {

// clang-format off: one row a line
constexpr auto kWedmRows = std::to_array<CoverageIdRow>({
    {"wedm-1.1-charset", "STATE", "done", "tests/unit/nc/wedm_test.cpp"},
});
// clang-format on

std::string statusOfClass(std::string_view cls) {
  return cls == "SIM"     ? "simulated"
         : cls == "TIME"  ? "timed"
         : cls == "STATE" ? "tracked"
         : cls == "HOST"  ? "noted"
                          : "refused";
}

CoverageRow wedmRowOf(std::string code, int group, std::string_view cls, std::string_view ids,
                      std::string_view meaning) {
  return {std::move(code),     group, std::string(cls), statusOfClass(cls), std::string(ids),
          std::string(meaning)};
}

}  // namespace

std::vector<CoverageRow> wedmCoverage() {
  std::vector<CoverageRow> rows;
  for (const WedmGCode& g : wedmGCodes())
    rows.push_back(
        wedmRowOf(fmt::format("G{:02}", g.code), static_cast<int>(g.group), g.cls, g.ids, g.meaning));
  for (const WedmFunction& f : wedmFunctions())
    rows.push_back(wedmRowOf(fmt::format("{}{:02}", f.address, f.code), -1, f.cls, f.ids, f.meaning));
  for (const WedmFeature& f : wedmFeatures())
    rows.push_back(wedmRowOf(std::string(f.code), -1, f.cls, f.ids, f.meaning));
  return rows;
}

std::vector<CoverageIdRow> wedmCoverageIds() { return {kWedmRows.begin(), kWedmRows.end()}; }

std::map<std::string, std::string_view> wedmOpenReasons() {
  return {
      {"wedm-x-kerf", "the wire removes no material yet"},
      {"wedm-x-slug", "the wire removes no material yet"},
  };
}

}  // namespace proveout::nc
