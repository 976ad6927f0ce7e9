#include "core/nc/iso/model/code_coverage.h"

#include <fmt/core.h>

#include <utility>

namespace proveout::nc {
namespace {

std::string_view statusOf(CodeClass cls, bool built) {
  if (!built) return "refused";
  return cls == CodeClass::kReject ? "checked" : coverageStatus(codeClassName(cls));
}

/// `code`: a row of the tables, whatever its kind.
template <class Code>
CoverageRow rowOf(std::string name, int group, const Code& code, bool built) {
  return {std::move(name),
          group,
          std::string(codeClassName(code.cls)),
          std::string(statusOf(code.cls, built)),
          std::string(code.ids),
          std::string(code.meaning)};
}

}  // namespace

std::vector<CoverageRow> coverageOf(const CodeIndex& codes) {
  std::vector<CoverageRow> rows;
  for (const GCode* g : codes.allG()) {
    const int number = g->number10();
    std::string name = fmt::format("G{}", number / 10);
    if (number % 10 != 0) name += fmt::format(".{}", number % 10);
    rows.push_back(rowOf(std::move(name), g->group, *g, g->built));
  }
  for (const MCode* m : codes.allM()) rows.push_back(rowOf(fmt::format("M{}", m->code), -1, *m, true));
  for (const FeatureRow* f : codes.allFeatures())
    rows.push_back(rowOf(std::string(f->code), -1, *f, f->built));
  return rows;
}

std::vector<CoverageIdRow> joinRows(std::initializer_list<std::span<const CoverageIdRow>> parts) {
  std::vector<CoverageIdRow> all;
  for (const auto part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

std::map<std::string, std::string_view> notBuiltYet(const std::vector<CoverageIdRow>& rows) {
  std::map<std::string, std::string_view> reasons;
  for (const CoverageIdRow& row : rows)
    if (row.status != "done") reasons.emplace(row.id, "not built yet");
  return reasons;
}

}  // namespace proveout::nc
