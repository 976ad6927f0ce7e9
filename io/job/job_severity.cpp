// [severity] of a job file: how much findings of a kind count.
#include <fmt/format.h>

#include <algorithm>

#include "core/base/printable.h"
#include "io/job/job_sections.h"

namespace proveout {

void readSeverities(ConfigTable& root, Job& job) {
  auto table = root.table("severity");
  if (!table) return;
  const std::vector<std::string> names = {"off", "note", "warning", "error"};
  for (const ConfigEntry& entry : table->entries()) {
    const auto word = table->choice(entry.key, names);
    const auto kind = findingKindNamed(entry.key);
    if (!kind) {
      table->document().error(entry.place, "job-unknown-key",
                              fmt::format("there is no kind of finding '{}'{}", shortened(entry.key),
                                          didYouMean(nearestName(entry.key, findingKindNames()))));
      continue;
    }
    if (!word) continue;
    std::optional<Severity> severity;
    if (*word != "off")
      severity = static_cast<Severity>(std::find(names.begin(), names.end(), *word) - names.begin() - 1);
    if (isBinding(*kind) && (!severity || *severity < findingKindInfo(*kind).severity)) {
      table->document().error(
          entry.place, "job-value",
          fmt::format("{} = \"{}\" would hide that a result is missing or not whole; findings of "
                      "this kind can be made severer only than \"{}\"",
                      entry.key, *word, severityName(findingKindInfo(*kind).severity)));
      continue;
    }
    job.severities[*kind] = severity;
  }
}

}  // namespace proveout
