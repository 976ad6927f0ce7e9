#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/exit_codes.h"
#include "core/nc/coverage.h"
#include "core/nc/interpreter.h"

namespace proveout {
namespace {

void printTable(Console& console, const ControlInfo& control, const std::vector<CoverageRow>& rows) {
  console.out << fmt::format("{}: {}\n", control.name, control.summary);
  console.out << fmt::format("{:<10} {:>5}  {:<6}  {:<9}  {}\n", "code", "group", "class", "status",
                             "meaning [ids]");
  for (const CoverageRow& row : rows) {
    const std::string group = row.group < 0 ? "-" : fmt::format("{}", row.group);
    const std::string ids = row.ids.empty() ? "" : fmt::format(" [{}]", row.ids);
    console.out << fmt::format("{:<10} {:>5}  {:<6}  {:<9}  {}{}\n", row.code, group, row.cls, row.status,
                               row.meaning, ids);
  }
}

/// Rows of one class: asked are all that are not deferred; done ones count where a test proves them.
struct Tally {
  std::string_view cls;
  int done = 0, unproven = 0, partly = 0, missing = 0, deferred = 0;
  int asked() const { return done + unproven + partly + missing; }
};

std::vector<Tally> tally(const std::vector<CoverageIdRow>& ids) {
  std::vector<Tally> classes{{"SIM"}, {"TIME"}, {"STATE"}, {"HOST"}, {"REJECT"}, {"all"}};
  for (const CoverageIdRow& row : ids) {
    for (Tally& t : classes) {
      if (t.cls != row.cls && t.cls != "all") continue;
      if (row.status == "done") ++(row.proof.empty() ? t.unproven : t.done);
      if (row.status == "partly") ++t.partly;
      if (row.status == "missing") ++t.missing;
      if (row.status == "deferred") ++t.deferred;
    }
  }
  return classes;
}

void printIds(Console& console, const std::vector<CoverageIdRow>& ids) {
  console.out << fmt::format("\n{:<24} {:<6}  {:<8}  {}\n", "row", "class", "status", "proof");
  for (const CoverageIdRow& row : ids) {
    const bool unproven = row.status == "done" && row.proof.empty();
    console.out << fmt::format("{:<24} {:<6}  {:<8}  {}\n", row.id, row.cls, row.status,
                               unproven ? std::string_view("no test names it") : row.proof);
  }
  console.out << "\nrows done / asked\n";
  for (const Tally& t : tally(ids)) {
    console.out << fmt::format(
        "{:<6} {:>3} / {:>3}   done without a test {}, partly {}, missing {}, deferred {}\n", t.cls, t.done,
        t.asked(), t.unproven, t.partly, t.missing, t.deferred);
  }
}

nlohmann::ordered_json idsJson(const std::vector<CoverageIdRow>& ids) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const CoverageIdRow& row : ids) {
    rows.push_back({{"id", row.id}, {"class", row.cls}, {"status", row.status}, {"proof", row.proof}});
  }
  return rows;
}

nlohmann::ordered_json sumsJson(const std::vector<CoverageIdRow>& ids) {
  nlohmann::ordered_json sums;
  for (const Tally& t : tally(ids)) {
    sums[std::string(t.cls)] = {{"done", t.done},     {"asked", t.asked()},   {"unproven", t.unproven},
                                {"partly", t.partly}, {"missing", t.missing}, {"deferred", t.deferred}};
  }
  return sums;
}

nlohmann::ordered_json toJson(const ControlInfo& control, const std::vector<CoverageRow>& rows,
                              const std::vector<CoverageIdRow>& ids) {
  nlohmann::ordered_json codes = nlohmann::ordered_json::array();
  for (const CoverageRow& row : rows) {
    nlohmann::ordered_json code = {{"code", row.code}, {"class", row.cls},       {"status", row.status},
                                   {"ids", row.ids},   {"meaning", row.meaning}, {"group", nullptr}};
    if (row.group >= 0) code["group"] = row.group;
    codes.push_back(std::move(code));
  }
  return {{"control", control.name},
          {"summary", control.summary},
          {"codes", std::move(codes)},
          {"rows", idsJson(ids)},
          {"done", sumsJson(ids)}};
}

}  // namespace

int coverageCommand(const CoverageOptions& options, Console& console, ConsoleProgress&) {
  if (options.control) {
    if (const Result<ControlId> known = findControl(*options.control); !known) {
      return printError(console, known.error());
    }
  }
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ControlInfo& control : controls()) {
    if (options.control && control.name != *options.control) continue;
    if (!control.built) {
      if (!options.json)
        console.out << fmt::format("{}: {} (not in this version)\n", control.name, control.summary);
      continue;
    }
    const Result<std::vector<CoverageRow>> rows = coverageTable(control.id);
    if (!rows) return printError(console, rows.error());
    const Result<std::vector<CoverageIdRow>> ids = coverageIds(control.id);
    if (!ids) return printError(console, ids.error());
    if (options.json) {
      list.push_back(toJson(control, *rows, *ids));
    } else {
      printTable(console, control, *rows);
      printIds(console, *ids);
    }
  }
  if (options.json) {
    const nlohmann::ordered_json root = {{"schema", "proveout.coverage/1"}, {"controls", std::move(list)}};
    console.out << root.dump(2) << "\n";
  }
  return kExitOk;
}

}  // namespace proveout
