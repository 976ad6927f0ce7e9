#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "app/commands.h"
#include "app/exit_codes.h"
#include "core/nc/registry/coverage.h"
#include "core/nc/registry/interpreter.h"

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

/// The word of a choice, else the number.
std::string defaultText(const ParameterInfo& parameter) {
  if (parameter.choices.empty()) return fmt::format("{:g}", parameter.default_value);
  std::istringstream words{std::string(parameter.choices)};
  std::string word;
  for (int k = 0; k <= static_cast<int>(parameter.default_value); ++k) words >> word;
  return "\"" + word + "\"";
}

std::string valuesText(const ParameterInfo& parameter) {
  if (!parameter.choices.empty()) return std::string(parameter.choices);
  return fmt::format("{:g} to {:g}", parameter.min, parameter.max);
}

/// What `[control.NAME]` of a job may set.
void printSettings(Console& console, const ControlInfo& control) {
  console.out << fmt::format("\nsettings, [control.{}] of a job\n{:<24} {:<14} {:<24}  {}\n",
                             control.settings_table, "name", "default", "values", "meaning");
  for (const ParameterInfo& p : parameterTable(control.id)) {
    const std::string name = p.count > 0 ? fmt::format("{}.1 to .{}", p.name, p.count) : std::string(p.name);
    console.out << fmt::format("{:<24} {:<14} {:<24}  {}\n", name, defaultText(p), valuesText(p), p.meaning);
  }
}

nlohmann::ordered_json settingsJson(const ControlInfo& control) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ParameterInfo& p : parameterTable(control.id)) {
    nlohmann::ordered_json one = {{"name", p.name}, {"default", p.default_value}, {"min", p.min},
                                  {"max", p.max},   {"count", p.count},           {"meaning", p.meaning}};
    if (!p.choices.empty()) one["choices"] = p.choices;
    list.push_back(std::move(one));
  }
  return {{"table", control.settings_table}, {"list", std::move(list)}};
}

using Rows = std::vector<SpecificationRow>;

/// Rows of the specification of one class or chapter.
struct Tally {
  int done = 0, open = 0;
  std::map<std::string, int> open_classes;
  void add(const SpecificationRow& row) {
    if (row.status == "done") {
      ++done;
    } else {
      ++open;
      ++open_classes[row.cls];
    }
  }
};

using Tallies = std::vector<std::pair<std::string, Tally>>;

Tally& tallyOf(Tallies& tallies, const std::string& key) {
  const auto found =
      std::find_if(tallies.begin(), tallies.end(), [&](const auto& entry) { return entry.first == key; });
  return found != tallies.end() ? found->second : tallies.emplace_back(key, Tally{}).second;
}

Tallies byClass(const Rows& rows) {
  Tallies tallies{{"SIM", {}}, {"TIME", {}}, {"STATE", {}}, {"HOST", {}}, {"REJECT", {}}};
  for (const SpecificationRow& row : rows) tallyOf(tallies, row.cls).add(row);
  return tallies;
}

/// By the number before the first point.
Tallies byChapter(const Rows& rows) {
  Tallies tallies;
  for (const SpecificationRow& row : rows) {
    tallyOf(tallies, row.chapter.substr(0, row.chapter.find('.'))).add(row);
  }
  return tallies;
}

Tally sumOf(const Rows& rows) {
  Tally sum;
  for (const SpecificationRow& row : rows) sum.add(row);
  return sum;
}

void printTally(Console& console, std::string_view key, const Tally& t) {
  std::string classes;
  for (const auto& [cls, count] : t.open_classes) classes += fmt::format("  {} {}", cls, count);
  console.out << fmt::format("{:<8} {:>5} {:>5} {:>5} {}\n", key, t.done + t.open, t.done, t.open, classes);
}

void printRows(Console& console, const Rows& rows) {
  console.out << fmt::format("\n{:<24} {:<6}  {:<8}  {}\n", "row", "class", "status", "proof; reason");
  for (const SpecificationRow& row : rows) {
    const std::string_view between = row.proof.empty() || row.reason.empty() ? "" : "; ";
    console.out << fmt::format("{:<24} {:<6}  {:<8}  {}{}{}\n", row.id, row.cls, row.status, row.proof,
                               between, row.reason);
  }
  console.out << fmt::format("\nrows of the specification\n{:<8} {:>5} {:>5} {:>5}   open by class\n",
                             "chapter", "rows", "done", "open");
  for (const auto& [chapter, t] : byChapter(rows)) printTally(console, chapter, t);
  console.out << fmt::format("{:<8} {:>5} {:>5} {:>5}\n", "class", "rows", "done", "open");
  for (const auto& [cls, t] : byClass(rows)) {
    console.out << fmt::format("{:<8} {:>5} {:>5} {:>5}\n", cls, t.done + t.open, t.done, t.open);
  }
  printTally(console, "all", sumOf(rows));
}

nlohmann::ordered_json rowsJson(const Rows& rows) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const SpecificationRow& row : rows) {
    list.push_back({{"id", row.id},
                    {"chapter", row.chapter},
                    {"class", row.cls},
                    {"status", row.status},
                    {"proof", row.proof},
                    {"reason", row.reason}});
  }
  return list;
}

nlohmann::ordered_json tallyJson(const Tally& t) {
  return {{"rows", t.done + t.open}, {"done", t.done}, {"open", t.open}};
}

nlohmann::ordered_json specificationJson(const Rows& rows) {
  nlohmann::ordered_json json = tallyJson(sumOf(rows));
  for (const auto& [cls, t] : byClass(rows)) json["classes"][cls] = tallyJson(t);
  for (const auto& [chapter, t] : byChapter(rows)) json["chapters"][chapter] = tallyJson(t);
  return json;
}

nlohmann::ordered_json toJson(const ControlInfo& control, const std::vector<CoverageRow>& rows,
                              const Rows& ids) {
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
          {"rows", rowsJson(ids)},
          {"specification", specificationJson(ids)}};
}

}  // namespace

int coverageCommand(const CoverageOptions& options, Console& console, ConsoleProgress&) {
  const auto named = [&](const ControlInfo& control) { return control.name == *options.control; };
  if (options.control && std::none_of(controls().begin(), controls().end(), named)) {
    return printError(console, findControl(*options.control).error());
  }
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ControlInfo& control : controls()) {
    if (options.control && control.name != *options.control) continue;
    const Rows rows = specificationRows(control.id);
    std::vector<CoverageRow> codes;
    if (control.built) {
      Result<std::vector<CoverageRow>> table = coverageTable(control.id);
      if (!table) return printError(console, table.error());
      codes = std::move(*table);
    }
    if (options.json) {
      list.push_back(toJson(control, codes, rows));
      if (options.settings) list.back()["settings"] = settingsJson(control);
      continue;
    }
    if (control.built) {
      printTable(console, control, codes);
    } else {
      console.out << fmt::format("{}: {} (not in this version)\n", control.name, control.summary);
    }
    if (options.settings) printSettings(console, control);
    if (!rows.empty()) printRows(console, rows);
  }
  if (options.json) {
    const nlohmann::ordered_json root = {{"schema", "proveout.coverage/1"}, {"controls", std::move(list)}};
    console.out << root.dump(2) << "\n";
  }
  return kExitOk;
}

}  // namespace proveout
