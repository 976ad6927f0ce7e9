// The control of a job file and its settings.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/base/printable.h"
#include "io/job/control_texts.h"
#include "io/job/job_sections.h"

namespace proveout {

using Type = ConfigValue::Type;

namespace {

std::vector<ParameterRange> parameterRanges(const JobNames& names, const std::string& control) {
  const auto found = names.parameters.find(control);
  return found == names.parameters.end() ? std::vector<ParameterRange>() : found->second;
}

/// Reads `N1339 = 0.01` and `N1337.SEC = 1`, which TOML turns into a table.
class ParameterReader {
 public:
  /// `control`: whose parameters these are; they go to `values`, settings that are no numbers to the job.
  ParameterReader(const ConfigDocument& document, const JobNames& names, std::string control,
                  std::map<std::string, double>& values, Job& job)
      : document_(document),
        control_(std::move(control)),
        values_(values),
        texts_(document, names, control_, job),
        ranges_(parameterRanges(names, control_)) {
    for (const ParameterRange& range : ranges_) known_.push_back(range.name);
  }

  void read(const std::vector<ConfigEntry>& entries, const std::string& prefix) {
    for (const ConfigEntry& entry : entries) {
      const std::string name = prefix + entry.key;
      if (prefix.empty() && texts_.take(entry)) continue;
      if (entry.value.type == Type::kTable) {
        read(entry.value.entries, name + ".");
      } else {
        readOne(entry, name);
      }
    }
  }

 private:
  static bool stands(const ParameterRange& known, const std::string& name) {
    if (known.name == name) return true;
    if (known.count == 0 || !name.starts_with(known.name + ".")) return false;
    const std::string number = name.substr(known.name.size() + 1);
    for (int k = 1; k <= known.count; ++k) {
      if (number == std::to_string(k)) return true;
    }
    return false;
  }

  void readOne(const ConfigEntry& entry, const std::string& name) {
    if (document_.full()) return;
    NumberRange range{-1e12, 1e12, false};
    const auto found = std::find_if(ranges_.begin(), ranges_.end(),
                                    [&](const ParameterRange& known) { return stands(known, name); });
    if (found != ranges_.end()) {
      range = {found->min, found->max, false};
    } else if (!ranges_.empty()) {
      const std::string nearest = nearestName(name, known_);
      document_.error(entry.place, "job-unknown-key",
                      fmt::format("control '{}' has no parameter '{}'{}", control_, shortened(name),
                                  nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
      return;
    }
    const auto number = found != ranges_.end() && !found->choices.empty()
                            ? readChoice(entry, name, found->choices)
                            : readNumber(document_, entry.value, name, range);
    if (number && !values_.emplace(name, *number).second) {
      document_.error(entry.place, "job-value", fmt::format("parameter '{}' is set twice", name));
    }
  }

  /// Index of the word.
  std::optional<double> readChoice(const ConfigEntry& entry, const std::string& name,
                                   const std::vector<std::string>& choices) const {
    const auto text = readText(document_, entry.value, name);
    if (!text) return std::nullopt;
    const auto found = std::find(choices.begin(), choices.end(), *text);
    if (found != choices.end()) return static_cast<double>(found - choices.begin());
    unknownChoice(document_, entry.value.place, name, *text, choices);
    return std::nullopt;
  }

  const ConfigDocument& document_;
  std::string control_;
  std::map<std::string, double>& values_;
  ControlTexts texts_;
  std::vector<ParameterRange> ranges_;
  std::vector<std::string> known_;
};

void readControlName(ConfigTable& table, const std::string& key, const JobNames& names, Job& job) {
  std::vector<std::string> known = names.controls;
  known.emplace_back(kAutoControl);
  const bool given = table.find(key) != nullptr;
  const auto name = names.controls.empty() ? table.text(key) : table.choice(key, known);
  if (name)
    job.control = *name;
  else if (!given)
    job.control = kAutoControl;
}

/// NAME of `[control.NAME]`.
std::string settingsTableOf(const JobNames& names, const std::string& control) {
  const auto found = names.settings_tables.find(control);
  return found == names.settings_tables.end() ? control : found->second;
}

/// Where the program says which control it is for, the job may have settings of each that it can be.
void readSettingsOfAll(ConfigTable& control, const JobNames& names, Job& job) {
  for (const std::string& name : names.controls) {
    const std::string table = settingsTableOf(names, name);
    if (job.settings_by_table.contains(table)) continue;
    auto parameters = control.table(table);
    if (!parameters) continue;
    ParameterReader(parameters->document(), names, name, job.settings_by_table[table], job)
        .read(parameters->entries(), "");
  }
}

/// A table under the name of the control, where its settings have a name of their own.
void refuseNamesake(ConfigTable& control, const std::string& table, const std::string& name) {
  if (table == name || control.find(name) == nullptr) return;
  control.error(name, "job-unknown-key",
                fmt::format("settings of control '{}' stand in [control.{}]", name, table));
}

}  // namespace

// TOML cannot hold `control = "nct"` and `[control.nct]` in one file, so a control with settings is named by
// `[control] name = "nct"`.
void readControl(ConfigTable& root, const JobNames& names, Job& job) {
  const ConfigValue* value = root.find("control");
  if (value == nullptr) {
    job.control = kAutoControl;
    return;
  }
  if (value->type != Type::kTable) {
    readControlName(root, "control", names, job);
    return;
  }
  auto control = root.table("control");
  readControlName(*control, "name", names, job);
  if (job.control.empty()) return;
  if (job.control == kAutoControl) {
    readSettingsOfAll(*control, names, job);
  } else {
    const std::string table = settingsTableOf(names, job.control);
    if (auto parameters = control->table(table)) readParameters(*parameters, names, job);
    refuseNamesake(*control, table, job.control);
  }
  control->refuseOthers();
}

void readParameters(ConfigTable& table, const JobNames& names, Job& job) {
  ParameterReader(table.document(), names, job.control, job.settings.parameters, job)
      .read(table.entries(), "");
}

}  // namespace proveout
