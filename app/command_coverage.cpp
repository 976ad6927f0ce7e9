#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/exit_codes.h"
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

nlohmann::ordered_json toJson(const ControlInfo& control, const std::vector<CoverageRow>& rows) {
  nlohmann::ordered_json codes = nlohmann::ordered_json::array();
  for (const CoverageRow& row : rows) {
    nlohmann::ordered_json code = {{"code", row.code}, {"class", row.cls},       {"status", row.status},
                                   {"ids", row.ids},   {"meaning", row.meaning}, {"group", nullptr}};
    if (row.group >= 0) code["group"] = row.group;
    codes.push_back(std::move(code));
  }
  return {{"control", control.name}, {"summary", control.summary}, {"codes", std::move(codes)}};
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
    if (options.json) {
      list.push_back(toJson(control, *rows));
    } else {
      printTable(console, control, *rows);
    }
  }
  if (options.json) {
    const nlohmann::ordered_json root = {{"schema", "proveout.coverage/1"}, {"controls", std::move(list)}};
    console.out << root.dump(2) << "\n";
  }
  return kExitOk;
}

}  // namespace proveout
