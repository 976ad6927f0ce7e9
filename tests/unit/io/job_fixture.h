// Jobs in a folder of their own.
#pragma once

#include <string>

#include "core/base/diagnostics.h"
#include "io/job/job.h"
#include "temp_folder.h"

namespace proveout::io_test {

inline const std::string kSmallStock = "shape = \"box\"\nmin = [0, 0, -20]\nmax = [80, 80, 0]\n";
inline const std::string kSmallJob =
    "schema = \"proveout.job/1\"\n"
    "control = \"nct\"\n"
    "program = \"bracket.nc\"\n"
    "[stock]\n" +
    kSmallStock +
    "[[tool]]\n"
    "number = 1\n"
    "type = \"flat\"\n"
    "diameter = 10\n";

inline std::string replacedOnce(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) return "nothing to replace";
  return text.replace(at, from.size(), to);
}
inline std::string withStock(const std::string& stock) {
  return replacedOnce(kSmallJob, kSmallStock, stock + "\n");
}

class JobFolder : public TempFolder {
 public:
  JobFolder() {
    write("bracket.nc", "M30\n");
    write("bracket.stl", "");
    names.controls = {"nct", "flexnc"};
    names.views = {"iso", "top"};
  }
  std::optional<Job> load(const std::string& text) {
    return loadJob(write("job.toml", text), names, diagnostics);
  }
  void clear() { diagnostics = Diagnostics(); }
  /// All diagnostics as a person sees them.
  std::string text() const {
    std::string out;
    for (const Diagnostic& d : diagnostics.all()) out += formatDiagnostic(d);
    return out;
  }
  /// What is said of a job that must be refused.
  std::string refusal(const std::string& text_of_job) {
    clear();
    return load(text_of_job) ? "accepted" : text();
  }

  JobNames names;
  Diagnostics diagnostics;
};

}  // namespace proveout::io_test
