// `[template]` of a job file: a program that is a template, and the numbers in its fields.
#include <fmt/format.h>

#include <cmath>

#include "io/atomic_file.h"
#include "io/job/job_sections.h"
#include "io/job/template_files.h"

namespace proveout {

namespace {

/// A number of TOML, or a text that is one.
std::optional<std::string> valueText(const ConfigDocument& document, const ConfigEntry& entry) {
  const ConfigValue& value = entry.value;
  if (value.type == ConfigValue::Type::kInteger) return fmt::format("{}", value.integer);
  if (value.type == ConfigValue::Type::kNumber && std::isfinite(value.number))
    return fmt::format("{:.17g}", value.number).find('e') == std::string::npos
               ? std::optional(fmt::format("{}", value.number))
               : std::optional(fmt::format("{:.12f}", value.number));
  if (value.type == ConfigValue::Type::kText) return value.text;
  document.error(value.place, "job-type",
                 fmt::format("{} must be a number, not {}", entry.key, configTypeName(value.type)));
  return std::nullopt;
}

/// What the template says of names and values, at their places in the job.
bool checkValues(ConfigTable& set, const std::string& path, TemplateUse& use) {
  const ConfigDocument& document = set.document();
  const Result<std::string> bytes = readWholeFile(path, nc::kMaxTemplateBytes);
  if (!bytes) return false;  // told where it is filled
  Diagnostics found;
  const auto text = nc::readTemplate({path, path, *bytes}, use.encoding, found);
  if (!text) return false;
  bool good = true;
  for (const ConfigEntry& entry : set.entries()) {
    set.find(entry.key);
    const auto value = valueText(document, entry);
    const std::string why = value ? nc::refusalOf(*text, entry.key, *value) : std::string();
    if (!why.empty()) document.error(entry.place, "template", why);
    good = good && value && why.empty();
    if (value) use.values[entry.key] = *value;
  }
  return good;
}

}  // namespace

void fillWithDefaults(const std::string& path, Job& job, Diagnostics& diagnostics) {
  TemplateUse use;
  use.encoding = job.settings.encoding;
  fillFile(path, use, diagnostics);
  job.settings.encoding = TextEncoding::kAuto;  // what a template is filled to is UTF-8
  job.filled = std::move(use);
}

void readTemplateUse(ConfigTable& table, Job& job) {
  if (table.find("program") != nullptr)
    table.error("program", "job-value", "give program or [template], not both");
  auto section = table.table("template");
  if (!section) return;
  const bool named = table.document().programs_in_memory;
  const auto file = named ? section->must("file").text("file") : section->must("file").path("file");
  TemplateUse use;
  use.encoding = job.settings.encoding;
  auto set = section->table("set");
  bool good = file.has_value();
  if (file && set) {
    good = checkValues(*set, *file, use) || named;
    set->refuseOthers();
  }
  section->refuseOthers();
  if (!file) return;
  job.program = *file;
  if (good && !named) fillFile(*file, use, *table.document().diagnostics);
  job.settings.encoding = TextEncoding::kAuto;  // what a template is filled to is UTF-8
  job.filled = std::move(use);
}

}  // namespace proveout
