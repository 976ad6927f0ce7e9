#include "core/nc/registry/coverage.h"

#include <fmt/core.h>

#include <map>
#include <sstream>

#include "core/nc/registry/controls.h"

namespace proveout {
namespace {

/// A code has one class for all rows that it serves.
std::map<std::string, const CoverageRow*> servedBy(const std::vector<CoverageRow>& codes) {
  std::map<std::string, const CoverageRow*> served;
  for (const CoverageRow& code : codes) {
    std::istringstream ids(code.ids);
    for (std::string id; ids >> id;) {
      const CoverageRow*& row = served[id];
      if (row == nullptr) row = &code;
    }
  }
  return served;
}

/// What the control says about its rows.
class Claims {
 public:
  explicit Claims(ControlId control) {
    if (const auto reasons = nc::rowOf(control).open_reasons) reasons_ = reasons();
    if (Result<std::vector<CoverageIdRow>> rows = coverageIds(control)) {
      for (const CoverageIdRow& row : *rows) claims_.emplace(row.id, row);
      built_ = true;
    }
    if (Result<std::vector<CoverageRow>> codes = coverageTable(control)) codes_ = *codes;
    served_ = servedBy(codes_);
  }
  void judge(SpecificationRow& row) const {
    const auto claim = claims_.find(row.id);
    const auto reason = reasons_.find(row.id);
    const bool done =
        claim != claims_.end() && claim->second.status == "done" && !claim->second.proof.empty();
    if (done) {
      row.status = "done";
      row.proof = claim->second.proof;
      const auto code = served_.find(row.id);
      if (code != served_.end() && code->second->cls != row.cls) {
        row.reason = fmt::format("served by {}, which as a whole is {} ({})", code->second->code,
                                 code->second->cls, code->second->status);
      }
    } else if (!built_ || reason != reasons_.end()) {
      row.status = "open";
      row.reason = built_ ? reason->second : "the control is not built";
    } else {
      row.status = "unlisted";
      row.reason = "the control neither proves it nor lists it as open";
    }
  }

 private:
  std::map<std::string, std::string_view> reasons_;
  std::map<std::string_view, CoverageIdRow> claims_;
  std::vector<CoverageRow> codes_;
  std::map<std::string, const CoverageRow*> served_;
  bool built_ = false;
};

}  // namespace

Result<std::vector<CoverageIdRow>> coverageIds(ControlId control) {
  if (const auto ids = nc::rowOf(control).coverage_ids) return ids();
  return inputError(nc::kNotBuilt);
}

std::vector<SpecificationRow> specificationRows(ControlId control) {
  const nc::ManualRows& manual = nc::rowOf(control).manual;
  const Claims claims(control);
  std::vector<SpecificationRow> rows;
  std::istringstream lines{std::string(manual.text)};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    SpecificationRow row;
    words >> row.chapter >> row.cls;
    for (std::string name; words >> name;) {
      // A chapter of another prefix begins with it: "haas-18".
      const bool own = row.chapter.find('-') == std::string::npos;
      row.id = own ? fmt::format("{}-{}-{}", manual.prefix, row.chapter, name)
                   : fmt::format("{}-{}", row.chapter, name);
      row.reason.clear();
      row.proof = {};
      claims.judge(row);
      rows.push_back(row);
    }
  }
  return rows;
}

}  // namespace proveout
